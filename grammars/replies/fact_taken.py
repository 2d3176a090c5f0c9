"""A fact was noted: said again in the robot's voice."""

from __future__ import annotations

from grammars.render import gist, render
from grammars.replies import Said, aloud, renders, sentence
from kernel.memory.meaning import Fact
from kernel.memory.reply import FactTaken


@renders(FactTaken)
def fact_taken(reply: FactTaken) -> Said:
    """ "Okay. Mary is a girl." """
    fact = Fact(reply.fact, reply.about)
    return Said(f"Okay. {sentence(render(fact, 'robot'))}", f"Okay. {aloud(gist(fact))}".strip())
