"""STOP (ours): end what matches, let the rest go on."""

from __future__ import annotations

from kernel.action.step import Run, Step, directive
from kernel.action.verdict import Verdict


@directive("STOP")
def stop(step: Step) -> Run:
    """End every act under way that matches the pattern, whoever asked for it; there being none is no failure.

    What it is a step of is not ended by it, even where that matches. The chain it stands in goes on.
    """
    step.halt()
    return Verdict.SUCCEEDED
    yield
