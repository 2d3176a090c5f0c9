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
OTHERS: Final = SOME | {some: none for none, some in SOME.items()}


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
    subject = next(iter(said.all("np", "base_np")), None)
    if subject is not None and (turned := _other(subject)) is not subject:
        return AList(said.name, tuple(turned if part is subject else part for part in said))
    return AList(said.name, (*said.parts, AList("neg")))


def _other(np: AList) -> AList:
    """ "Nothing" for "something", "a block" for "no block"; what is said of nothing that there may be is itself."""
    if (vague := np.slot("vague")) in OTHERS:
        word = AList("vague", value=OTHERS[vague])
    elif is_nothing(np):
        word = AList("det", value="any")
    elif np.slot("det") in ("a", "an"):
        word = AList("det", value="no")
    else:
        return np
    return AList(np.name, tuple(word if part.name == word.name else part for part in np))
