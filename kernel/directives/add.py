"""ADD (ours): learn a rule, an operator or a fact."""

from __future__ import annotations

from kernel.action.preparing import prepared
from kernel.action.step import Run, Step, directive


@directive("ADD")
def add(step: Step) -> Run:
    """Ask for the lesson to be stored and wait; it is in force, and acknowledged, only once it is durable.

    Learning is an act like others: ANTE operators on it come first, and a PUNT in one of them forbids it ("don't let
    Rick teach you"). A veto on whatever somebody tells the robot to do is no veto on learning.
    """
    verdict = yield from prepared(step)
    return (yield from step.learn()) if verdict.ok else verdict
