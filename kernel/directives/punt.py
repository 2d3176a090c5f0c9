"""PUNT: give up this chain."""

from __future__ import annotations

from kernel.action.step import Run, Step, directive
from kernel.action.verdict import Verdict


@directive("PUNT")
def punt(step: Step) -> Run:
    """Fail the current chain at once; what posted the chain backtracks.

    Source: Connell 2019, section 4.
    """
    return Verdict.PUNTED
    yield
