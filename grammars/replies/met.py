"""The speaker said who he is."""

from __future__ import annotations

from grammars.render.names import proper
from grammars.replies import Said, both, renders
from kernel.memory.reply import Met


@renders(Met)
def met(reply: Met) -> Said:
    """ "Hello Rick." """
    if reply.robot:
        return both(f"okay, my name is {proper(reply.name)}")
    return both(
        f"hello {proper(reply.name)}" if reply.name else "okay, I don't know who you are now"
    )
