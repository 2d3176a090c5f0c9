"""A change was undone: what does not count any more, what counts again."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from grammars.render import render
from grammars.replies import Said, aloud, renders, sentence
from kernel.memory.lesson import Lesson
from kernel.memory.reply import TakenBack

_NAMED: Final = 2  # so many lessons are told in full


@renders(TakenBack)
def taken_back(reply: TakenBack) -> Said:
    """ "I take back: when something is very close, I will drive backward." """
    parts = []
    if reply.left:
        many = len(reply.left) > _NAMED
        parts.append(
            f"I take back {_number(reply.left)}" if many else f"I take back: {_named(reply.left)}"
        )
    if reply.entered:
        many = len(reply.entered) > _NAMED
        again = f"{_number(reply.entered)} count again" if many else ""
        parts.append(again or f"that counts again: {_named(reply.entered)}")
    if not parts:
        parts.append("I take that back")
    return Said(" ".join(map(sentence, parts)), " ".join(map(aloud, parts)))


def _number(lessons: Sequence[Lesson]) -> str:
    """ "3 lessons"; where facts are among them, "3 things"."""
    return f"{len(lessons)} {'things' if any(x.kind == 'fact' for x in lessons) else 'lessons'}"


def _named(lessons: Sequence[Lesson]) -> str:
    return "; and ".join(render(lesson.content, "robot") for lesson in lessons)
