"""What are you doing, what did you do, did you turn left, how many times, when."""

from __future__ import annotations

from kernel.asking import Asking, answers
from kernel.memory.experience import Deed
from kernel.memory.explanation import Because, Counted, Extent, Moment
from kernel.memory.meant import is_like
from kernel.memory.reply import Answer, Reply


@answers("doing")
def doing(asking: Asking) -> Answer:
    """Whole deeds that are going on, oldest first."""
    experience = asking.commons.experience
    acts = [deed.act for deed in experience if deed.going_on and experience.is_whole(deed)]
    return Answer(asking.question, "found" if acts else "unknown", tuple(acts[::-1]))


@answers("doing", "yesno")
def is_doing(asking: Asking) -> Answer:
    """Whether such a deed is going on: "are you turning"."""
    going_on = any(deed.going_on for deed in asking.deeds())
    return Answer(asking.question, "yes" if going_on else "no")


@answers("did", "what", "how", "where", "which", "who")
def did_what(asking: Asking) -> Reply:
    """The newest whole deed that has ended, or why it came to nothing."""
    deed = next((d for d in asking.deeds() if not d.going_on), None)
    if deed is None:
        return Answer(asking.question, "unknown")
    if deed.done:
        return Answer(asking.question, "found", (deed.act,))
    return Because(asking.question, asking.asked, deed, asking.commons.experience.root(deed))


@answers("did", "yesno")
def did(asking: Asking) -> Reply:
    """Yes if it was ever done to its end; else what became of the newest attempt."""
    found = list(asking.deeds())
    deed = next((d for d in found if d.done), None) or next(iter(found), None)
    if deed is None:  # of what is no deed of its own ("did you see Mary") there is no record
        act = asking.act
        return Answer(asking.question, "no" if act is None or asking.ways_to(act) else "unknown")
    if deed.done:
        return Answer(asking.question, "yes", (deed.act,))
    return Because(asking.question, asking.asked, deed, asking.commons.experience.root(deed))


@answers("did", "howmany")
def how_many_times(asking: Asking) -> Counted:
    """Done to the end; a deed and its own steps count once, "turn left twice" counts twice."""
    act, experience = asking.act, asking.commons.experience
    times = 0
    for deed in asking.deeds():
        part_of_one = act is not None and any(
            is_like(act, above.understood) for above in experience.ancestors(deed)
        )
        if deed.done and not part_of_one:
            times += _count(deed)
    return Counted(asking.question, times)


@answers("did", "when")
def when(asking: Asking) -> Moment:
    """When it was begun last."""
    deed = next((d for d in asking.deeds() if d.done or d.going_on), None)
    return Moment(asking.question, asking.asked, deed)


@answers("extent")
@answers("lasting")
@answers("takes")
def extent(asking: Asking) -> Extent:
    """How far, or how long: of the newest that was done to its end."""
    deed = next((deed for deed in asking.deeds() if deed.done), None)
    return Extent(asking.question, deed)


def _count(deed: Deed) -> int:
    for term in deed.act:
        if ("cnt", deed.act.main) in term.links and term.literal and term.literal.isdigit():
            return int(term.literal)
    return 1
