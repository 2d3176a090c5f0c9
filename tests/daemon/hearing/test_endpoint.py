"""How long to wait after the last sound."""

from __future__ import annotations

import pytest

from daemon.hearing.endpoint import (
    LONG_WAIT_S,
    SHORT_WAIT_S,
    is_continuation,
    is_open,
    is_unfinished,
    wait_s,
)
from grammars.language import language

LANGUAGE = language()


@pytest.mark.parametrize(
    ("text", "expected_s"),
    [
        ("drive forward", SHORT_WAIT_S),
        ("stop", SHORT_WAIT_S),
        ("polish the wooden spoon", SHORT_WAIT_S),
        ("mary is a girl", SHORT_WAIT_S),
        ("turn left then", LONG_WAIT_S),
        ("grab the", LONG_WAIT_S),
        ("", LONG_WAIT_S),
        ("to cha-cha drive forward", LONG_WAIT_S),
        ("if something is very close then drive backwards", LONG_WAIT_S),
        ("never drive backwards", LONG_WAIT_S),
        ("before you grab the block turn left", LONG_WAIT_S),
        ("you should never grab a person", LONG_WAIT_S),
        ("every time you see a lady wave", LONG_WAIT_S),
    ],
)
def test_the_wait_depends_on_what_was_heard(text: str, expected_s: float) -> None:
    assert wait_s(text, LANGUAGE.reads(text)) == expected_s


def test_a_lesson_is_open_and_a_command_is_not() -> None:
    assert is_open("robot to dance cha-cha")
    assert not is_open("today is fine")
    assert not is_open("turn left")


def test_half_a_sentence_is_unfinished_and_nonsense_is_not() -> None:
    assert is_unfinished("turn left then", False, LANGUAGE)
    assert not is_unfinished("turn left", True, LANGUAGE)
    assert not is_unfinished("then then", False, LANGUAGE)
    assert not is_unfinished("", False, LANGUAGE)


def test_only_the_rest_of_a_sentence_is_a_continuation() -> None:
    assert is_continuation("then drive backwards")
    assert not is_continuation("drive backwards")
