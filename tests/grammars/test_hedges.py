"""Words for strength and belief; the numbers of docs/net.md."""

from __future__ import annotations

import pytest

from grammars.hedges import belief, preference
from grammars.parse import parse
from kernel.memory.lesson import Operator, Rule
from kernel.memory.meaning import Teach


@pytest.mark.parametrize(
    ("words", "value"),
    [
        ("", 1.0),
        ("could", 0.8),
        ("might", 0.6),
        ("should", 1.0),
        ("must", 1.1),
        ("must always", 1.2),
    ],
)
def test_strength_of_advice(words: str, value: float) -> None:
    assert preference(words) == value
    sentence = f"to hide you {words} turn around" if words else "to hide turn around"
    meaning = parse(sentence).meaning
    assert isinstance(meaning, Teach)
    assert isinstance(meaning.content, Operator)
    assert meaning.content.preference == value


@pytest.mark.parametrize(
    ("word", "value"),
    [
        ("definitely", 1.0),
        ("", 1.0),
        ("usually", 0.8),
        ("probably", 0.7),
        ("sometimes", 0.5),
        ("rarely", 0.2),
    ],
)
def test_how_sure_a_rule_is(word: str, value: float) -> None:
    assert belief(word) == value
    meaning = parse(f"cups are {word} fragile").meaning
    assert isinstance(meaning, Teach)
    assert isinstance(meaning.content, Rule)
    assert meaning.content.belief == value
