"""How something is done, as people say it, and what only stands there by chance."""

from __future__ import annotations

from itertools import takewhile
from typing import Final

from grammars.alist import AList
from grammars.sorts import classes, is_bare, usages
from grammars.vocabulary import BORN

MOST_MANNERS: Final = 2
WIDTHS: Final = frozenset(("wide", "high", "low"))


def is_odd_manner(action: AList, obj: AList | None) -> bool:
    """Nobody says so how: "hard make books", "quicker face arm", "water the shed wider"."""
    said = action.all("manner")
    if len(said) > MOST_MANNERS or len(said) > len(set(map(str, said))):
        return True
    before = takewhile(lambda part: part.name not in ("act", "speech"), action.parts)
    first = [how for how in map(_how, before) if "ADJ" in BORN.readings(how)]
    if not classes()["urged"].issuperset(first) or (first and obj is not None and is_bare(obj)):
        return True
    hows = set(map(_how, said))
    if hows & classes()["swift"] and hows & classes()["unhurried"]:
        return True
    wider = bool(hows & WIDTHS) or action.slot("size").endswith("wider")
    uses = usages(action.slot("act"))
    return wider and not uses.isdisjoint(("still", "steering")) and "widened" not in uses


def _how(manner: AList) -> str:
    """The adverb of a manner; of "faster" it is "fast"."""
    said = manner.find("faster") or manner
    return said.slot("adv") or (said.value if said is not manner else "") or ""


def is_untimely(action: AList, uses: frozenset[str]) -> bool:
    """ "See it slower", "stop faster": what is done all or not at all takes no time."""
    at_once = not uses.isdisjoint(("sensing", "halting"))
    return at_once and any(m.has("faster") for m in action.all("manner"))
