"""What a verdict on a deed says: praise or blame."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.errors import NoMeaningError
from grammars.mentions import US
from grammars.sorts import classes, is_abstract, is_people, kind, persons_own
from grammars.vocabulary import BORN

# Brackets and slots of a verdict that are blame.
BLAMING: Final = (
    "bad done_ill worse wrong averse upset let_down excess fault rough ill_deed".split()
)
OURS: Final = ("my", "our")
AGAINST: Final = ("into", "against")  # where nobody drives who means well


def is_praise(judged: AList) -> bool:
    """Of several verdicts in a bracket the first; the last, where one comes after "but"."""
    said = judged.all("verdict", "praise", "blame")[-1 if judged.has("but") else 0]
    if said.name != "verdict":
        return said.name == "praise"
    fault = said.find("fault")
    if fault is not None and fault.has("harm") and not _is_harm(fault.first("harm")):
        raise NoMeaningError(str(said))
    if fault is not None and any(map(_is_no_thing, fault.all("np"))):
        raise NoMeaningError("you dropped a hint")
    performed = said.find("performed")
    if performed is not None and performed.slot("act") in classes()["shows"]:
        raise NoMeaningError("the show was great")
    turned = said.has("neg") != judged.has("doubting")  # "i don't think that was bad"
    return _is_good(said) != turned


def _is_no_thing(np: AList) -> bool:
    """What nobody drops or breaks, but in a manner of speaking; what is forgotten among persons."""
    return is_abstract(np) or kind(np) in classes()["occasions"]


def _is_good(verdict: AList) -> bool:
    """What the words say, before "not" turns it."""
    if verdict.has("could_be"):
        than_this = BORN.readings(verdict.slot("adjer"))
        return verdict.has("worse") or "bad" in than_this.values() or "BAD" in than_this
    if (finest := verdict.find("finest")) is None:
        return not any(verdict.has(part) for part in BLAMING)
    peaks = (part.value or "" for part in finest.walk() if part.name in ("most", "hq"))
    known = BORN.readings(next(peaks, "good"))
    if not known.keys() & {"GOOD", "BAD"}:
        raise NoMeaningError(str(verdict))
    return "GOOD" in known


def _is_harm(harm: AList) -> bool:
    """ "You drove over my foot", "you pushed me", "you drove into the wall": done to somebody, or against something."""
    deed = harm.first("did_it")
    if (deed.value or deed.slot("act")) not in classes()["harming"]:
        return False
    places = [loc for place in deed.all("place") for loc in place.all("loc")]
    struck = [np for loc in places if loc.slot("prep") in AGAINST for np in loc.all("np")]
    hurt = [*deed.all("np"), *(np for loc in places for np in loc.all("np"))]
    return any(map(_is_ours, hurt)) or any(map(_is_wall, struck))


def _is_ours(np: AList) -> bool:
    """One of us, or a part of one: "me", "my toes", "the dog"."""
    if np.slot("pron") in US or kind(np) in classes()["animals"] or is_people(np) or np.has("name"):
        return True
    return np.slot("own") in OURS and kind(np) in persons_own()


def _is_wall(np: AList) -> bool:
    """Something that one does not drive into, as into a room."""
    return kind(np) not in classes()["rooms"] and not np.has("pron")
