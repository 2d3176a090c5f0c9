"""How a thing is called: by its name, by a pronoun, spoken of again by what it was called first."""

from __future__ import annotations

from typing import Final, Literal

from grammars.render.telling import Telling, word
from grammars.sorts import classes
from kernel.memory.recall import PERSONS
from kernel.net.graphlet import Term

Case = Literal["subject", "object", "possessive"]

CASES: Final[tuple[Case, ...]] = ("subject", "object", "possessive")
PRONOUNS: Final = {
    "you": ("you", "you", "your"),
    "me": ("I", "me", "my"),
    "it": ("it", "it", "its"),
    "he": ("he", "him", "his"),
    "she": ("she", "her", "her"),
    "they": ("they", "them", "their"),
    "we": ("we", "us", "our"),
    "that": ("that", "that", "its"),
    "this": ("this", "this", "its"),
}
POINTING: Final = ("this", "that")


def pronoun(telling: Telling, person: str, case: Case) -> str:
    """You and me in the voice's own view."""
    if telling.voice == "robot":
        person = {"you": "me", "me": "you"}[person]
    return PRONOUNS[person][CASES.index(case)]


def proper(name: str) -> str:
    """A name as it is written; that of a day is "today"."""
    if name in classes()["days"]:
        return name
    return " ".join(part[:1].upper() + part[1:] for part in name.split(" "))


def literally(text: str) -> str:
    """Quoted speech between quotation marks."""
    return '"' + text.replace('"', "'") + '"'


def again(telling: Telling, term: Term) -> str:
    """As the parser takes it up: "it" is the only thing mentioned, "the block" the last one called a block."""
    name, noun = term.name, telling.mentioned[term.name]
    if len(telling.mentioned) == 1 and is_personal(telling, name):
        return "they"
    same = [other for other, called in telling.mentioned.items() if called == noun]
    things = [other for other in telling.mentioned if not is_personal(telling, other)]
    if things == [name] or (not term.lex and (not noun or name != same[-1])):
        return "it" if not is_personal(telling, name) else "they"
    return proper(word(term)) if term.lex else f"the {noun}"


def is_personal(telling: Telling, name: str) -> bool:
    """It has a name of its own or is a person, so that it is never "it"."""
    term = telling.term(name)
    return bool(term.lex) or term.ref == "somebody" or telling.mentioned.get(name, "") in PERSONS
