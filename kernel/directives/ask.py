"""ASK (ours): a person asked; answer from memory, or find out first."""

from __future__ import annotations

from kernel.action.step import Run, Step, directive
from kernel.action.verdict import Verdict


@directive("ASK")
def ask(step: Step) -> Run:
    """Reply to the question. Where memory does not know, operators that may find out are followed first: CHK for yes
    or no, FIND for the others. Not knowing is an answer too."""
    if tag := step.seeking():
        for operator in step.operators(tag):
            verdict = yield from step.run(operator)
            if verdict in (Verdict.PUNTED, Verdict.STOPPED) or not step.seeking():
                break
    step.answer()
    return Verdict.SUCCEEDED
