"""Qualities and degrees in words: very close, biggest, 3 meters long, made of wood."""

from __future__ import annotations

from typing import Final

from grammars.morphology import comparative, plural, superlative
from grammars.pacing import TIMES
from grammars.render.telling import Telling, word
from grammars.vocabulary import BORN
from kernel.net.graphlet import Term

BOUNDED: Final = {">": "over ", "<": "under "}
_DEGREES: Final = {"little": "a little", "fully": "all the way"}


def degree(telling: Telling, name: str) -> str:
    """What modifies a quality, direction or manner: "very ", or nothing."""
    return "".join(map(_degree, telling.take(name, "deg")))


def _degree(term: Term) -> str:
    return _DEGREES.get(word(term), word(term)) + " "


def measured(number: str, unit: str) -> str:
    """ "1 inch", "10 inches"."""
    one, _, per = unit.partition(" ")  # "inch per second"
    return " ".join(filter(None, (number, one if number == "1" else plural(one), per)))


def much(amount: Term) -> str:
    """ "5 pounds"; "over 5 pounds"."""
    number, bound = amount.literal or "1", ""
    if number[:1] in BOUNDED:
        bound, number = BOUNDED[number[:1]], number[1:].strip()
    return f"{bound}{measured(number, word(amount))}"


def quality(telling: Telling, term: Term) -> str:
    """A quality in words: very close, biggest, not heavy."""
    degrees = telling.take(term.name, "deg")
    if any(word(d) == "most" for d in degrees):
        return superlative(word(term))
    taken = telling.take(term.name, "amt")
    lasting = [amt for amt in taken if word(amt) in TIMES]  # "stuck for a minute"
    amounts = [measured(amt.literal or "1", word(amt)) for amt in taken if amt not in lasting]
    while_ = "".join(f" for {measured(amt.literal or '1', word(amt))}" for amt in lasting)
    if any(word(d) == "more" for d in degrees):  # "closer than 10 inches"
        return comparative(word(term)) + "".join(f" than {amount}" for amount in amounts)
    said = " ".join((*amounts, "".join(map(_degree, degrees)) + word(term)))
    return f"made of {said}" if is_material(term) else said + while_


def is_material(term: Term) -> bool:
    """What something is made of, where no adjective says so: wood, but not glass."""
    known = BORN.readings(word(term))
    return "NOUN" in known and "ADJ" not in known
