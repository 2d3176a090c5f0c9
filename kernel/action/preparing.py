"""What comes before an act begins, before learning as before moving: its ANTE operators."""

from __future__ import annotations

from kernel.action.step import Run, Step
from kernel.action.verdict import Verdict


def prepared(step: Step) -> Run:
    """Run every ANTE operator, failing ones too. A PUNT in one is a prohibition: fails; what is stopped is stopped."""
    for operator in step.operators("ANTE"):
        verdict = yield from step.run(operator)
        if verdict is Verdict.PUNTED:
            step.explain("prohibited")
            return Verdict.FAILED
        if verdict is Verdict.STOPPED:
            return verdict
    return Verdict.SUCCEEDED
