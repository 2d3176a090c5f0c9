"""Everything was stopped, or one activity."""

from __future__ import annotations

from grammars.render import act_in_words
from grammars.replies import Said, both, renders
from kernel.memory.reply import Halted


@renders(Halted)
def halted(reply: Halted) -> Said:
    """ "I have stopped", "I have stopped turning." """
    doing = "" if reply.about is None else act_in_words(reply.about, form="gerund")
    if reply.was_busy:
        return both(f"I have stopped {doing}".rstrip())
    return both(f"I was not {doing}" if doing else "I was doing nothing")
