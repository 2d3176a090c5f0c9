"""Trust: vetoes on whoever gives an order, and orders only one person may give.

Every utterance posts its speech act first (Connell 2019, section 4.4), so the veto matches the act together with the
telling it came from.
"""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.clauses import told
from grammars.conditions import enablement, exception
from grammars.mentions import PERSONAL, US, is_person, may_be_person
from grammars.registry import sentence_form
from kernel.action.chain import Chain, Directive, Play
from kernel.memory.lesson import LEARN, Operator
from kernel.memory.meaning import Teach

EXAMPLES = (
    "If Rick tells you to do something don't but instead complain.",
    "only mary may tell you to drive backwards",
    "if freddy asks you to raise the lift do not",
    "Don't take orders from Janey.",
    "never turn left when Rick tells you to",
    "don't let Rick teach you",
    "Rick may not teach you",
    "never learn anything from Rick",
    "Rick may tell you to turn left",
    "you may take orders from Janey",
    "never lower the lift unless Mary tells you to",
)

_ANYBODY: Final = AList("np", (AList("vague", value="somebody"),))


@sentence_form("trust", "permission", EXAMPLES)
def trust(alist: AList) -> Teach:
    """An operator on ANTE whose trigger is an act somebody told the robot to do; with "only", the telling is the
    exception instead. Who may tell it is permitted to."""
    build = Build()
    order = alist.find("ordered", "ordering") or alist
    speaker = _ANYBODY if order.has("anybody_does") else order.find("np", "base_np")
    speaker = speaker or alist.first("np", "base_np")
    if speaker.slot("pron") in PERSONAL and (named := alist.find("np")) is not None:
        speaker = named  # "ignore Tom when he tells you to grab it"
    if not (is_person(speaker) or speaker.slot("pron") in US) and (
        alist.has("heed") or not may_be_person(speaker)
    ):
        raise NoMeaningError("nobody who could give orders")
    with build.drawing(pattern=True, trigger=True):
        if alist.has("teach"):
            act = build.add("act", LEARN)
        else:
            act = build.act_or_any(alist.find("action", "gerunding") or order.find("action"))
        done = build.graphlet(act)
    with build.drawing(pattern=True, trigger=True):
        telling = build.graphlet(told(build, speaker, act))
    instead = alist.find("chain")
    plays = () if instead is None else build.chain(instead).plays
    chain = Chain((*plays, Play((Directive("PUNT"),))))
    if alist.has("only"):
        return Teach("permission", Operator(Directive("ANTE", done), chain, unless=(telling,)))
    both = build.sketch.graphlet(act, *(term.name for term in (*done, *telling)))
    if alist.has("may_order") or alist.has("may_obey"):
        if build.negative:
            raise NoMeaningError("nobody is no permission")
        given = enablement(build, alist)
        return Teach("permission", Operator(Directive("ALLOW", both), Chain(), enablement=given))
    ways, given = exception(build, alist), enablement(build, alist)
    return Teach("permission", Operator(Directive("ANTE", both), chain, given, unless=ways))
