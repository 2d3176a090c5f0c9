"""Understood, but beyond this version: said honestly."""

from __future__ import annotations

from grammars.replies import Said, aloud, renders, sentence
from kernel.memory.reply import NotYet


@renders(NotYet)
def not_yet(reply: NotYet) -> Said:
    """ "I understood, but I can't do that yet." """
    said = "I understood, but I can't do that yet"
    return Said(sentence(f"{said}: {reply.what}" if reply.what else said), aloud(said))
