"""CHK: is it so?"""

from __future__ import annotations

from kernel.action.step import Run, Step, directive
from kernel.action.verdict import Verdict


@directive("CHK")
def chk(step: Step) -> Run:
    """Succeed if memory holds it, fail if memory denies it; unknown is a verdict of its own.

    Source: mind.md; CHK is named but not described in Connell 2019.
    """
    truth = step.truth()
    if truth is None:
        return Verdict.UNKNOWN
    return Verdict.SUCCEEDED if truth else Verdict.FAILED
    yield
