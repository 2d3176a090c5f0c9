"""Matching a graphlet against memory: every binding of its names to nodes under which all its terms hold."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kernel.net.graphlet import Graphlet, Term
from kernel.net.node import Net, Node

Binding = dict[str, Node]


def matches(
    graphlet: Graphlet,
    net: Net,
    depth: int,
    bound: Mapping[str, Node] | None = None,
    threshold: float = 0.5,
    supposed: frozenset[Node] = frozenset(),
) -> Iterator[Binding]:
    """Every binding that extends `bound`; different names bind different nodes.

    Args:
        graphlet: pattern; `ref` is not looked at, a term without words fits any node in its place.
        depth: level up to which nodes count (kernel.net.node: WORKING, BAND_1, BAND_2, REMEMBERED).
        bound: names that are known already.
        threshold: nodes of a lower belief do not count.
        supposed: nodes that count whatever their level (kernel.hypothesis).
    """
    for term in graphlet.terms:
        if term.lex and not all(map(net.has_word, term.lex)):
            return
    matcher = _Matcher(net, depth, threshold, supposed)
    yield from matcher.solve(list(graphlet.terms), dict(bound or {}))


def holds(
    graphlet: Graphlet,
    net: Net,
    depth: int,
    bound: Mapping[str, Node] | None = None,
    threshold: float = 0.5,
) -> bool:
    """Whether there is any binding."""
    return next(matches(graphlet, net, depth, bound, threshold), None) is not None


class _Matcher:
    def __init__(self, net: Net, depth: int, threshold: float, supposed: frozenset[Node]) -> None:
        self.net, self.depth, self.threshold, self.supposed = net, depth, threshold, supposed

    def solve(self, pending: list[Term], binding: Binding) -> Iterator[Binding]:
        if not pending:
            yield dict(binding)
            return
        term = min(pending, key=lambda t: self.cost(t, pending, binding))
        rest = [other for other in pending if other is not term]
        bound = binding.get(term.name)
        candidates = (bound,) if bound is not None else self.candidates(term, pending, binding)
        taken = set(binding.values())
        for node in candidates:
            if (node is bound or node not in taken) and self.fits(term, node):
                yield from self.follow(term.links, node, rest, {**binding, term.name: node})

    def follow(
        self, links: tuple[tuple[str, str], ...], node: Node, rest: list[Term], binding: Binding
    ) -> Iterator[Binding]:
        """Satisfy the links one by one, branching where a target is open."""
        if not links:
            yield from self.solve(rest, binding)
            return
        (role, name), *others = links
        target = binding.get(name)
        for other in node.to(role):
            if other is target:
                yield from self.follow(tuple(others), node, rest, binding)
            elif target is None and self.counts(other) and other not in binding.values():
                yield from self.follow(tuple(others), node, rest, {**binding, name: other})

    def counts(self, node: Node) -> bool:
        return node.level <= self.depth or node in self.supposed

    def fits(self, term: Term, node: Node) -> bool:
        return (
            self.counts(node)
            and node.negated == term.negated
            and node.belief >= self.threshold
            and (term.literal is None or node.literal == term.literal)
            and all(node.known_as(word, self.depth) for word in term.lex)
        )

    def cost(self, term: Term, pending: list[Term], binding: Binding) -> tuple[int, int]:
        """Bound terms first, then those that touch a bound node, then those with the rarest word."""
        if term.name in binding:
            return (0, 0)
        if any(name in binding for _, name in term.links) or self.pointed_from(
            term, pending, binding
        ):
            return (1, -len(term.lex))
        if term.lex:
            return (2, min(len(list(self.net.with_word(word))) for word in term.lex))
        return (3, -len(term.links))

    def pointed_from(self, term: Term, pending: list[Term], binding: Binding) -> bool:
        return any(
            other.name in binding and any(name == term.name for _, name in other.links)
            for other in pending
        )

    def candidates(self, term: Term, pending: list[Term], binding: Binding) -> list[Node]:
        for role, name in term.links:
            if name in binding:
                return list(binding[name].modifiers(role))
        if term.lex:
            rarest = min(term.lex, key=lambda word: len(list(self.net.with_word(word))))
            return list(self.net.with_word(rarest))
        return list(self.net)
