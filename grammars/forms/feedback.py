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
    "what a clever little machine you are",
    "that was not a very smart thing to do",
    "i like how you turned left",
    "you turned too far",
)


@sentence_form("feedback", "feedback", EXAMPLES)
def feedback(alist: AList) -> Feedback:
    """Good or bad, and whether it halts what is going on."""
    verdict = alist.find("verdict")
    if verdict is not None:
        return Feedback(verdict.has("bad") == verdict.has("neg"))
    return Feedback(alist.has("praise"), stop=alist.has("halting_blame"))
