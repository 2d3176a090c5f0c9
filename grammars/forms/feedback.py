"""Feedback: praise and blame, which move preferences."""

from __future__ import annotations

from grammars.alist import AList
from grammars.registry import sentence_form
from kernel.memory.meaning import Feedback

EXAMPLES = (
    "Hey, stop that!",
    "good robot",
    "Bad robot!",
    "well done",
    "i did not like that at all",
)


@sentence_form("feedback", "feedback", EXAMPLES)
def feedback(alist: AList) -> Feedback:
    """Good or bad, and whether it halts what is going on."""
    return Feedback(alist.has("praise"), stop=alist.has("halting_blame"))
