"""Manners returned."""

from __future__ import annotations

from typing import Final

from grammars.render.names import proper
from grammars.replies import Said, both, renders
from kernel.memory.reply import Greeted

_ANSWERS: Final = {
    "hello": "hello",
    "thanks": "you're welcome",
    "bye": "goodbye",
    "sorry": "no problem",
}


@renders(Greeted)
def greeted(reply: Greeted) -> Said:
    """ "Hello Mary." """
    answer = _ANSWERS[reply.social.act]
    return both(f"{answer} {proper(reply.name)}" if reply.name else answer)
