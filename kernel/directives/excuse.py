"""EXCUSE (ours): the robot explains in its own words why it failed."""

from __future__ import annotations

from kernel.action.step import Run, Step, directive
from kernel.action.verdict import Verdict


@directive("EXCUSE")
def excuse(step: Step) -> Run:
    """Reply with the explanation of the failure that this focus notes; fails where it notes none.

    The robot is born with the advice NOTE[fail] -> EXCUSE[]; a person may teach it better manners.
    """
    return Verdict.SUCCEEDED if step.excuse() else Verdict.FAILED
    yield
