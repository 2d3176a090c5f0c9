"""Words for strength and belief; the numbers of docs/net.md."""

from __future__ import annotations

import re
from importlib.resources import files

import pytest

from grammars.hedges import belief, preference
from grammars.parse import parse
from kernel.memory.lesson import Operator, Rule
from kernel.memory.meaning import Fact, Teach


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
        ("maybe", 0.5),
        ("rarely", 0.2),
    ],
)
def test_how_sure_a_rule_is(word: str, value: float) -> None:
    assert belief(word) == value
    meaning = parse(f"cups are {word} fragile").meaning
    assert isinstance(meaning, Teach)
    assert isinstance(meaning.content, Rule)
    assert meaning.content.belief == value


@pytest.mark.parametrize(
    ("said", "value"),
    [
        ("dogs may be friendly", 0.5),
        ("if something is a dog it may be friendly", 0.5),
        ("dogs tend to be friendly", 0.8),
    ],
)
def test_a_rule_that_may_be_so(said: str, value: float) -> None:
    meaning = parse(said).meaning
    assert isinstance(meaning, Teach)
    assert isinstance(meaning.content, Rule)
    assert meaning.content.belief == value


@pytest.mark.parametrize(
    ("said", "value"),
    [
        ("Mary is tall", 1.0),
        ("Mary is definitely tall", 1.0),
        ("my dog usually barks", 0.8),
        ("probably the cup is heavy", 0.7),
        ("Tom may have the key", 0.5),
        ("the cup is rarely empty", 0.2),
    ],
)
def test_how_sure_a_fact_is(said: str, value: float) -> None:
    meaning = parse(said).meaning
    assert isinstance(meaning, Fact)
    assert meaning.fact.head is not None
    assert meaning.fact.head.belief == value


def test_every_hedge_of_the_grammar_has_a_belief() -> None:
    rules = (files("grammars") / "forms" / "rule.lark").read_text("utf8")
    said = re.search(r"^!hedge:(.*?)^\S", rules, re.MULTILINE | re.DOTALL)
    assert said is not None
    for words in re.findall(r'((?:"[a-z]+" ?)+)', said.group(1)):
        assert 0 < belief(words.replace('"', "").strip()) <= 1, words
