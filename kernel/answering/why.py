"""Why did you do that, why are you turning, why didn't you grab Mary: from the firing record."""

from __future__ import annotations

from typing import Final

from kernel.answering.taught import provenance
from kernel.asking import Asking, answers
from kernel.memory.experience import Deed
from kernel.memory.explanation import Because
from kernel.memory.reply import Reply

STANDING: Final = frozenset(
    ("prohibited", "no_way", "given_up", "no_sense")
)  # reasons that need no attempt
STOPPING: Final = frozenset(("stop", "halt"))


@answers("why")
@answers("did", "why")
def why(asking: Asking) -> Reply:
    """The deed with what led to it; for what was never attempted, what would stand in its way.

    "Why did you do that" is about the newest deed that is no step of another; "why not" about the newest that came to
    nothing. A fact ("why is Mary a person") has a source instead.
    """
    if asking.main.kind != "act":
        return provenance(asking)
    if asking.act is None and asking.main.ref != "that" and (claim := asking.just_claimed):
        return provenance(asking.of(claim))
    denied = asking.main.negated
    found = list(asking.deeds())
    if not found and asking.main.lex & STOPPING:  # stopping is no deed: it ends one
        experience = asking.commons.experience
        found = [d for d in experience if d.trouble is not None and d.trouble.reason == "stopped"]
        found = [d for d in found if experience.is_whole(d) and d.ended_s != d.began_s]
    going_on = [deed for deed in found if deed.going_on]
    if denied and asking.act is None:
        found = [deed for deed in found if deed.trouble is not None]
    deed = next(iter([*(going_on if not denied else ()), *found]), None)
    if deed is None and asking.act is not None:
        return _never(asking, denied)
    return _because(asking, deed)


def _because(asking: Asking, deed: Deed | None) -> Because:
    experience = asking.commons.experience
    root = experience.root(deed) if deed is not None else None
    way = experience.way(deed) if deed is not None else None
    return Because(asking.question, asking.asked, deed, root, way=way)


def _never(asking: Asking, denied: bool) -> Because:
    """Nobody told it to, or nobody could: what a dry run says."""
    act = asking.act
    if act is None or not denied:
        return Because(asking.question, asking.asked)
    trouble = asking.imagine(asking.command(act)).trouble
    if trouble is not None and trouble.reason not in STANDING:
        trouble = None
    return Because(asking.question, asking.asked, trouble=trouble)
