"""Lessons written as English and learned again: the policy is the same, whatever was taught."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from daemon.lessonfile import Line, NotTextError, read_lines, written
from daemon.lessons import Row, rows
from daemon.teaching import changed, lesson_of, plan
from grammars.errors import NotUnderstoodError
from grammars.knowledge import born
from grammars.parse import parse
from grammars.vocabulary import from_policy
from kernel.memory.change import Change
from kernel.memory.lesson import Content, Graphlet, Lesson
from kernel.memory.meaning import Meaning
from kernel.memory.notation import read, write
from tests.grammars import nets

SENTENCES = Path(__file__).parents[1] / "grammars" / "sentences.tsv"


def policy(lessons: Iterable[Lesson]) -> Counter[tuple[str, str]]:
    """What is in force, identity, time and adaptation aside."""
    return Counter((lesson.kind, write(lesson.content)) for lesson in lessons)


def stored(lessons: Sequence[Lesson], teacher: str = "") -> tuple[Row, ...]:
    """The rows of a store that was taught these, one after another."""
    return rows(
        [
            Change(
                n,
                teacher,
                x.words,
                60.0 * n,
                (Lesson(n, x.kind, x.content, x.words, teacher, 60.0 * n),),
            )
            for n, x in enumerate(lessons, start=1)
        ]
    )


def text_of(table: Sequence[Row]) -> str:
    return "".join(f"{line}\n" for line in written(table))


def assert_learned_again(lessons: Sequence[Lesson]) -> None:
    text = text_of(stored(lessons))
    planned = plan(read_lines(text.encode()), ())
    assert not planned.wrong, text
    assert not planned.known
    assert policy(x for _, x in planned.new) == policy(lessons), text


def as_lesson(meaning: Meaning) -> Lesson:
    lesson = lesson_of(meaning, "")
    assert lesson is not None
    return lesson


drawn = st.one_of(
    *(nets.procedures, nets.arounds, nets.reactions, nets.prohibitions),
    *(nets.permissions, nets.trusts, nets.rules, nets.facts),
).map(as_lesson)


@settings(max_examples=60, deadline=None)
@given(st.lists(drawn, min_size=1, max_size=6))
def test_any_lessons_are_learned_again(lessons: list[Lesson]) -> None:
    assert_learned_again(lessons)
