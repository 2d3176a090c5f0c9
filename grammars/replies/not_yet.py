"""Understood, but beyond this version: said honestly."""

from __future__ import annotations

from typing import Final

from grammars.replies import Said, both, renders
from kernel.memory.reply import NotYet

_BEYOND: Final = {
    "feedback": "learn from praise and blame",
    "revision": "change what I was taught",
    "undo": "take a lesson back",
    "forget": "forget a lesson",
    "repeat": "repeat that",
    "learned": "list what I learned",
}


@renders(NotYet)
def not_yet(reply: NotYet) -> Said:
    """ "I understood, but I can't take a lesson back yet." """
    asked = "answer that" if "question" in reply.what else "do that"
    return both(f"I understood, but I can't {_BEYOND.get(reply.what, asked)} yet")
