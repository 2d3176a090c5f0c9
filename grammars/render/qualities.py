"""Qualities and degrees in words: very close, biggest, 3 meters long, made of wood."""

from __future__ import annotations

from typing import Final

from grammars.morphology import comparative, plural, superlative
from grammars.render.telling import Telling, word
from grammars.vocabulary import BORN
from kernel.net.graphlet import Term

_DEGREES: Final = {"little": "a little", "fully": "all the way"}


def degree(telling: Telling, name: str) -> str:
    """What modifies a quality, direction or manner: "very ", or nothing."""
    return "".join(_DEGREES.get(word(d), word(d)) + " " for d in telling.take(name, "deg"))


def quality(telling: Telling, term: Term) -> str:
    """A quality in words: very close, biggest, not heavy."""
    degrees = telling.take(term.name, "deg")
    if any(word(d) == "most" for d in degrees):
        return superlative(word(term))
    if any(word(d) == "more" for d in degrees):
        return comparative(word(term)) + "".join(map(_measure, telling.take(term.name, "amt")))
    amounts = telling.take(term.name, "amt")
    measures = [f"{a.literal} {word(a) if a.literal == '1' else plural(word(a))} " for a in amounts]
    more = [_DEGREES.get(word(d), word(d)) + " " for d in degrees]
    said = "".join((*measures, *more)) + word(term)
    return f"made of {said}" if is_material(term) else said


def _measure(amount: Term) -> str:
    """ "Closer than 10 inches"."""
    number, unit = amount.literal or "1", word(amount)
    return f" than {number} {unit if number == '1' else plural(unit)}"


def is_material(term: Term) -> bool:
    """What something is made of, where no adjective says so: wood, but not glass."""
    known = BORN.readings(word(term))
    return "NOUN" in known and "ADJ" not in known
