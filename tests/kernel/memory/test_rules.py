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


def candidates(book: RuleBook, net: Net) -> list[Lesson]:
    """Rules that might fire, in their order."""
    return [found.lesson for found in sorted(book.possible(net), key=lambda found: found.order)]


def test_only_rules_whose_word_is_in_mind_are_tried(lesson: MakeLesson) -> None:
    book, net = RuleBook(), Net()
    girl, dog = (lesson(rule(word, "small")) for word in ("girl", "dog"))
    book.add(girl)
    book.add(dog)
    assert candidates(book, net) == []
    net.new("ako", "girl")
    assert candidates(book, net) == [girl]


def test_a_rule_without_words_is_always_tried(lesson: MakeLesson) -> None:
    book = RuleBook()
    book.add(lesson("if: ako-1 -ako-> obj-2; then: hq-3 -lex- real; -hq-> obj-2; belief: 1.0"))
    assert len(candidates(book, Net())) == 1


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
    assert candidates(book, net) == taught


def test_an_operator_is_no_rule(lesson: MakeLesson) -> None:
    with pytest.raises(TypeError):
        RuleBook().add(lesson("trig: DO[ act-1 -lex- dance ]; pref: 1.0; ---"))


def test_a_retired_rule_is_not_tried_and_rules_are_counted(lesson: MakeLesson) -> None:
    book, net = RuleBook(), Net()
    girl = lesson(rule("girl", "small"))
    book.add(girl)
    net.new("ako", "girl")
    assert len(book) == 1
    for _ in range(2):
        book.remove(girl)
    assert len(book) == 0
    assert candidates(book, net) == []


def test_an_equal_rule_is_known_whatever_its_belief(lesson: MakeLesson) -> None:
    book = RuleBook()
    sure, unsure = lesson(rule("girl", "small")), lesson(rule("girl", "small")[:-3] + "0.3")
    book.add(sure)
    assert not book.is_new(unsure.content)
    assert book.is_new(lesson(rule("girl", "tall")).content)
    book.remove(sure)
    assert book.is_new(unsure.content)


def test_a_belief_that_was_adapted_is_kept_apart_from_the_taught_one(lesson: MakeLesson) -> None:
    book = RuleBook()
    girl = lesson(rule("girl", "small"))
    book.add(girl)
    book.believe(girl, 0.4)
    there = book.get(girl.ident)
    assert there is not None
    assert (there.strength, there.rule.belief) == (0.4, 1.0)
    book.believe(girl, 0.9)
    assert there.strength == 0.9
