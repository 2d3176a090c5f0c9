"""What a verdict on a deed says: praise or blame."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.errors import NoMeaningError
from grammars.vocabulary import BORN

# Brackets and slots of a verdict that are blame.
BLAMING: Final = "bad done_ill worse wrong averse upset let_down excess fault".split()


def is_praise(judged: AList) -> bool:
    """Of several verdicts in a bracket the first; the last, where one comes after "but"."""
    said = judged.all("verdict", "praise", "blame")[-1 if judged.has("but") else 0]
    if said.name != "verdict":
        return said.name == "praise"
    turned = said.has("neg") != judged.has("doubting")  # "i don't think that was bad"
    return _is_good(said) != turned


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
