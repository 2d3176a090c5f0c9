"""What comes behind "is": of what kind a thing is, what it is like, where it is, whose."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from grammars.morphology import article, comparative, plural
from grammars.render.names import proper
from grammars.render.qualities import degree, quality
from grammars.render.telling import Telling, linked, word
from grammars.render.things import alike, description, kind, owned, place, thing
from grammars.sorts import classes
from kernel.net.graphlet import Term


def kind_denied(telling: Telling, term: Term, name: str) -> list[Term]:
    """What a thing is that is denied to be such a one, and whose, where only the quality is denied: no "big dog"."""
    new = telling.new(term) if term.negated and linked(term, "hq") else []
    kinds = [of for of in new if ("ako", name) in of.links and not of.negated]
    return [*kinds, *(own for own in new if ("own", name) in own.links)] if len(kinds) == 1 else []


def not_such(telling: Telling, term: Term, of_kind: Term, *owns: Term) -> str:
    """The quality denied together with the kind: "not a big dog"."""
    telling.hold_back((of_kind, *owns))
    whose = "".join(thing(telling, linked(own, "of"), "possessive") for own in owns)
    noun = f"{quality(telling, term)} {kind(telling, of_kind)}"
    return _such(telling, linked(term, "hq"), whose, noun)


def _such(telling: Telling, name: str, whose: str, phrase: str, after: str = "") -> str:
    """What a thing, or several, are: "a big dog", "my brother", "twins"."""
    several = telling.several(name)
    noun = plural(phrase) if several else phrase
    own = whose or ("" if several or noun in classes()["mass"] else article(noun))
    return " ".join(filter(None, (own, noun, after)))


def _as_kind(telling: Telling, term: Term) -> str:
    name = linked(term, "ako")
    owners = [linked(own, "of") for own in telling.take(name, "own")]
    whose = thing(telling, owners[0], "possessive") if owners else ""
    more = telling.take(name, "ako")
    most = _is_most(telling, name)
    before, _, after = description(telling, name, "")
    telling.release(more)
    phrase = " ".join(filter(None, (before, kind(telling, term))))
    return _such(telling, name, whose or ("the" if most else ""), phrase, after)


def _is_most(telling: Telling, name: str) -> bool:
    """It is the most so of its kind: "the tallest boy"."""
    qualities = telling.about(name, "hq")
    return any(word(deg) == "most" for hq in qualities for deg in telling.about(hq.name, "deg"))


def as_quality(telling: Telling, term: Term) -> str:
    """What a thing is like: "very close", "taller than Mary", "as big as the ball"."""
    other = linked(term, "than")
    if other:
        return f"{degree(telling, term.name)}{comparative(word(term))} than {thing(telling, other)}"
    if linked(term, "as"):
        return alike(telling, term)
    if word(term) in classes()["weekdays"]:
        return proper(word(term))
    regards = [place(telling, about) for about in telling.take(term.name, "loc")]
    return " ".join([quality(telling, term), *regards])


COMPLEMENTS: Final[dict[str, Callable[[Telling, Term], str]]] = {
    "ako": _as_kind, "hq": as_quality, "loc": place, "own": owned,
}  # fmt: skip
