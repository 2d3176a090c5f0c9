"""Lessons as rows: how each stands, and which numbers may be forgotten."""

from __future__ import annotations

import msgspec

from daemon.lessons import Row, missing, rows
from grammars.parse import parse
from kernel.memory.change import Adapted, Change
from kernel.memory.lesson import Lesson, Resting
from kernel.memory.meaning import Teach


def lesson(number: int, words: str) -> Lesson:
    meaning = parse(words).meaning
    assert isinstance(meaning, Teach)
    return Lesson(number, meaning.kind, meaning.content, words, "mary", 5.0)


FIRST, SECOND = lesson(1, "never grab a cup"), lesson(2, "to zorp, turn left")
TAUGHT = (Change(1, learned=(FIRST,)), Change(2, learned=(SECOND,)))


def standing(*changes: Change, resting: tuple[Resting, ...] = ()) -> dict[int, str]:
    return {row.ident: row.standing for row in rows(changes, resting)}


def test_a_row_says_all_there_is_to_say() -> None:
    row = rows(TAUGHT)[0]
    assert (row.ident, row.kind, row.text, row.words) == (
        1,
        "prohibition",
        *["never grab a cup"] * 2,
    )
    assert (row.teacher, row.at_s, row.strength, row.counts) == ("mary", 5.0, 1.0, True)
    assert row.lesson == rows(TAUGHT)[0].lesson
    assert msgspec.convert(msgspec.to_builtins(row), Row) == row, "it survives the control socket"


def test_what_was_taken_back_stays_and_an_undo_brings_it_back() -> None:
    gone = Change(3, retracted=(1,))
    assert standing(*TAUGHT, gone) == {1: "taken back", 2: "in force"}
    back = Change(4, undone=(3,))
    assert standing(*TAUGHT, gone, back) == {1: "in force", 2: "in force"}
    assert standing(*TAUGHT, Change(3, undone=(2,))) == {1: "in force", 2: "taken back"}


def test_the_strength_is_that_of_now() -> None:
    adapted = Change(3, adapted=(Adapted(2, 1.0, 0.4),), own=True)
    assert [row.strength for row in rows((*TAUGHT, adapted))] == [1.0, 0.4]


def test_resting_lessons_rest_unless_they_were_taken_back() -> None:
    sleeper = Resting(3, "to hover, lift off", "the body lacks hover", change=7)
    assert standing(resting=(sleeper,)) == {3: "rests"}
    assert standing(Change(8, retracted=(3,)), resting=(sleeper,)) == {3: "taken back"}
    assert standing(Change(7), Change(8, undone=(7,)), resting=(sleeper,)) == {3: "taken back"}
    (row,) = rows((), (sleeper,))
    assert (row.text, row.why, row.counts) == ("to hover, lift off", "the body lacks hover", False)


def test_numbers_that_cannot_be_forgotten_are_explained() -> None:
    sleeper = Resting(3, "to hover, lift off", "the body lacks hover", change=7)
    table = rows((*TAUGHT, Change(4, retracted=(1,))), (sleeper,))
    assert missing((2, 3), table) == []
    assert missing((1, 2, 8), table) == ["lesson 1 was taken back already", "there is no lesson 8"]
