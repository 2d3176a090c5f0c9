"""Conditions turned round, as brackets: what "otherwise" is said of."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.clauses import DENIALS, SENSED
from grammars.conditions import flat
from grammars.errors import NoMeaningError
from grammars.mentions import VERB_SLOTS
from grammars.pacing import HOLDING
from grammars.sorts import is_nothing

# What somebody says or is told is heard once, and is not so all the rest of the time.
ONCE: Final = (
    "quote",
    "listener",
    "whereis",
    "ordered",
    "failing",
    "all_so",
    "counted",
    "speaking",
)
SOME: Final = {"nothing": "something", "nobody": "somebody", "no one": "someone"}


def otherwise(
    lesson: AList, contrary: AList, ways: list[AList]
) -> tuple[tuple[AList, ...], tuple[AList, ...]]:
    """The parts of a lesson, and those of the one that holds where its condition is not so: "if something is close
    stop, otherwise drive forward".

    ways: its condition, once for each of its alternatives: none of them is so.
    """
    rest = tuple(part for part in lesson if part is not contrary)
    chain, conds = lesson.find("chain"), lesson.first("conds")
    if chain is None:
        raise NoMeaningError(str(lesson))
    none = AList("conds", tuple(part for way in ways for part in denied(way)))
    turned = {chain: contrary.first("chain"), conds: none}
    return rest, tuple(turned.get(part, part) for part in rest)


def denied(conds: AList) -> AList:
    """That it is not so. Of several conditions at once that is no single condition."""
    if len(conds.parts) != 1 or len(clauses := flat(conds)) != 1:
        raise NoMeaningError(str(conds))
    (clause,) = clauses
    return AList("conds", (_denied(clause),))


def _denied(clause: AList) -> AList:
    verb = next((clause.slot(slot) for slot in VERB_SLOTS if clause.has(slot)), "")
    lasting = not verb or verb in SENSED or verb in HOLDING
    if not lasting or any(clause.has(part) for part in ONCE):
        raise NoMeaningError(str(clause))
    if (exists := clause.find("exists")) is not None:
        return AList(clause.name, (_turned(exists),))
    return _turned(clause)


def _turned(said: AList) -> AList:
    """With a denial, or without the one it has."""
    if any(said.has(denial) for denial in DENIALS):
        return AList(said.name, tuple(part for part in said if part.name not in DENIALS))
    if any(is_nothing(np) for np in said.all("np", "base_np")):
        return AList(said.name, tuple(map(_some, said)))
    return AList(said.name, (*said.parts, AList("neg")))


def _some(part: AList) -> AList:
    """ "Something" for "nothing"."""
    if part.name not in ("np", "base_np") or not is_nothing(part):
        return part
    return AList(part.name, tuple(_some_word(word) for word in part))


def _some_word(word: AList) -> AList:
    if word.name == "vague":
        return AList(word.name, value=SOME.get(word.value or "", word.value))
    return AList(word.name, value="any") if word.name == "det" else word
