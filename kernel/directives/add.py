"""ADD (ours): learn a rule, an operator or a fact."""

from __future__ import annotations

from kernel.action.step import Run, Step, directive
from kernel.action.verdict import Verdict
from kernel.action.vetoing import vetoed


@directive("ADD")
def add(step: Step) -> Run:
    """Ask for the lesson to be stored and wait; it is in force, and acknowledged, only once it is durable.

    Learning is an act like others: ANTE operators on it come first, and a PUNT in one of them forbids it ("don't let
    Rick teach you"). A veto on whatever somebody tells the robot to do is no veto on learning.
    """
    if (yield from vetoed(step)):
        return Verdict.FAILED
    return (yield from step.learn())
