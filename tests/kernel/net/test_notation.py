"""The text form of graphlets: one item a line, values that cannot be mistaken for structure."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kernel.errors import NotationError
from kernel.net.graphlet import Graphlet, Sketch, Term
from kernel.net.notation import read_terms, tokens, write_terms


def read(text: str) -> Graphlet:
    return read_terms(tokens(text))


def test_the_papers_own_lines_are_read() -> None:
    graphlet = read("""
        act-1 -lex-  drive
        dir-2 -lex-  forward
              -dir-> act-1
    """)
    sketch = Sketch()
    act = sketch.add("act", "drive")
    assert graphlet == sketch.graphlet(act, sketch.add("dir", "forward", dir=act))


def test_everything_a_term_can_carry_is_written_and_read() -> None:
    term = Term(
        "hq-1",
        frozenset({"heavy", "left of"}),
        "9",
        "the",
        True,
        0.8,
        (("hq", "obj-2"), ("wrt", "obj-3")),
    )
    graphlet = Graphlet((term,), "hq-1")
    assert write_terms(graphlet) == [
        "hq-1 -lex-  heavy",
        "     -lex-  left of",
        "     -str-  9",
        "     -ref-  the",
        "     -neg-  yes",
        "     -bel-  0.8",
        "     -hq-> obj-2",
        "     -wrt-> obj-3",
    ]
    assert read("\n".join(write_terms(graphlet))) == graphlet


def test_a_main_node_without_anything_to_say_is_written_alone() -> None:
    graphlet = Graphlet((Term("dir-2", frozenset({"left"}), links=(("dir", "act-1"),)),), "act-1")
    assert write_terms(graphlet)[0] == "act-1"
    assert read("\n".join(write_terms(graphlet))) == graphlet


# Texts made of what looks most like notation.
LOOKALIKES = st.text(
    st.sampled_from(
        [*"[]{}\"'\\-> ;:,.?", "\n", "\t", "\u2028", "\x85", "\u00a0", *"abI1DONCE", "é"]
    ),
    max_size=12,
)


@given(LOOKALIKES, LOOKALIKES)
def test_no_text_is_mistaken_for_structure(literal: str, word: str) -> None:
    lex = frozenset({word}) if word else frozenset()
    graphlet = Graphlet((Term("txt-1", frozenset({"x"})), Term("txt-2", lex, literal)), "txt-1")
    assert read("\n".join(write_terms(graphlet))) == graphlet


@pytest.mark.parametrize(
    "wrong",
    [
        "-lex- drive",
        "act-1 lex drive",
        "act-1 -lex-",
        "act-1 -lex-> drive",
        "act-1 -neg- maybe",
        "act-1 -bel- much",
        "act-1 -foo- bar",
        'act-1 -str- "open',
        "",
    ],
)
def test_what_is_no_notation_is_refused(wrong: str) -> None:
    with pytest.raises(NotationError):
        read(wrong)


def test_the_error_names_the_line() -> None:
    with pytest.raises(NotationError) as caught:
        read("act-1 -lex- drive\ndir-2 -dir> act-1")
    assert caught.value.line == 2
    assert "dir-2" in caught.value.text
