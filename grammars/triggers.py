"""Deeds that trigger what is done before or after them, and what is said of their things."""

from __future__ import annotations

from typing import TYPE_CHECKING

from grammars.alist import AList
from grammars.conditions import enablement, exception
from grammars.errors import NoMeaningError
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
    return term.name not in build.claims and _is_about(term, mine)


def _is_about(term: Term, terms: list[Term]) -> bool:
    """It tells of something that these mention."""
    mentioned = {t.name for t in terms} | {other for t in terms for _, other in t.links}
    return not mentioned.isdisjoint((term.name, *(other for _, other in term.links)))


def taken_up(trigger: Graphlet, lesson: Operator) -> Graphlet:
    """With what the lesson before says of its things, as "it" does: "you may touch the vase, but never lift it"."""
    before = lesson.trigger.graphlet
    left = [term for term in before or () if before is not None and term is not before.head]
    terms = list(trigger)
    while more := [term for term in left if term not in terms and _is_about(term, terms)]:
        terms += more
    return Graphlet(tuple(terms), trigger.main)


def asks_nothing(chain: AList) -> bool:
    """ "Ask Mary", before "if she is hungry": that is what she is to be asked."""
    last = [part for part in chain.walk() if part.name == "speech"][-1:]
    return any(
        speech.has("ask") and not (speech.has("quote") or speech.has("asked_if")) for speech in last
    )


def around(build: Build, alist: AList, tag: str) -> Operator:
    """What is done before or after an act, when it is and when it is not."""
    with build.drawing(pattern=True, trigger=True):
        deed, times = by_time(build, alist.first("action", "gerunding", "did_it"))
        if deed.name == "action" and any(np.slot("pron") == "you" for np in deed.all("np")):
            raise NoMeaningError(str(deed))  # "after each block you grab"
        trigger = build.graphlet(build.action(deed))
    if alist.has("conds") and asks_nothing(alist.first("chain")):
        raise NoMeaningError("what follows is the question")
    enabled = (*times, *enablement(build, alist))
    chain = build.chain(alist.first("chain"))
    return Operator(
        Directive(tag, trigger),
        chain,
        enablement=enabled,
        unless=exception(build, alist),
        preference=preference(alist.slot("pref")),
    )
