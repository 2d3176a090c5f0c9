"""ACH: make it so."""

from __future__ import annotations

from kernel.action.achieving import achieve
from kernel.action.step import Run, Step, directive
from kernel.action.verdict import Verdict


@directive("ACH")
def ach(step: Step) -> Run:
    """Already so: succeed. Else try ACH operators until it is so; fail when none is left.

    Source: mind.md; ACH is named but not described in Connell 2019.
    """
    if step.is_so():
        return Verdict.SUCCEEDED
    verdict = yield from achieve(step)
    if verdict is Verdict.FAILED:
        step.explain("not_achieved")
    return verdict
