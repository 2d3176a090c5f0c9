"""Canonical names: what is the same net has the same names, whatever order and numbers it came with."""

import random

from hypothesis import given, settings
from hypothesis import strategies as st

from kernel.net.canon import canonical_names
from kernel.net.graphlet import Graphlet, Term
from kernel.net.notation import write_terms

WORDS = ("grab", "block", "red", "person")
PREDICATES = ("ako", "hq", "deg")


@st.composite
def nets(draw: st.DrawFn) -> Graphlet:
    """Nets like those of sentences: what links, links to something said before."""
    count = draw(st.integers(1, 6))
    terms = []
    for number in range(1, count + 1):
        lex = draw(st.frozensets(st.sampled_from(WORDS), max_size=2))
        links = ()
        kind = draw(st.sampled_from(("act", "obj")))
        if number > 1:
            targets = st.integers(0, number - 2).map(lambda i: terms[i].name)
            roles = st.sampled_from((*PREDICATES, "obj", "agt"))
            links = tuple(sorted(draw(st.sets(st.tuples(roles, targets), max_size=2))))
            kind = next((role for role, _ in links if role in PREDICATES), kind)
        negated = draw(st.booleans())
        terms.append(Term(f"{kind}-{number}", lex, negated=negated, links=links))
    return Graphlet(tuple(terms), draw(st.sampled_from([term.name for term in terms])))


def shuffled(graphlet: Graphlet, seed: int) -> Graphlet:
    chance = random.Random(seed)
    numbers = chance.sample(range(1, 50), len(graphlet.terms))
    names = {
        term.name: f"{term.kind}-{number}"
        for term, number in zip(graphlet.terms, numbers, strict=True)
    }
    renamed = graphlet.renamed(names)
    return Graphlet(tuple(chance.sample(renamed.terms, len(renamed.terms))), renamed.main)


def text(graphlet: Graphlet) -> str:
    return "\n".join(write_terms(graphlet.renamed(canonical_names([graphlet]))))


@settings(max_examples=40)
@given(nets(), st.integers())
def test_numbers_and_order_do_not_matter(graphlet: Graphlet, seed: int) -> None:
    assert text(shuffled(graphlet, seed)) == text(graphlet)


@settings(max_examples=40)
@given(nets())
def test_every_name_gets_a_name_of_its_own(graphlet: Graphlet) -> None:
    names = canonical_names([graphlet])
    assert set(names) == graphlet.mentioned
    assert len(set(names.values())) == len(names)


@settings(max_examples=40)
@given(nets())
def test_canonical_names_are_their_own(graphlet: Graphlet) -> None:
    once = graphlet.renamed(canonical_names([graphlet]))
    assert text(once) == text(graphlet)


def test_what_modifies_is_named_after_its_role() -> None:
    odd = Graphlet(
        (Term("act-1"), Term("x-2", frozenset({"left"}), links=(("dir", "act-1"),))), "act-1"
    )
    assert canonical_names([odd]) == {"act-1": "act-1", "x-2": "dir-2"}


def test_names_are_shared_by_the_graphlets_of_a_lesson() -> None:
    girl = Graphlet((Term("ako-9", frozenset({"girl"}), links=(("ako", "obj-4"),)),), "ako-9")
    person = Graphlet((Term("ako-2", frozenset({"person"}), links=(("ako", "obj-4"),)),), "ako-2")
    names = canonical_names([girl, person])
    assert names == {"ako-9": "ako-1", "obj-4": "obj-2", "ako-2": "ako-3"}
