"""EDIT (ours): one lesson takes the place of another."""

from __future__ import annotations

from kernel.action.step import Run, Step, directive
from kernel.action.verdict import Verdict
from kernel.action.vetoing import vetoed


@directive("EDIT")
def edit(step: Step) -> Run:
    """Revise a lesson in one change, unless the person may not teach (as ADD); nothing is lost if it is not stored."""
    if (yield from vetoed(step)):
        return Verdict.FAILED
    return (yield from step.revise())
