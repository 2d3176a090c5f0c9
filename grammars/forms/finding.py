"""Advice on finding out: operators on FIND and CHK."""

from __future__ import annotations

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.hedges import preference
from grammars.inquiries import sought
from grammars.registry import sentence_form
from kernel.action.chain import Chain, Directive
from kernel.memory.lesson import Operator
from kernel.memory.meaning import Teach

EXAMPLES = (
    "to find a ball turn left",
    "to find Mary turn around then say where are you",
    "To find out whether something is close, look.",
    "to check whether the gripper is empty close the gripper",
    "to know whether a block is heavy you could lift it",
    "to find out what something is find out what color it is",
    "if you want to know what color something is look at it",
    "if you want to know what something is, determine what color it is",
    "to find out where something is look around",
)


@sentence_form("finding", "procedure", EXAMPLES)
def finding(alist: AList) -> Teach:
    """An operator on FIND for a thing or what it is like, on CHK for whether something is so."""
    build = Build()
    with build.drawing(pattern=True):
        if (np := alist.find("np")) is not None:
            trigger = Directive("FIND", build.graphlet(build.thing(np)))
        else:
            trigger = sought(build, alist)
    chains = [build.chain(part) for part in alist.all("chain")]
    if not chains or trigger.graphlet is None or not trigger.graphlet.terms:
        raise NoMeaningError(str(alist))
    chain = Chain(tuple(play for part in chains for play in part.plays))
    return Teach("procedure", Operator(trigger, chain, preference=preference(alist.slot("pref"))))
