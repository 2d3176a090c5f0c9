"""How often something was done."""

from __future__ import annotations

from grammars.render.reasons import asked_act
from grammars.replies import Said, both, renders
from kernel.memory.explanation import Counted

_TIMES = {1: "once", 2: "twice"}


@renders(Counted)
def counted(reply: Counted) -> Said:
    """ "I turned left twice." """
    if not reply.times:
        return both(f"I did not {asked_act(reply.question.about)}")
    times = _TIMES.get(reply.times, f"{reply.times} times")
    return both(f"I {asked_act(reply.question.about, 'past')} {times}")
