"""After: operators on POST, run whenever such an action has been tried."""

from __future__ import annotations

from grammars.alist import AList
from grammars.build import Build
from grammars.registry import sentence_form
from grammars.triggers import around
from kernel.memory.meaning import Teach

EXAMPLES = (
    "after you release something back up",
    "after turning left raise the lift",
    "say all done after you dance",
    "after you drop something, say oops unless nobody is near",
    "After you grab Mary's cup, say thank you then drive backwards.",
)


@sentence_form("after", "after", EXAMPLES)
def after(alist: AList) -> Teach:
    """An operator on POST; the action may stand in the sentence after what is to be done."""
    return Teach("after", around(Build(), alist, "POST"))
