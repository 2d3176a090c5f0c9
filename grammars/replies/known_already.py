"""A lesson that was in force before."""

from __future__ import annotations

from grammars.render.names import proper
from grammars.replies import Said, both, renders
from kernel.memory.reply import KnownAlready


@renders(KnownAlready)
def known_already(reply: KnownAlready) -> Said:
    """ "I know that already from Mary." """
    teacher = reply.lesson.teacher
    return both(f"I know that already{f' from {proper(teacher)}' if teacher else ''}")
