"""The answer to "which one?" is understood while that is asked, and only then."""

from __future__ import annotations

import pytest

from grammars.errors import NotUnderstoodError
from grammars.parse import parse
from grammars.registry import discover
from grammars.render import render
from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Choice, Command, Control
from kernel.memory.notation import read, write_meaning
from kernel.memory.reply import AskKeep, AskWhich
from kernel.net.graphlet import Graphlet


def described(text: str) -> Graphlet:
    content = read(text)
    assert isinstance(content, Graphlet)
    return content


BLOCK = "ako-2 -lex- block\n-ako-> obj-1\nhq-3 -lex- {}\n-hq-> obj-1"
RED = described(BLOCK.format("red") + "\nloc-4 -lex- left\n-loc-> obj-1")
BLUE = described(BLOCK.format("blue"))
WANTED = described("ako-2 -lex- block\n-ako-> obj-1")
QUESTION = AskWhich(WANTED, (RED, BLUE))


@pytest.mark.parametrize(
    "answer", [*discover()["choice"].examples, "the blue block", "blue please"]
)
def test_an_answer_is_understood_while_it_is_asked_for_and_not_otherwise(answer: str) -> None:
    parsed = parse(answer, expecting=QUESTION)
    assert parsed.kind == "answer"
    assert isinstance(parsed.meaning, Choice)
    with pytest.raises(NotUnderstoodError):
        parse(answer)


@pytest.mark.parametrize("answer", ["the red one", "the red block", "the one on the left"])
def test_it_reads_back(answer: str) -> None:
    meaning = parse(answer, expecting=QUESTION).meaning
    back = parse(render(meaning, "teacher"), expecting=QUESTION).meaning
    assert write_meaning(back) == write_meaning(meaning)


def test_one_is_no_kind() -> None:
    meaning = parse("the red one", expecting=QUESTION).meaning
    assert isinstance(meaning, Choice)
    assert meaning.described.words() == {"red"}


@pytest.mark.parametrize("chatter", ["the green one", "the news", "mary", "it", "the radio"])
def test_what_describes_none_of_them_is_no_answer(chatter: str) -> None:
    with pytest.raises(NotUnderstoodError):
        parse(chatter, expecting=QUESTION)


def test_a_command_is_a_command_while_the_question_is_open() -> None:
    assert isinstance(parse("turn left", expecting=QUESTION).meaning, Command)


DOUBT = AskKeep(Lesson(0, "fact", BLUE, "", "", 0.0), "denies_itself")


@pytest.mark.parametrize("answer", [*discover()["refusal"].examples, "No!"])
def test_no_cancels_a_doubtful_lesson_and_means_nothing_otherwise(answer: str) -> None:
    assert parse(answer, expecting=DOUBT).meaning == Control("cancel")
    for question in (None, QUESTION):
        with pytest.raises(NotUnderstoodError):
            parse(answer, expecting=question)
