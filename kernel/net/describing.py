"""Nodes as graphlets: what is known of one, for explaining and for asking."""

from __future__ import annotations

from collections.abc import Container

from kernel.net.graphlet import Graphlet, Term
from kernel.net.node import BAND_2, HYPOTHETICAL, MODIFIER_ROLES, Node


def descriptions(node: Node) -> list[Node]:
    """Predicates that say which thing it is. The state that a part of the robot's own is in is none of them."""
    part = any(role == "own" and any("you" in o.lex for o in p.to("of")) for role, p in node.into)
    return [
        predicate
        for role, predicate in node.into
        if role in MODIFIER_ROLES
        and predicate.level != HYPOTHETICAL
        and not (part and role == "hq")
    ]


def describe(
    node: Node,
    limit: int = 40,
    depth: int = BAND_2,
    concluded: bool = False,
    told_only: bool = False,
    news: Container[Node] = (),
) -> Graphlet:
    """What is known of a node, as a graphlet: itself, what it points to, and what modifies any of these.

    Args:
        node: the main one.
        limit: the most nodes to take.
        depth: level up to which what modifies them is taken.
        concluded: with the words that rules conclude of each now.
        told_only: without what modifies it by a rule's conclusion.
        news: qualities that were told of a thing rather than said to tell which one it is; left out.
    """
    terms: dict[Node, Term] = {}
    pending = [node]
    while pending and len(terms) < limit:
        here = pending.pop(0)
        if here in terms:
            continue
        links = tuple(sorted((role, other.name) for role, other in here.links if role != "cmd"))
        words = frozenset(here.words() if concluded else here.lex)
        terms[here] = Term(here.name, words, here.literal, "", here.negated, here.belief, links)
        pending += [other for role, other in here.links if role != "cmd"]
        pending += [
            p
            for p in descriptions(here)
            if p.level <= depth
            and not (told_only and p.rule)
            and not (p in news and here.kind == "obj" and any(role == "hq" for role, _ in p.links))
        ]
    shown = {n.name for n in terms}
    kept = tuple(t for t in terms.values() if all(other in shown for _, other in t.links))
    return Graphlet(kept, node.name)
