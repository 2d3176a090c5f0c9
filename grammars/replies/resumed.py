"""A request that was broken off goes on."""

from __future__ import annotations

from grammars.replies import Said, both, renders
from kernel.memory.reply import Resumed


@renders(Resumed)
def resumed(reply: Resumed) -> Said:
    """ "I go on with "drive forward"." """
    request = f'"{reply.request.rstrip(".!?")}"'
    if not reply.request:
        return both("there is nothing to go on with")
    return both(f"I start {request} again" if reply.afresh else f"I go on with {request}")
