"""Trust: vetoes on whoever gives an order, and orders only one person may give.

Every utterance posts its speech act first (Connell 2019, section 4.4), so the veto matches the act together with the
telling it came from.
"""

from __future__ import annotations

from grammars.alist import AList
from grammars.build import Build
from grammars.registry import sentence_form
from kernel.action.chain import Chain, Directive, Play
from kernel.memory.lesson import Operator
from kernel.memory.meaning import Teach

EXAMPLES = (
    "If Rick tells you to do something don't but instead complain.",
    "only mary may tell you to drive backwards",
    "if freddy asks you to raise the lift do not",
    "Don't take orders from Janey.",
    "never turn left when Rick tells you to",
)


@sentence_form("trust", "permission", EXAMPLES)
def trust(alist: AList) -> Teach:
    """An operator on ANTE whose trigger is an act somebody told the robot to do."""
    build = Build()
    order = alist.find("ordered", "ordering") or alist
    speaker = order.find("np") or alist.first("np")
    only = alist.has("only")
    with build.drawing(pattern=True):
        act = _act(build, alist.find("action") or order.find("action"))
        trigger = list(build.board)
        teller = build.thing(speaker, person=True)
        told = build.add("act", "tell", agt=teller, dest=build.oneself("you"), cmd=act)
        telling = list(build.board)
    instead = alist.find("chain")
    plays = () if instead is None else build.chain(instead).plays
    chain = Chain((*plays, Play((Directive("PUNT"),))))
    if only:
        rest = [name for name in telling if name not in trigger]
        operator = Operator(
            Directive("ANTE", build.sketch.graphlet(act, *trigger)),
            chain,
            unless=(build.sketch.graphlet(told, *rest),),
        )
    else:
        operator = Operator(Directive("ANTE", build.sketch.graphlet(act, *telling)), chain)
    return Teach("permission", operator)


def _act(build: Build, action: AList | None) -> str:
    """The act that is ordered; any act at all where none is named."""
    return build.add("act") if action is None else build.action(action)
