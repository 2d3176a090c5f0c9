"""What is asked about an unknown word, and what the answers mean."""

from __future__ import annotations

import pytest

from grammars.asking import AskWord
from grammars.errors import NotUnderstoodError
from grammars.parse import parse
from grammars.render import render
from grammars.replies import say
from grammars.vocabulary import BORN, with_verb

ZORK = AskWord("zork", "zork the cup")


def refused(text: str) -> NotUnderstoodError:
    with pytest.raises(NotUnderstoodError) as caught:
        parse(text)
    return caught.value


@pytest.mark.parametrize(
    "text", ["zork", "please zork twice", "zork the cup", "turn left then zork", "never zork a cup"]
)
def test_a_word_that_can_only_be_something_to_do_is_asked_about(text: str) -> None:
    error = refused(text)
    assert error.asking == AskWord("zork", text)
    assert say(error).spoken == "I don't know the word zork. Is it something to do?"


@pytest.mark.parametrize("text", ["zork the flib", "the of zork", "zork of", "is is zork"])
def test_what_would_not_work_with_it_is_not_asked_about(text: str) -> None:
    assert refused(text).asking is None


@pytest.mark.parametrize(
    "text", ["yes", "Yes, it is.", "yeah", "it is", "something to do", "it is something you do"]
)
def test_yes_makes_the_sentence_one(text: str) -> None:
    parsed = parse(text, expecting=ZORK)
    assert (parsed.kind, parsed.taught) == ("command", "zork")
    assert parsed.meaning == parse(ZORK.text, with_verb(BORN, "zork")).meaning
    assert refused(text).asking is None  # nobody asked


@pytest.mark.parametrize(
    ("text", "kind", "meaning"),
    [
        ("it means turn", "alias", "zork means turn"),
        ("no, it means turn", "alias", "zork means turn"),
        ("it is a thing", "rule", "if something is a zork, it is a thing"),
        ("no, a thing", "rule", "if something is a zork, it is a thing"),
        ("it is a kind of cup", "rule", "if something is a zork, it is a cup"),
        ("zork means turn", "alias", "zork means turn"),
        ("to zork, turn left", "procedure", "to zork, turn left"),
        ("drive forward", "command", "drive forward"),
    ],
)
def test_other_answers(text: str, kind: str, meaning: str) -> None:
    parsed = parse(text, expecting=ZORK)
    assert (parsed.kind, render(parsed.meaning, "teacher"), parsed.taught) == (kind, meaning, "")


@pytest.mark.parametrize("text", ["no", "no it is not", "nope"])
def test_no_asks_on(text: str) -> None:
    with pytest.raises(NotUnderstoodError) as caught:
        parse(text, expecting=ZORK)
    assert caught.value.asking == AskWord("zork", "zork the cup", denied=True)
    assert say(caught.value).spoken == "Then what does zork mean?"


@pytest.mark.parametrize("text", ["yes sir three bags full", "it is nice weather", "a long story"])
def test_chatter_is_no_answer(text: str) -> None:
    with pytest.raises(NotUnderstoodError):
        parse(text, expecting=ZORK)
