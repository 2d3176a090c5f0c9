"""Deeds that trigger what is done before or after them, and what is said of their things."""

from __future__ import annotations

from typing import TYPE_CHECKING

from grammars.alist import AList
from grammars.clauses import enablement, exception
from grammars.hedges import preference
from grammars.timing import by_time
from kernel.action.chain import Directive
from kernel.memory.lesson import Operator
from kernel.net.graphlet import Graphlet, Term

if TYPE_CHECKING:
    from grammars.build import Build


def settled(
    build: Build, trigger: Graphlet, conditions: tuple[Graphlet, ...]
) -> tuple[Graphlet, tuple[Graphlet, ...]]:
    """What describes the trigger's own things is the trigger's, whichever was said first: "if the cat is hurt you may
    lift it" is "you may lift the cat if it is hurt"."""
    mine, left = list(trigger), [list(graphlet) for graphlet in conditions]
    for terms in left:
        while found := [term for term in terms if _describes(build, term, mine)]:
            mine += found
            terms[:] = [term for term in terms if term not in found]
    kept = tuple(Graphlet(tuple(t), g.main) for t, g in zip(left, conditions, strict=True))
    return Graphlet(tuple(mine), trigger.main), kept


def _describes(build: Build, term: Term, mine: list[Term]) -> bool:
    """It is no claim of its own, and about something that these terms mention."""
    mentioned = {t.name for t in mine} | {other for t in mine for _, other in t.links}
    about = {term.name, *(other for _, other in term.links)}
    return term.name not in build.claims and not about.isdisjoint(mentioned)


def around(build: Build, alist: AList, tag: str) -> Operator:
    """What is done before or after an act, when it is and when it is not."""
    with build.drawing(pattern=True, trigger=True):
        deed, times = by_time(build, alist.first("action", "gerunding", "did_it"))
        trigger = build.graphlet(build.action(deed))
    enabled = (*times, *enablement(build, alist))
    chain = build.chain(alist.first("chain"))
    return Operator(
        Directive(tag, trigger),
        chain,
        enablement=enabled,
        unless=exception(build, alist),
        preference=preference(alist.slot("pref")),
    )
