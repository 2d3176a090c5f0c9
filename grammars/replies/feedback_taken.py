"""Praise and blame."""

from __future__ import annotations

from grammars.replies import Said, both, renders
from kernel.memory.reply import FeedbackTaken


@renders(FeedbackTaken)
def feedback_taken(reply: FeedbackTaken) -> Said:
    """ "Thank you." """
    if reply.good:
        return both("thank you")
    return both("I will do that less often" if reply.lesson is not None else "I am sorry")
