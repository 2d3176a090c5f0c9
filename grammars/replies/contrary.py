"""The opposite of a word."""

from __future__ import annotations

from grammars.replies import Said, both, listed, renders
from kernel.memory.explanation import Contrary


@renders(Contrary)
def contrary(reply: Contrary) -> Said:
    """ "The opposite of left is right." """
    if not reply.contraries:
        return both(f"I know no opposite of {reply.word}")
    return both(f"the opposite of {reply.word} is {listed(reply.contraries, 'or')}")
