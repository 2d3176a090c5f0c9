"""Feedback: praise and blame, which move preferences."""

from __future__ import annotations

from grammars.alist import AList
from grammars.build import NoMeaningError
from grammars.registry import sentence_form
from grammars.vocabulary import BORN
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
    if alist.has("halting_blame"):
        return Feedback(good=False, stop=True)
    said = alist.first("verdict", "praise", "blame")
    if said.name != "verdict":
        return Feedback(said.name == "praise")
    turned = said.has("neg") != alist.has("doubt")  # "i don't think that was bad"
    return Feedback(_is_good(said) != turned)


def _is_good(verdict: AList) -> bool:
    """What the words say, before "not" turns it."""
    if (finest := verdict.find("finest")) is None:
        return not verdict.has("bad")
    peaks = (part.value or "" for part in finest.walk() if part.name in ("most", "hq"))
    known = BORN.readings(next(peaks, "good"))
    if not known.keys() & {"GOOD", "BAD"}:
        raise NoMeaningError(str(verdict))
    return "GOOD" in known
