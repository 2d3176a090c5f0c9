"""Lessons are found again by what they might be equal to or contradict: as all of them compared one by one."""

import pytest

from kernel.memory.lesson import Content, Lesson
from kernel.memory.likeness import alike, contradicts
from kernel.memory.notation import read
from kernel.memory.shelves import Shelves

RULE = "if: ako-1 -lex- {}; -ako-> obj-2; then: ako-3 -lex- {}; {}-ako-> obj-2; belief: {}"
OPERATOR = "trig: {}[ act-1 -lex- {}; -obj-> obj-2 ]; pref: 1.0; ---; {}"


def content(text: str) -> Content:
    return read("\n".join(line.strip() for line in text.replace(";", "\n").splitlines()))


LESSONS = [
    Lesson(number, "rule", content(text))
    for number, text in enumerate(
        [
            RULE.format("girl", "person", "", 1.0),
            RULE.format("girl", "person", "", 0.8),
            RULE.format("girl", "person", "-neg- yes; ", 1.0),
            RULE.format("boy", "person", "-neg- yes; ", 1.0),
            OPERATOR.format("ANTE", "lift", "PUNT[ ]"),
            OPERATOR.format("ALLOW", "lift", ""),
            OPERATOR.format("ALLOW", "grab", ""),
            "ako-1 -lex- girl; -ako-> obj-2; obj-2 -lex- mary",
            "ako-5 -lex- girl; -ako-> obj-1; obj-1 -lex- mary",
        ],
        1,
    )
]


@pytest.mark.parametrize("lesson", LESSONS, ids=lambda lesson: str(lesson.ident))
def test_what_stands_on_the_shelves_is_what_comparing_all_finds(lesson: Lesson) -> None:
    shelves = Shelves()
    others = [other for other in LESSONS if other is not lesson]
    for other in LESSONS:
        shelves.add(other)
    shelves.remove(lesson)
    newest_first = others[::-1]
    assert shelves.alike(lesson.content) == [
        x for x in newest_first if alike(x.content, lesson.content)
    ]
    if lesson.ident < 8:
        assert shelves.contradicting(lesson.content) == next(
            (x for x in newest_first if contradicts(x.content, lesson.content)), None
        )


def test_lessons_are_found_by_the_words_in_them_and_operators_by_those_of_the_trigger() -> None:
    shelves = Shelves()
    for lesson in LESSONS:
        shelves.add(lesson)
    assert [x.ident for x in shelves.mentioning(frozenset(("girl", "person")))] == [3, 2, 1]
    assert [x.ident for x in shelves.mentioning(frozenset(("lift",)))] == [6, 5]
    assert [x.ident for x in shelves.triggered(frozenset(("lift", "grab", "girl")))] == [7, 6, 5]
    shelves.remove(LESSONS[5])
    assert [x.ident for x in shelves.triggered(frozenset(("lift",)))] == [5]
