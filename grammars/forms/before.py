"""Before: operators on ANTE, run whenever such an action is about to begin."""

from __future__ import annotations

from grammars.alist import AList
from grammars.build import Build
from grammars.registry import sentence_form
from grammars.triggers import around
from kernel.memory.meaning import Teach

EXAMPLES = (
    "before you grab something open the gripper",
    "before driving forward say beep beep",
    "always say excuse me before you turn around",
    "before you turn around, lower the lift if you are holding something",
    "before you turn left say left unless nobody is near",
)


@sentence_form("before", "before", EXAMPLES)
def before(alist: AList) -> Teach:
    """An operator on ANTE; the action may stand in the sentence after what is to be done."""
    return Teach("before", around(Build(), alist, "ANTE"))
