"""A request was given up."""

from __future__ import annotations

from grammars.replies import Said, both, renders
from kernel.memory.reply import Dropped


@renders(Dropped)
def dropped(reply: Dropped) -> Said:
    """ "I have dropped "drive forward"." """
    if not reply.request:
        return both("there was nothing to drop")
    return both(f'I have dropped "{reply.request.rstrip(".!?")}"')
