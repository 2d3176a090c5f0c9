"""The rule book: a rule is found when its words are in mind, in the order it was taught."""

from collections.abc import Callable

import pytest

from kernel.memory.lesson import Lesson
from kernel.memory.rules import RuleBook
from kernel.net.node import Net

MakeLesson = Callable[..., Lesson]


def rule(word: str, then: str) -> str:
    return (
        f"if: ako-1 -lex- {word}; -ako-> obj-2; then: hq-3 -lex- {then}; -hq-> obj-2; belief: 1.0"
    )


def test_only_rules_whose_word_is_in_mind_are_tried(lesson: MakeLesson) -> None:
    book, net = RuleBook(), Net()
    girl, dog = (lesson(rule(word, "small")) for word in ("girl", "dog"))
    book.add(girl)
    book.add(dog)
    assert list(book.candidates(net)) == []
    net.new("ako", "girl")
    assert [found for found, _ in book.candidates(net)] == [girl]


def test_a_rule_without_words_is_always_tried(lesson: MakeLesson) -> None:
    book = RuleBook()
    book.add(lesson("if: ako-1 -ako-> obj-2; then: hq-3 -lex- real; -hq-> obj-2; belief: 1.0"))
    assert len(list(book.candidates(Net()))) == 1


@pytest.mark.parametrize("strangers", [0, 50])
def test_they_come_in_the_order_of_teaching_however_many_words_are_in_mind(
    lesson: MakeLesson, strangers: int
) -> None:
    book, net = RuleBook(), Net()
    taught = [lesson(rule(word, "small")) for word in ("dog", "elephant", "cat")]
    for each in taught:
        book.add(each)
    for word in ("cat", "dog", "elephant"):
        net.new("ako", word)
    for number in range(strangers):
        net.new("ako", f"stranger{number}")
    assert [found for found, _ in book.candidates(net)] == taught


def test_an_operator_is_no_rule(lesson: MakeLesson) -> None:
    with pytest.raises(TypeError):
        RuleBook().add(lesson("trig: DO[ act-1 -lex- dance ]; pref: 1.0; ---"))
