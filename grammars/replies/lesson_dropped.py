"""A doubtful lesson was not kept."""

from __future__ import annotations

from grammars.replies import Said, both, renders
from kernel.memory.reply import LessonDropped


@renders(LessonDropped)
def lesson_dropped(reply: LessonDropped) -> Said:
    """ "Okay, I will not keep that." """
    del reply
    return both("okay, I will not keep that")
