"""Matching a graphlet against memory: every binding of its names to nodes under which all its terms hold."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from operator import gt, lt
from typing import Final

from kernel.net.graphlet import Graphlet, Term
from kernel.net.node import Net, Node

Binding = dict[str, Node]
# How an amount in a pattern may be bounded.
BOUNDS: Final[dict[str, Callable[[float, float], bool]]] = {">": gt, "<": lt}


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
    terms = list(graphlet.terms)
    for term in terms:
        for word in term.lex:
            if not net.has_word(word):
                return
    yield from solutions(terms, net, depth, dict(bound) if bound else {}, threshold, supposed)


def solutions(
    terms: list[Term],
    net: Net,
    depth: int,
    bound: Binding,
    threshold: float,
    supposed: frozenset[Node] = frozenset(),
) -> Iterator[Binding]:
    """As `matches`, for a caller who knows that every word is there and gives terms and binding away."""
    return _Matcher(net, depth, threshold, supposed).solve(terms, bound)


def holds(
    graphlet: Graphlet,
    net: Net,
    depth: int,
    bound: Mapping[str, Node] | None = None,
    threshold: float = 0.5,
) -> bool:
    """Whether there is any binding."""
    return next(matches(graphlet, net, depth, bound, threshold), None) is not None


def _is_so(wanted: str, literal: str | None) -> bool:
    """The same words or number, or a number within the bound that is wanted: "> 10"."""
    if literal == wanted or literal is None:
        return literal == wanted
    bound, _, number = wanted.partition(" ")
    if bound not in BOUNDS:
        return False
    try:
        return BOUNDS[bound](float(literal), float(number))
    except ValueError:
        return False


class _Matcher:
    __slots__ = ("depth", "net", "supposed", "threshold")

    def __init__(self, net: Net, depth: int, threshold: float, supposed: frozenset[Node]) -> None:
        self.net, self.depth, self.threshold, self.supposed = net, depth, threshold, supposed

    def solve(self, pending: list[Term], binding: Binding) -> Iterator[Binding]:
        if not pending:
            yield binding
            return
        term = pending[0] if len(pending) == 1 else self.next_term(pending, binding)
        rest = [other for other in pending if other is not term]
        bound = binding.get(term.name)
        if bound is not None:
            if self.fits(term, bound):
                yield from self.follow(term.links, bound, rest, binding)
            return
        taken = binding.values()
        for node in self.candidates(term, binding):
            if self.fits(term, node) and node not in taken:
                yield from self.follow(term.links, node, rest, {**binding, term.name: node})

    def follow(
        self, links: tuple[tuple[str, str], ...], node: Node, rest: list[Term], binding: Binding
    ) -> Iterator[Binding]:
        """Satisfy the links one by one, branching where a target is open."""
        if not links:
            yield from self.solve(rest, binding)
            return
        (role, name), others = links[0], links[1:]
        target = binding.get(name)
        for r, other in node.links:
            if r != role:
                continue
            if other is target:
                yield from self.follow(others, node, rest, binding)
            elif target is None and self.counts(other) and other not in binding.values():
                yield from self.follow(others, node, rest, {**binding, name: other})

    def counts(self, node: Node) -> bool:
        return node.level <= self.depth or node in self.supposed

    def fits(self, term: Term, node: Node) -> bool:
        if (
            (node.level > self.depth and node not in self.supposed)
            or node.negated != term.negated
            or node.belief < self.threshold
            or (term.literal is not None and not _is_so(term.literal, node.literal))
        ):
            return False
        for word in term.lex:
            if word not in node.lex and not node.known_as(word, self.depth, self.threshold):
                return False
        return True

    def next_term(self, pending: list[Term], binding: Binding) -> Term:
        """Bound terms first, then those that point to a bound node, then those with the rarest word."""
        best, least = pending[0], (9, 0)
        for term in pending:
            if term.name in binding:
                return term
            if any(name in binding for _, name in term.links):
                cost = (1, -len(term.lex))
            elif term.lex:
                cost = (2, min(len(self.net.with_word(word)) for word in term.lex))
            else:
                cost = (3, -len(term.links))
            if cost < least:
                best, least = term, cost
        return best

    def candidates(self, term: Term, binding: Binding) -> list[Node]:
        for role, name in term.links:
            if name in binding:
                return list(binding[name].modifiers(role))
        if term.lex:
            words = sorted(term.lex) if len(term.lex) > 1 else term.lex
            found: list[Collection[Node]] = [self.net.with_word(word) for word in words]
            return list(found[0] if len(found) == 1 else sorted(found, key=len)[0])
        return list(self.net)
