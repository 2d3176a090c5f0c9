"""EDIT (ours): one lesson takes the place of another."""

from __future__ import annotations

from kernel.action.step import Run, Step, directive
from kernel.action.verdict import Verdict


@directive("EDIT")
def edit(step: Step) -> Run:
    """Revise a lesson in one change, unless the person may not teach (as ADD); nothing is lost if it is not stored."""
    for operator in step.operators("ANTE"):
        if (yield from step.run(operator)) is Verdict.PUNTED:
            step.explain("prohibited")
            return Verdict.FAILED
    return (yield from step.revise())
