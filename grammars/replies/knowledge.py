"""What is known about a thing."""

from __future__ import annotations

from collections.abc import Sequence

from grammars.render import definite, thing_in_words
from grammars.render.questions import claim
from grammars.render.reasons import lines, taught
from grammars.render.telling import Telling
from grammars.replies import Said, aloud, listed, renders
from kernel.memory.explanation import Knowledge
from kernel.net.graphlet import Graphlet

SPOKEN = 2  # sentences
MOST = 5  # facts in one of them


@renders(Knowledge)
def knowledge(reply: Knowledge) -> Said:
    """ "The red block is heavy. From that I conclude that it is dangerous." """
    everything = (*reply.facts, *reply.inferred)
    told = []
    if reply.facts:
        told.append(_claims(reply.facts, everything))
    if reply.inferred:
        follows = "from that I" if reply.facts else "I"
        told.append(f"{follows} conclude that {_claims(reply.inferred, everything)}")
    told += [taught(lesson) for lesson in reply.lessons]
    if not told:
        about = reply.question.about
        told = [f"I know nothing about {thing_in_words(about.main, (about,))}"]
    return Said(lines(told), aloud(lines(told[:SPOKEN])))


def _claims(facts: Sequence[Graphlet], everything: Sequence[Graphlet]) -> str:
    """Facts joined; those with the same subject share it."""
    said: dict[tuple[str, str], list[str]] = {}
    for fact in facts[:MOST]:
        alone = _without(fact, {other.main for other in everything} - {fact.main})
        clause = claim(Telling((definite(alone),), (), "robot"), alone)
        shared = clause.verb in ("is", "am", "are")
        key = (clause.subject, clause.verb if shared else "")
        said.setdefault(key, []).append(clause.asked if shared else clause.stated)
    parts = [
        f"{subject} {verb} {listed(rest)}" if verb else f"{subject} {listed(rest)}"
        for (subject, verb), rest in said.items()
    ]
    return listed(list(dict.fromkeys(parts)))


def _without(fact: Graphlet, told_apart: set[str]) -> Graphlet:
    """The fact less what is told in sentences of its own."""
    kept = [
        term
        for term in fact
        if term.name not in told_apart and not any(to in told_apart for _, to in term.links)
    ]
    return Graphlet(tuple(kept), fact.main)
