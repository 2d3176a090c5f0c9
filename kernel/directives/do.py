"""DO: act. Becomes ANTE, then DO, then POST."""

from __future__ import annotations

from kernel.action.preparing import prepared
from kernel.action.step import Run, Step, directive
from kernel.action.verdict import Verdict


@directive("DO")
def do(step: Step) -> Run:
    """Prepare with every ANTE operator, act with DO operators until one succeeds, tidy up with every POST operator.

    A failing ANTE or POST operator changes nothing; a PUNT in an ANTE operator is a prohibition and fails the
    directive before anything moves. What is stopped ends with that: nothing else is tried, nothing is tidied up (ours).

    Source: Connell 2019, section 3. POST after a PUNT is not stated there; it runs only once acting was allowed.
    """
    verdict = yield from prepared(step)
    if not verdict.ok:
        return verdict

    step.set_about()
    outcome = Verdict.FAILED
    for _ in range(step.times()):
        outcome = yield from _act(step)
        if outcome is not Verdict.SUCCEEDED:
            break

    if outcome is Verdict.STOPPED:
        return outcome
    for operator in step.operators("POST"):
        if (yield from step.run(operator)) is Verdict.STOPPED:
            return Verdict.STOPPED
    return outcome


def _act(step: Step) -> Run:
    """One round of DO operators; a second one at a lower belief threshold where none applied (mind.md)."""
    tried = False
    while True:
        for operator in step.operators("DO"):
            tried = True
            verdict = yield from step.run(operator)
            if verdict in (Verdict.SUCCEEDED, Verdict.STOPPED):
                return verdict
            if verdict is Verdict.PUNTED:
                step.explain("given_up")
                return Verdict.FAILED
        if tried or not step.desperate():
            break
    if not tried:
        step.explain("no_way")
    return Verdict.FAILED
