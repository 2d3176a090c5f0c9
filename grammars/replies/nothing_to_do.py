"""Nothing to undo, revise, repeat or answer."""

from __future__ import annotations

from typing import Final

from grammars.replies import Said, both, renders
from kernel.memory.reply import NothingToDo

_SENTENCES: Final = {
    "undo": "there is nothing to undo",
    "revise": "I don't know what to change",
    "repeat": "there is nothing to repeat",
    "answer": "I did not ask anything",
    "motion": "I can't undo a motion. Tell me what to do instead",
    "later": "nobody taught me that, so I can't change it for next time",
    "inborn": "I can't forget what my body can do",
}


@renders(NothingToDo)
def nothing_to_do(reply: NothingToDo) -> Said:
    """ "There is nothing to undo." """
    return both(_SENTENCES[reply.what])
