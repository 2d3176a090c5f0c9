"""CHK: is it so?"""

from __future__ import annotations

from kernel.action.step import Run, Step, directive
from kernel.action.verdict import Verdict


@directive("CHK")
def chk(step: Step) -> Run:
    """Succeed if memory holds it, fail if memory denies it; else CHK operators are followed until it does either.

    Unknown after all is a verdict of its own. What an operator comes to does not matter, only what is known after it;
    a PUNT ends the search, and so does a stop.

    Source: mind.md; CHK is named but not described in Connell 2019.
    """
    truth = step.truth()
    if truth is None:
        for operator in step.operators("CHK"):
            verdict = yield from step.run(operator)
            if verdict is Verdict.STOPPED:
                return verdict
            truth = step.truth()
            if truth is not None or verdict is Verdict.PUNTED:
                break
    if truth is None:
        step.explain("not_known")
        return Verdict.UNKNOWN
    if not truth:
        step.explain("not_so")
    return Verdict.SUCCEEDED if truth else Verdict.FAILED
