"""Bringing about that something is so: what ACH and KEEP have in common."""

from __future__ import annotations

from kernel.action.step import Run, Step
from kernel.action.verdict import Verdict


def achieve(step: Step) -> Run:
    """ACH operators in turn, by weight, until the condition is so, even in the middle of one.

    One that succeeds and leaves the condition as it was is followed by the next. Fails when none is left, when none
    applies, and when one punts.
    """
    for operator in step.operators("ACH"):
        verdict = yield from step.pursue(operator)
        if step.is_so():
            return Verdict.SUCCEEDED
        if verdict is Verdict.STOPPED:
            return verdict
        if verdict is Verdict.PUNTED:
            break
    return Verdict.FAILED
