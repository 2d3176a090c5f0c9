"""Typed and recognised text becomes plain words that remember where they came from."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grammars.normalise import pieces, without_chat, without_repeats
from grammars.repairing import repaired_by_speaker


def words(text: str) -> str:
    return " ".join(piece.text for piece in pieces(text))


TABLE = [
    ("Turn RIGHT!", "turn right"),
    ("don't", "do not"),
    ("can't you", "can not you"),
    ("I'm Rick.", "i am rick"),
    ("the block's heavy", "the block 's heavy"),
    ("what's that?", "what is that"),
    ("it's me", "it is me"),
    ("ninety degrees", "90 degrees"),
    ("forty five", "45"),
    ("forty-five", "45"),
    ("a hundred and eighty degrees", "180 degrees"),
    ("two hundred", "200"),
    ("one and a half feet", "1.5 feet"),
    ("half a meter", "0.5 meter"),
    ("point five meters", "0.5 meters"),
    ("three quarters of a meter", "0.75 meter"),
    ("till it is close", "until it is close"),
    ("one point five meters", "1.5 meters"),
    ("10cm", "10 cm"),
    ("2.5 inches", "2.5 inches"),
    ("2 in.", "2 in"),
    ("the one on the left", "the one on the left"),
    ("turn left and right", "turn left and right"),
    ("um turn uh left", "turn left"),
    ("ok: turn left; wait", "okay , turn left , wait"),
    ("90°", "90 degree"),
    ("say “hello you”", "say hello you"),
]


@pytest.mark.parametrize(("text", "normal"), TABLE)
def test_normal_form(text: str, normal: str) -> None:
    assert words(text) == normal


def test_stammering_is_removed_but_not_from_numbers() -> None:
    assert [
        p.text for p in without_repeats(pieces("turn turn left 5 5"))
    ] == "turn left 5 5".split()


def test_words_said_while_thinking_are_left_out() -> None:
    def plain(text: str) -> str:
        return " ".join(piece.text for piece in without_chat(pieces(text)))

    assert plain("could you, like, turn left") == "could you turn left"
    assert plain("you know, drive forward") == "drive forward"
    assert plain("turn left, you know") == "turn left"
    assert plain("mary is like a girl") == "mary is like a girl"


def test_a_phrase_begun_twice_is_said_once_but_not_a_whole_sentence() -> None:
    def once(text: str) -> str:
        return " ".join(piece.text for piece in without_repeats(pieces(text)))

    assert once("grab the grab the cup") == "grab the cup"
    assert once("wait for it wait for it") == "wait for it wait for it"


def test_the_speaker_corrects_himself() -> None:
    def corrected(text: str) -> str:
        return " ".join(piece.text for piece in repaired_by_speaker(pieces(text)))

    assert corrected("turn left i mean right") == "turn right"
    assert corrected("raise the lift no wait lower the lift") == "lower the lift"
    assert corrected("drive two no three feet") == "drive 3 feet"
    assert corrected("turn left") == "turn left"
    assert corrected("drive forward five no six inches") == "drive forward 6 inches"
    assert corrected("drive forward five inches i mean six") == "drive forward 6 inches"


@given(st.text(max_size=80))
def test_positions_lie_in_the_text_and_in_order(text: str) -> None:
    found = pieces(text)
    assert all(0 <= piece.begin <= piece.end <= len(text) for piece in found)
    assert [p.begin for p in found] == sorted(p.begin for p in found)
