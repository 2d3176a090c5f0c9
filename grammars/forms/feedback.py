"""Feedback: praise and blame, which move preferences."""

from __future__ import annotations

from typing import Final

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
# What of a verdict is blame.
BLAMING: Final = "bad done_ill worse wrong averse upset let_down excess fault".split()


@sentence_form("feedback", "feedback", EXAMPLES)
def feedback(alist: AList) -> Feedback:
    """Good or bad, and whether it halts what is going on."""
    if alist.has("halt_blame") or alist.has("stopping"):
        return Feedback(good=False, stop=True)
    said = alist.all("verdict", "praise", "blame")[-1 if alist.has("but") else 0]
    if said.name != "verdict":
        return Feedback(said.name == "praise")
    turned = said.has("neg") != alist.has("doubting")  # "i don't think that was bad"
    return Feedback(_is_good(said) != turned)


def _is_good(verdict: AList) -> bool:
    """What the words say, before "not" turns it."""
    if verdict.has("could_be"):
        return verdict.has("worse")
    if (finest := verdict.find("finest")) is None:
        return not any(verdict.has(part) for part in BLAMING)
    peaks = (part.value or "" for part in finest.walk() if part.name in ("most", "hq"))
    known = BORN.readings(next(peaks, "good"))
    if not known.keys() & {"GOOD", "BAD"}:
        raise NoMeaningError(str(verdict))
    return "GOOD" in known
