"""What a person means: whether an act that was done is the one asked about, and which known things are spoken of.

It is lenient, as answers are: near words count as the same. How lessons compare (equal, contradicting), where nothing
may be guessed, is kernel.memory.likeness.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Final

from kernel.memory.recall import THINGS
from kernel.memory.working import WorkingMemory
from kernel.net.graphlet import Graphlet, Term
from kernel.net.match import Binding, holds, matches
from kernel.net.node import REMEMBERED, WORKING, Net, instantiate

# Words that the grounding functions take for the same: a person who says "move" may mean what was done as "drive".
SAME: Final = tuple(
    frozenset(words)
    for words in (
        ("drive", "move", "go", "step", "roll"),
        ("turn", "rotate", "spin"),
        ("raise", "lift"),
        ("grab", "grip", "grasp"),
        ("release", "let go", "drop"),
        ("wait", "pause", "rest"),
        ("forward", "ahead", "straight"),
        ("backward", "back"),
        ("left", "counterclockwise"),
        ("right", "clockwise"),
    )
)
_ONE_FOR_ALL: Final = {word: min(words) for words in SAME for word in words}
_REFERRING: Final = frozenset(("the", "that", "this"))


def is_like(asked: Graphlet, done: Graphlet) -> bool:
    """Whether the act asked about is the act that was done, or a less exact description of it.

    Polarity, who acts and pronouns are not looked at; an act without a word is any act.
    """
    if not verb(asked) <= verb(done):
        return False
    pattern, other = _plain(asked), _plain(done)
    net = Net()
    bound = instantiate(net, other, {})
    return holds(pattern, net, WORKING, {pattern.main: bound[other.main]}, 0.0)


def verb(act: Graphlet) -> frozenset[str]:
    """What an act is called, by the word that stands for its like; empty for any act."""
    words = act.head.lex if act.head is not None else ()
    return frozenset(_ONE_FOR_ALL.get(word, word) for word in words)


def synonyms(verbs: frozenset[str]) -> frozenset[str]:
    """Every word that these stand for."""
    return verbs | {word for word, one in _ONE_FOR_ALL.items() if one in verbs}


def _plain(act: Graphlet) -> Graphlet:
    """Without agent, polarity, belief and reference; every word by the one that stands for its like."""
    links = act.head.links if act.head is not None else ()
    agents = {other for role, other in links if role == "agt"}
    terms = []
    for term in act:
        if term.name in agents and term.lex & {"you"}:
            continue
        links = tuple(
            link for link in term.links if link != ("agt", link[1]) or term.name != act.main
        )
        said = term.literal.lower().strip(" .,!?") if term.literal is not None else None
        words = frozenset(_ONE_FOR_ALL.get(word, word) for word in term.lex)
        terms.append(Term(term.name, words, said, links=links))
    return Graphlet(tuple(terms), act.main)


def grounded(described: Graphlet, memory: WorkingMemory) -> Binding:
    """The persons and things that a net speaks of as known ("Mary", "the block"), bound to the newest that fit."""
    binding = memory.persons(described, {})
    for name in sorted(described.mentioned - {described.main}):
        said = description(described, name)
        main = said.head or Term(name)
        known = bool(main.lex) or (main.ref in _REFERRING and len(said.terms) > 1)
        if name in binding or not known:
            continue
        start = {n: node for n, node in binding.items() if n in said.mentioned}
        found = [
            match[name]
            for match in matches(said, memory.net, REMEMBERED, start)
            if match[name].kind in THINGS
        ]
        if found:
            binding[name] = max(found, key=lambda node: node.stamp)
    return binding


def description(graphlet: Graphlet, name: str) -> Graphlet:
    """What of a net describes the thing of that name."""
    about = [name]
    for _ in range(2):  # its kind, and what modifies that
        about += [
            term.name
            for term in graphlet
            if term.name not in (*about, graphlet.main)
            and term.kind != "act"
            and any(other in about for _, other in term.links)
        ]
    return Graphlet(tuple(term for term in graphlet if term.name in about), name)


def together(graphlet: Graphlet) -> Graphlet:
    """What hangs together with the main term of a net, be it only through the robot or the speaker: what was so on the
    occasion that a question names besides does not."""
    found, left = {graphlet.main}, list(graphlet)
    while True:
        linked = {other for term in left if term.name in found for _, other in term.links}
        more = [t for t in left if t.name in found | linked or _said_of(t, found)]
        if not more:
            return Graphlet(tuple(term for term in graphlet if term.name in found), graphlet.main)
        found |= {term.name for term in more} | linked
        left = [term for term in left if term not in more]


def _said_of(term: Term, found: set[str]) -> bool:
    return term.kind != "act" and any(other in found for _, other in term.links)


def affirmed(graphlet: Graphlet) -> Graphlet:
    """The same with its main term not denied."""
    return Graphlet(
        tuple(replace(t, negated=False) if t.name == graphlet.main else t for t in graphlet),
        graphlet.main,
    )


def words_alike(one: Iterable[str], other: Iterable[str]) -> bool:
    """The same words, whatever stands for them."""
    return {_ONE_FOR_ALL.get(w, w) for w in one} == {_ONE_FOR_ALL.get(w, w) for w in other}
