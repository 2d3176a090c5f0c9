"""ADD (ours): learn a rule or operator."""

from __future__ import annotations

from kernel.action.step import Run, Step, directive


@directive("ADD")
def add(step: Step) -> Run:
    """Ask for the lesson to be stored and wait; it is in force, and acknowledged, only once it is durable."""
    return (yield from step.learn())
