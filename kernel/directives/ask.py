"""ASK (ours): a person asked; answer from memory."""

from __future__ import annotations

from kernel.action.step import Run, Step, directive
from kernel.action.verdict import Verdict


@directive("ASK")
def ask(step: Step) -> Run:
    """Reply to the question; not knowing is an answer too."""
    step.answer()
    return Verdict.SUCCEEDED
    yield
