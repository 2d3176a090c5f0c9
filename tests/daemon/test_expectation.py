"""The checked forms of a `robot:` line."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from daemon.expectation import (
    Arcs,
    AtOnce,
    Clause,
    Comment,
    Happens,
    Holds,
    InOrder,
    Moves,
    Rests,
    Says,
    SaysNot,
    describe,
    expectation,
)

FORMS: dict[str, Clause] = {
    'says "I\'m not allowed to"': Says(("I'm not allowed to",)),
    'says "good day" or "howdy"': Says(("good day", "howdy")),
    'does not say "hi"': SaysNot("hi"),
    "asks": Happens("asks"),
    "acknowledges": Happens("acknowledges"),
    "refuses": Happens("refuses"),
    "does not move": Rests(),
    "moves forward 15..25 cm": Moves("forward", 15, 25),
    "moves backward 0..2.5 cm": Moves("backward", 0, 2.5),
    "moves forward": Moves("forward"),
    "turns left 80..100 degrees": Moves("left", 80, 100),
    "turns right": Moves("right"),
    "arcs left": Arcs("left"),
    "lifts": Moves("up"),
    "lowers": Moves("down"),
    "closes the gripper": Moves("close"),
    "opens the gripper": Moves("open"),
    "holds red block": Holds("red block"),
    "holds nothing": Holds("nothing"),
    "lowers, then lifts": InOrder((Moves("down"), Moves("up"))),
    'says "go" at the same time moves backward 15..25 cm': AtOnce(
        (Says(("go",)), Moves("backward", 15, 25))
    ),
}


@pytest.mark.parametrize("text", FORMS)
def test_a_form_is_read_and_described_in_its_own_words(text: str) -> None:
    assert expectation(text).clauses == (FORMS[text],)
    assert describe(FORMS[text]) == text


@pytest.mark.parametrize(
    ("text", "form"),
    [
        ("moves forwards 15 .. 25 cm.", Moves("forward", 15, 25)),
        ("holds the red block", Holds("red block")),
        ("lifts then lowers", InOrder((Moves("up"), Moves("down")))),
        ('lifts and says "up" at the same time', AtOnce((Moves("up"), Says(("up",))))),
        ('lifts; says "up" at the same time', AtOnce((Moves("up"), Says(("up",))))),
        ('lifts; says "up"; at the same time', AtOnce((Moves("up"), Says(("up",))))),
        ('lifts, at the same time as says "up"', AtOnce((Moves("up"), Says(("up",))))),
        ("says \N{LEFT DOUBLE QUOTATION MARK}hi\N{RIGHT DOUBLE QUOTATION MARK}", Says(("hi",))),
        ('says "wait; then, then go"', Says(("wait; then, then go",))),
        (
            'says "a", then lifts at the same time turns left, then lowers',
            InOrder((Says(("a",)), AtOnce((Moves("up"), Moves("left"))), Moves("down"))),
        ),
    ],
)
def test_other_ways_to_write_a_form(text: str, form: Clause) -> None:
    assert expectation(text).clauses == (form,)


@pytest.mark.parametrize(
    "text",
    [
        "greets Rick or acknowledges",
        "moves forward 20 cm",
        "moves forward 25..15 cm",
        "turns left 15..25 cm",
        "drives forward, then lifts",
        'says "hi" loudly',
        "at the same time",
    ],
)
def test_any_other_text_is_a_comment_and_not_checked(text: str) -> None:
    wanted = expectation(text)
    assert wanted.clauses == (Comment(text),)
    assert not wanted.checked


def test_clauses_are_joined_by_semicolons_and_checked_each_for_itself() -> None:
    wanted = expectation("acknowledges; no motion; does not move")
    assert wanted.clauses == (Happens("acknowledges"), Comment("no motion"), Rests())
    assert wanted.checked


@given(st.text())
def test_any_text_is_an_expectation(text: str) -> None:
    assert expectation(text).text == text


@given(st.lists(st.sampled_from(sorted(FORMS)), min_size=1))
def test_joined_forms_are_all_kept(texts: list[str]) -> None:
    texts = [text for text in texts if "at the same time" not in text] or ["lifts"]
    assert expectation("; ".join(texts)).clauses == tuple(FORMS[text] for text in texts)
