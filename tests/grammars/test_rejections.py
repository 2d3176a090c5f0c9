"""Chatter and word salad move nothing and teach nothing."""

from __future__ import annotations

import time
from pathlib import Path
from statistics import median

import pytest

from grammars.errors import NotUnderstoodError
from grammars.parse import parse

LINES = [
    line
    for line in (Path(__file__).parent / "rejections.txt").read_text(encoding="utf8").splitlines()
    if line and not line.startswith("#")
]


@pytest.mark.parametrize("line", LINES)
def test_it_is_not_understood(line: str) -> None:
    with pytest.raises(NotUnderstoodError) as caught:
        parse(line)
    assert caught.value.text == line


@pytest.mark.parametrize(
    "text",
    [
        "",
        "   ",
        "...",
        "turn left\x00",
        "turn\x1b[2Jleft",
        "turn " * 61,
        "x" * 5000,
        "\ud800",
        "右に曲がれ",
    ],
)
def test_what_is_no_sentence_is_refused(text: str) -> None:
    with pytest.raises(NotUnderstoodError):
        parse(text)


def test_what_is_no_text_is_refused() -> None:
    with pytest.raises(NotUnderstoodError):
        parse(b"turn left")  # type: ignore[arg-type]


def test_refusing_is_fast() -> None:
    def cost_ms(line: str) -> float:
        began = time.process_time()
        with pytest.raises(NotUnderstoodError):
            parse(line)
        return (time.process_time() - began) * 1000

    assert median(cost_ms(line) for line in LINES) < 50


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("twizzle", "twizzle"),
        ("flurb the block", "flurb"),
        ("zorkle slowly then turn left", "zorkle"),
    ],
)
def test_an_unknown_verb_is_named(text: str, word: str) -> None:
    with pytest.raises(NotUnderstoodError) as caught:
        parse(text)
    assert caught.value.unknown_words == (word,)


def test_what_was_understood_and_what_would_work_is_told() -> None:
    with pytest.raises(NotUnderstoodError) as caught:
        parse("turn left the if")
    assert caught.value.understood.startswith("turn left")
    with pytest.raises(NotUnderstoodError) as caught:
        parse("grab the block then up of")
    assert caught.value.nearest is not None
    parse(caught.value.nearest)
