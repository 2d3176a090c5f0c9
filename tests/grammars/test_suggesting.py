"""The nearest sentence that would work is a sentence that works."""

from __future__ import annotations

import pytest

from grammars.errors import NotUnderstoodError
from grammars.parse import parse


def nearest(text: str) -> str | None:
    with pytest.raises(NotUnderstoodError) as caught:
        parse(text)
    return caught.value.nearest


@pytest.mark.parametrize(
    ("text", "suggested"),
    [
        ("grav the cup", "grab the cup"),
        ("pusk the ball", "push the ball"),
        ("don't gab a person", "don't grab a person"),
        ("if somthing is closs then turn left", "if something is close then turn left"),
        ("raise the left", "raise the lift"),
        ("stp", "stop"),
        ("and turn left", "turn left"),
        ("turn left of", "turn left"),
    ],
)
def test_the_same_with_a_word_spelt_otherwise_or_left_out(text: str, suggested: str) -> None:
    assert nearest(text) == suggested
    parse(suggested)


@pytest.mark.parametrize(
    "text",
    [
        "not turn left",
        "if the traffic is bad i will be late",
        "make me happy now",
        "zork",
        "what a nice day",
        "the weather is nice today",
    ],
)
def test_nothing_is_suggested_that_says_something_else(text: str) -> None:
    assert nearest(text) is None


@pytest.mark.parametrize(
    ("text", "repaired"),
    [
        ("drive forward ten inchez and stopp", {"inchez": "inches", "stopp": "stop"}),
        ("turn rihgt then drive backwords", {"rihgt": "right", "backwords": "backwards"}),
    ],
)
def test_the_likelier_slip_of_each_word_is_repaired(text: str, repaired: dict[str, str]) -> None:
    assert dict(parse(text).repaired) == repaired
