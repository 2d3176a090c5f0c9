"""Feedback: praise and blame, which move preferences."""

from __future__ import annotations

from grammars.alist import AList
from grammars.registry import sentence_form
from grammars.verdicts import is_praise
from kernel.memory.meaning import Feedback

EXAMPLES = (
    "Hey, stop that!",
    "good robot",
    "Bad robot!",
    "well done",
    "i did not like that at all",
    "what a clever little machine you are",
    "that was not a very smart thing to do",
    "i like how you turned left",
    "you turned too far",
    "you carried that very carefully",
    "you dropped it again",
    "I don't think that was very clever",
)


@sentence_form("feedback", "feedback", EXAMPLES)
def feedback(alist: AList) -> Feedback:
    """Good or bad, and whether it halts what is going on."""
    if alist.has("halt_blame") or alist.has("stopping"):
        return Feedback(good=False, stop=True)
    return Feedback(is_praise(alist))
