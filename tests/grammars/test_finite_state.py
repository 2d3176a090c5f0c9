"""Rules as an automaton."""

from __future__ import annotations

import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grammars.automaton import sample
from grammars.finite_state import Compiler, expand

RULES = [
    ("start", ("chain",)),
    ("chain", ("action",)),
    ("chain", ("action", '"then"', "chain")),
    ("action", ("VERB",)),
    ("action", ("VERB", "np")),
    ("np", ('"the"', "NOUN")),
    ("np", ('"the"', "NOUN", '"near"', "np")),
    ("list", ("NOUN",)),
    ("list", ("list", '"and"', "NOUN")),
]
WORDS = {"VERB": ("grab", "pick up"), "NOUN": ("block", "ball")}
SMALL = expand(Compiler(RULES).compiled("start"), WORDS)


def test_repetition_is_a_loop_and_nesting_is_bounded() -> None:
    assert SMALL.accepts("grab then grab then grab then grab the ball".split())
    assert SMALL.accepts("grab the ball near the block".split())
    lists = expand(Compiler(RULES).compiled("list"), WORDS)
    assert lists.accepts("ball and block and ball and ball".split())
    assert not lists.accepts("ball and".split())


def test_an_entry_of_two_words_is_a_path() -> None:
    assert SMALL.accepts("pick up the ball".split())
    assert not SMALL.accepts("pick the ball".split())


def test_the_automaton_is_minimal() -> None:
    rules = [("start", ("A", "B")), ("start", ("C", "B")), ("start", ("D", "B"))]
    assert Compiler(rules).compiled("start").size == 3


def test_a_rule_that_is_not_there_is_an_error() -> None:
    with pytest.raises(KeyError):
        Compiler(RULES).compiled("nothing")


def test_a_category_without_words_takes_its_sentences_along() -> None:
    assert not expand(Compiler(RULES).compiled("start"), {"NOUN": ("ball",)}).arcs


@given(st.integers(0, 2**32))
def test_every_sampled_sentence_is_a_sentence(seed: int) -> None:
    for sentence in sample(SMALL, 5, random.Random(seed)):
        assert SMALL.accepts(sentence.split())


def test_two_words_said_as_one_and_possessives() -> None:
    rules = [("start", ('"do"', '"not"', '"grab"', "NAME", '"\'s"', '"cup"'))]
    said = expand(Compiler(rules).compiled("start"), {"NAME": ("mary",)})
    assert said.accepts("don't grab mary's cup".split())
    assert said.accepts("do not grab mary's cup".split())
    assert "'s" not in said.words
