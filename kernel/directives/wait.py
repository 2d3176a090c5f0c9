"""WAIT (ours): nothing, until something is so."""

from __future__ import annotations

from kernel.action.step import Run, Step, directive
from kernel.action.verdict import Verdict


@directive("WAIT")
def wait(step: Step) -> Run:
    """Succeed as soon as it is so, at once where it is so already; nothing is done about it, and it never fails."""
    while not step.is_so():
        step.waits("condition")
        yield
    return Verdict.SUCCEEDED
