"""A lesson took the place of another: what it is now, in full."""

from __future__ import annotations

from grammars.render import render
from grammars.replies import Said, aloud, renders, sentence
from kernel.memory.reply import Revised


@renders(Revised)
def revised(reply: Revised) -> Said:
    """ "Okay. To wiggle, I will turn right twice then turn right." """
    now = render(reply.lesson.content, "robot")
    return Said(f"Okay. {sentence(now)}", f"Okay. {aloud(now)}")
