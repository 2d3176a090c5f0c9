"""Completion: words that can continue a sentence, taught ones included, faster than anybody types."""

from __future__ import annotations

import time

import pytest

from daemon.control.completing import Words
from grammars.parse import parse
from grammars.vocabulary import BORN, from_policy
from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Teach


def taught(*sentences: str) -> Words:
    lessons = []
    for sentence in sentences:
        meaning = parse(sentence).meaning
        assert isinstance(meaning, Teach)
        lessons.append(Lesson(1, meaning.kind, meaning.content))
    return Words(from_policy(lessons))


@pytest.mark.parametrize(
    ("text", "offered", "not_offered"),
    [
        ("", {"drive", "if", "never"}, {"seconds"}),
        ("dri", {"drive"}, {"drop", "dri"}),
        ("drive", set(), {"drive", "forward"}),
        ("drive ", {"forward", "backward", "slowly"}, {"close"}),
        ("Drive FOR", {"forward"}, {"for"}),
        ("if something is very close, ", {"then", "drive"}, set()),
        ("you should never ", {"grab"}, {"if"}),
        ("the if of ", set(), {"drive"}),
        ("/l", {"/lessons"}, {"/quit"}),
        ("/lessons ", set(), {"/lessons"}),
    ],
)
def test_what_may_come_next(text: str, offered: set[str], not_offered: set[str]) -> None:
    found = set(Words(BORN).after(text))
    assert offered <= found
    assert not not_offered & found


def test_taught_verbs_come_first_wherever_a_verb_may_stand() -> None:
    words = taught("to zorp, turn left", "to fribble, turn right")
    assert words.after("")[:2] == ["fribble", "zorp"]
    assert words.after("zo") == ["zorp"]
    assert "zorp" in words.after("if something is close then ")
    assert "zorp" not in Words(BORN).after("zo")


def test_every_word_offered_continues_some_sentence() -> None:
    words, text = Words(BORN), ""
    for _ in range(3):
        text += words.after(text)[0] + " "
    assert words.after(text) or parse(text)


@pytest.mark.parametrize(
    ("text", "begun"), [("drive for", "for"), ("drive ", ""), ("/le", "/le"), ("a,b", "b")]
)
def test_what_a_completion_takes_the_place_of(text: str, begun: str) -> None:
    assert Words.begun(text) == begun


def test_a_key_takes_less_than_30_ms() -> None:
    words = taught("to zorp, turn left")
    words.warm_up()
    text = "if something is very close then drive backward slowly and say hello"
    slowest_s = 0.0
    for end in range(len(text)):
        began_s = time.perf_counter()
        words.after(text[:end])
        slowest_s = max(slowest_s, time.perf_counter() - began_s)
    assert slowest_s < 0.03
