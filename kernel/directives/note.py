"""NOTE: something is so; react."""

from __future__ import annotations

from kernel.action.step import Run, Step, directive
from kernel.action.verdict import Verdict


@directive("NOTE")
def note(step: Step) -> Run:
    """Try NOTE operators until one succeeds; having none, or none that succeeds, is no failure. A PUNT ends it.

    Source: Connell 2019, section 3: "If no operators remain, the top-level NOTE is still considered to have
    succeeded."
    """
    for operator in step.operators("NOTE"):
        verdict = yield from step.run(operator)
        if verdict in (Verdict.PUNTED, Verdict.STOPPED):
            return verdict
        if verdict.ok:
            break
    return Verdict.SUCCEEDED
