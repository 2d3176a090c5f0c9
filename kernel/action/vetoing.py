"""Whether something is forbidden before it begins: what ADD and EDIT have in common."""

from __future__ import annotations

from collections.abc import Generator

from kernel.action.step import Step
from kernel.action.verdict import Verdict


def vetoed(step: Step) -> Generator[None, None, bool]:
    """Run ANTE operators; whether one of them ended in a PUNT, which is the reason then."""
    for operator in step.operators("ANTE"):
        if (yield from step.run(operator)) is Verdict.PUNTED:
            step.explain("prohibited")
            return True
    return False
