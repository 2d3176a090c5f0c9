"""What would you do if: a dry run."""

from __future__ import annotations

from kernel.asking import Asking, answers
from kernel.memory.explanation import Plan


@answers("would")
def would(asking: Asking) -> Plan:
    """What a command, or a fact that is noticed, would lead to."""
    question = asking.question
    found = asking.imagine(question.chain if question.chain is not None else question.about)
    return Plan(question, found.steps, found.whole_s, found.unfinished, found.trouble)
