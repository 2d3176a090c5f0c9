"""A change was undone: what does not count any more, what counts again."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from grammars.render import render
from grammars.replies import Said, aloud, listed, renders, sentence
from kernel.memory.lesson import Lesson
from kernel.memory.reply import TakenBack

_NAMED: Final = 2  # so many lessons are told in full


@renders(TakenBack)
def taken_back(reply: TakenBack) -> Said:
    """ "I take back: when something is very close, I will drive backward." """
    parts = []
    if reply.left:
        parts.append(f"I take back{_lessons(reply.left)}")
    if reply.entered:
        parts.append(f"that counts again{_lessons(reply.entered)}")
    if not parts:
        parts.append("I take that back")
    return Said(" ".join(map(sentence, parts)), " ".join(map(aloud, parts)))


def _lessons(lessons: Sequence[Lesson]) -> str:
    if len(lessons) > _NAMED:
        return (
            f" {len(lessons)} lessons"
            if all(x.kind != "fact" for x in lessons)
            else (f" {len(lessons)} things")
        )
    return f": {listed([render(lesson.content, 'robot') for lesson in lessons])}"
