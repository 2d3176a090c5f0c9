"""The grammar as text: top level, phrases, and the files of the forms, with the terminals they may use."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import cache
from hashlib import sha256
from importlib.resources import files
from typing import Any, Final

from grammars.registry import discover
from grammars.vocabulary import set_phrases

CATEGORIES: Final = (
    "VERB VERBS VERBING VERBED GIVE MOTION SIDE STATE STATES NOUN NOUNS ADJ ADJER ADJEST ADV DEG DIR PROPER PLACE NUM"
    " UNIT PERSON PREP ORD QUOTED ANYWORD NAMELIKE NEWING OPENWORD STRANGE NEWNAME UNK UNKNAME UNKADJ _COMMA"
).split()
# What it costs to take a word as something else than it is known to be; a set phrase is a little better than its words.
TERMINAL_COST: Final[dict[str, int]] = {
    "ANYWORD": 2,
    "OPENWORD": 1,
    "NAMELIKE": 2,
    "STRANGE": 3,
    "NEWNAME": 3,
    "UNK": 10,
    "UNKNAME": 10,
    "UNKADJ": 10,
}
SET_PHRASE_COST: Final = -1


@cache
def set_categories() -> frozenset[str]:
    """Categories of set phrases."""
    return frozenset(set_phrases())


def terminal_cost(terminal: str) -> int:
    """Cost of reading a word as this terminal."""
    return SET_PHRASE_COST if terminal in set_categories() else TERMINAL_COST.get(terminal, 0)


@cache
def grammar_text() -> str:
    """The whole grammar."""
    names = sorted(discover())
    folder = files("grammars")
    shared = ("toplevel.lark", "phrase.lark", "called_out.lark")
    parts = [folder.joinpath(name).read_text("utf8") for name in shared]
    parts += [folder.joinpath("forms", f"{name}.lark").read_text("utf8") for name in names]
    for symbol, expected in (("_form", False), ("_answer", True)):
        of_these = [name for name in names if discover()[name].expected is expected]
        parts.append(f"{symbol}: {' | '.join(of_these)}")
    # Declared alone, GOOD would be the name lark gives the word "good" where a rule has it written out.
    parts += (f"{name}: /{name}/" for name in (*CATEGORIES, *sorted(set_categories())))
    return "\n".join(parts)


def digest(text: str) -> str:
    """Tells one source from another."""
    return sha256(text.encode()).hexdigest()


def kept(name: str, source: str, make: Callable[[], dict[str, Any]]) -> dict[str, Any]:
    """What was compiled ahead of time into that file, if it was made of the source with this digest, else made now."""
    file = files("grammars").joinpath(name)
    data: dict[str, Any] = json.loads(file.read_text("utf8")) if file.is_file() else {}
    return data if data.get("source") == source else make()
