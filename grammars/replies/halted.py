"""Everything was stopped."""

from __future__ import annotations

from grammars.replies import Said, both, renders
from kernel.memory.reply import Halted


@renders(Halted)
def halted(reply: Halted) -> Said:
    """ "I have stopped." """
    return both("I have stopped" if reply.was_busy else "I was doing nothing")
