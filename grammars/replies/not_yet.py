"""Understood, but beyond this version: said honestly."""

from __future__ import annotations

from typing import Final

from grammars.replies import Said, both, renders
from kernel.memory.reply import NotYet

_BEYOND: Final = {
    "resume": "go on with what was interrupted",
    "learned": "list what I learned",
    "cancel": "drop a request",
}


@renders(NotYet)
def not_yet(reply: NotYet) -> Said:
    """ "I understood, but I can't drop a request yet." """
    asked = "answer that" if "question" in reply.what else "do that"
    return both(f"I understood, but I can't {_BEYOND.get(reply.what, asked)} yet")
