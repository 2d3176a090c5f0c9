"""EDIT (ours): one lesson takes the place of another."""

from __future__ import annotations

from kernel.action.preparing import prepared
from kernel.action.step import Run, Step, directive


@directive("EDIT")
def edit(step: Step) -> Run:
    """Revise a lesson in one change, unless the person may not teach (as ADD); nothing is lost if it is not stored."""
    verdict = yield from prepared(step)
    return (yield from step.revise()) if verdict.ok else verdict
