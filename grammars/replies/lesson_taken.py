"""A lesson was learned: read back in full on the screen; aloud in full only where it forbids or permits."""

from __future__ import annotations

from grammars.render import gist, render
from grammars.replies import Said, aloud, renders, sentence
from kernel.memory.reply import LessonTaken


@renders(LessonTaken)
def lesson_taken(reply: LessonTaken) -> Said:
    """ "Okay. When something is very close, I will drive backward." """
    lesson = reply.lesson
    full = render(lesson.content, "robot")
    in_full = lesson.kind in ("prohibition", "permission")
    return Said(
        f"Okay. {sentence(full)}",
        f"Okay. {aloud(full if in_full else gist(lesson.content))}",
    )
