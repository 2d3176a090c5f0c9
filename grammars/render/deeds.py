"""Verb phrases: actions as orders, infinitives, gerunds and statements, with all that modifies them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, Literal

from grammars.morphology import gerund, past, plural, third_person
from grammars.render.telling import Telling, linked, word
from grammars.render.things import degree, literally, place, thing
from kernel.net.graphlet import Term

VerbForm = Literal["base", "gerund", "third", "past"]

# Each inflects the first word of a phrase.
_FORMS: Final[dict[VerbForm, Callable[[str], str]]] = {
    "base": str, "gerund": gerund, "third": third_person, "past": past,
}  # fmt: skip
_UNITS_OF_TIME: Final = ("second", "minute", "hour")
_WAITING: Final = ("wait", "pause", "rest")
_GOING: Final = ("go", "drive", "move", "step", "roll", "run", "walk", "come", "climb")
_TELLING: Final = ("tell", "ask")
_GIVING: Final = ("show", "give", "bring", "teach", *_TELLING)
_SIZES: Final = {
    "little": "a little",
    "fully": "all the way",
    "much": "a lot",
    "half": "halfway",
    "more": "further",
}
# Directions said before what they lead past: "go out the door".
_LEADING: Final = ("out", "in", "inside", "off", "over", "down", "up")
_COUNTS: Final = {"1": "once", "2": "twice"}
_KNOWN_ROLES: Final = ("agt", "obj", "dest", "cmd")


def be(subject: str) -> str:
    """The form of "be" that agrees with a subject."""
    return {"I": "am", "you": "are", "they": "are", "we": "are"}.get(subject, "is")


def deed(telling: Telling, name: str, form: VerbForm = "base") -> str:
    """The action as a verb phrase: "drive forward 10 inches slowly", "turning left twice"."""
    term = telling.term(name)
    telling.stated.add(name)
    words = [word(term) or "do something", *_arguments(telling, term), *_modifiers(telling, term)]
    return _FORMS[form](" ".join(words))


def _arguments(telling: Telling, term: Term) -> list[str]:
    obj, dest, cmd = (linked(term, role) for role in ("obj", "dest", "cmd"))
    parts = []
    spoken = telling.term(obj).literal if obj else None
    what = literally(spoken) if spoken is not None else thing(telling, obj) if obj else ""
    if dest and word(term) in _GIVING:
        parts += [thing(telling, dest), what]
    else:
        ways = _directions(telling, term)
        leading = [way for way in ways if what and word(term) in _GOING and way in _LEADING]
        parts += [*leading, what, *(way for way in ways if way not in leading)]
        parts += [f"to {thing(telling, dest)}" if dest else ""]
    if cmd:
        parts.append(("to " if word(term) in _GIVING else "") + deed(telling, cmd))
    for role, other in term.links:
        if role not in _KNOWN_ROLES:
            parts.append(f"{role} {thing(telling, other)}")
    return [part for part in parts if part]


def _directions(telling: Telling, term: Term) -> list[str]:
    return [degree(telling, way.name) + word(way) for way in telling.take(term.name, "dir")]


def _modifiers(telling: Telling, term: Term) -> list[str]:
    """Place, amount, degree, manner and count, in this order."""
    name, verb = term.name, word(term)
    places = [place(telling, where) for where in telling.take(name, "loc")]
    amounts = [_amount(amount, verb) for amount in telling.take(name, "amt")]
    degrees = [_SIZES.get(word(size), word(size)) for size in telling.take(name, "deg")]
    manners = [degree(telling, how.name) + word(how) for how in telling.take(name, "mod")]
    counts = [
        _COUNTS.get(count.literal or "", f"{count.literal} times")
        for count in telling.take(name, "cnt")
    ]
    return [part for part in (*places, *amounts, *degrees, *manners, *counts) if part]


def _amount(term: Term, verb: str) -> str:
    unit = word(term)
    number = term.literal or "1"
    lasting = unit in _UNITS_OF_TIME and verb not in _WAITING
    return f"{'for ' if lasting else ''}{number} {unit if number == '1' else plural(unit)}"
