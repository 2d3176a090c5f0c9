"""The matcher finds what a search through every assignment finds, no more and no less."""

from collections.abc import Iterator
from itertools import permutations

from hypothesis import given, settings
from hypothesis import strategies as st

from kernel.net.graphlet import Graphlet, Sketch, Term
from kernel.net.match import Binding, holds, matches
from kernel.net.node import BAND_1, BAND_2, REMEMBERED, WORKING, Net, Node

WORDS = ("a", "b")
ROLES = ("ako", "obj")


@st.composite
def memories(draw: st.DrawFn) -> Net:
    net = Net()
    nodes: list[Node] = []
    for _ in range(draw(st.integers(1, 4))):
        node = net.new("obj", *draw(st.sets(st.sampled_from(WORDS))))
        node.level = draw(st.sampled_from((WORKING, WORKING, BAND_1, BAND_2, REMEMBERED)))
        node.negated = draw(st.booleans())
        node.belief = draw(st.sampled_from((1.0, 0.6, 0.3)))
        nodes.append(node)
    indices = st.integers(0, len(nodes) - 1)
    for start, role, end in draw(
        st.lists(st.tuples(indices, st.sampled_from(ROLES), indices), max_size=8)
    ):
        if start != end:
            net.link(nodes[start], role, nodes[end])
    for index in draw(st.sets(indices, max_size=2)):
        belief = draw(st.sampled_from((1.0, 0.3)))
        net.overlay(nodes[index], draw(st.sampled_from(WORDS)), BAND_1, belief)
    return net


@st.composite
def patterns(draw: st.DrawFn) -> Graphlet:
    names = [f"x-{n}" for n in range(1, draw(st.integers(1, 3)) + 1)]
    terms = []
    for name in names:
        others = [*(n for n in names if n != name), "y-9"]
        links = draw(
            st.sets(st.tuples(st.sampled_from(ROLES), st.sampled_from(others)), max_size=2)
        )
        lex = draw(st.frozensets(st.sampled_from(WORDS), max_size=1))
        terms.append(Term(name, lex, negated=draw(st.booleans()), links=tuple(sorted(links))))
    return Graphlet(tuple(terms), names[0])


def exhaustive(
    graphlet: Graphlet, net: Net, depth: int, bound: Binding, threshold: float
) -> Iterator[Binding]:
    """Try every assignment of different nodes to the open names."""
    names = sorted(
        {t.name for t in graphlet.terms} | {n for t in graphlet.terms for _, n in t.links}
    )
    open_names = [name for name in names if name not in bound]
    free = [node for node in net if node not in bound.values()]
    for choice in permutations(free, len(open_names)):
        binding = {**bound, **dict(zip(open_names, choice, strict=True))}
        if any(node.level > depth for node in choice):
            continue
        if all(_fits(term, binding, depth, threshold) for term in graphlet.terms):
            yield binding


def _fits(term: Term, binding: Binding, depth: int, threshold: float) -> bool:
    node = binding[term.name]
    concluded = {
        word
        for word, levels in node.halo_lex.items()
        if any(level <= depth and belief >= threshold for level, belief in levels.items())
    }
    words = node.lex | concluded
    return (
        node.level <= depth
        and term.lex <= words
        and node.negated == term.negated
        and node.belief >= threshold
        and all((role, binding[name]) in node.links for role, name in term.links)
    )


def as_set(bindings: Iterator[Binding]) -> list[list[tuple[str, str]]]:
    return sorted(sorted((name, node.name) for name, node in b.items()) for b in bindings)


@settings(max_examples=50)
@given(memories(), patterns(), st.sampled_from((WORKING, BAND_1, BAND_2, REMEMBERED)),
       st.sampled_from((0.0, 0.5)), st.booleans())  # fmt: skip
def test_it_finds_exactly_what_an_exhaustive_search_finds(
    net: Net, graphlet: Graphlet, depth: int, threshold: float, start_bound: bool
) -> None:
    bound = {graphlet.main: next(iter(net))} if start_bound else {}
    found = as_set(matches(graphlet, net, depth, bound, threshold))
    assert found == as_set(exhaustive(graphlet, net, depth, bound, threshold))
    assert holds(graphlet, net, depth, bound, threshold) == bool(found)


def block(net: Net, *qualities: str) -> Node:
    thing = net.new("obj")
    net.new("ako", "block", ako=thing)
    for quality in qualities:
        net.new("hq", quality, hq=thing)
    return thing


def test_how_something_was_referred_to_is_not_matched() -> None:
    net = Net()
    thing = block(net)
    sketch = Sketch()
    wanted = sketch.add("obj", ref="the")
    pattern = sketch.graphlet(wanted, sketch.add("ako", "block", ako=wanted))
    assert [b[wanted] for b in matches(pattern, net, WORKING)] == [thing]


def test_different_names_are_different_things() -> None:
    net = Net()
    block(net)
    sketch = Sketch()
    one, two = sketch.add("obj"), sketch.add("obj")
    kinds = [sketch.add("ako", "block", ako=name) for name in (one, two)]
    pattern = sketch.graphlet(one, two, *kinds)
    assert not holds(pattern, net, WORKING)
    block(net)
    assert len(list(matches(pattern, net, WORKING))) == 2


def test_a_literal_has_to_be_the_same_and_denial_too() -> None:
    net = Net()
    amount = net.new("amt", "inch")
    amount.literal = "10"
    bounds = (("> 9.5", True), ("> 10", False), ("< 12", True), ("< 9", False), ("< few", False))
    for literal, fits in (("10", True), ("5", False), (None, True), *bounds):
        term = Term("amt-1", frozenset({"inch"}), literal)
        assert holds(Graphlet((term,), "amt-1"), net, WORKING) is fits
    assert not holds(
        Graphlet((Term("amt-1", frozenset({"inch"}), negated=True),), "amt-1"), net, WORKING
    )


def test_names_that_are_only_linked_to_are_different_things_too() -> None:
    net = Net()
    someone = net.new("obj")
    net.new("act", "wash", agt=someone, obj=someone)
    term = Term("act-1", frozenset({"wash"}), links=(("agt", "obj-2"), ("obj", "obj-3")))
    assert not holds(Graphlet((term,), "act-1"), net, WORKING)
    net.new("act", "wash", agt=someone, obj=net.new("obj"))
    assert len(list(matches(Graphlet((term,), "act-1"), net, WORKING))) == 1
