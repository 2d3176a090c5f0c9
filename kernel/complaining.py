"""A failed or refused act is a fact like others: NOTE[self, fail, act, because ...]. People may teach what to do then.

The fact is `fail -lex- fail, -agt-> self, -obj-> the act, -because-> why`, `why -lex- <reason in words>` (ours;
docs/net.md). What the robot is born with, to tell why, gives way to everything that is taught.
"""

from __future__ import annotations

from typing import Final

from kernel.action.chain import Directive, sequence
from kernel.action.step import DIRECTIVES, Run
from kernel.commons import Commons
from kernel.memory.attention import Failure, Focus
from kernel.memory.lesson import Operator
from kernel.memory.reply import Failed, Refused, Reply
from kernel.net.describing import describe
from kernel.net.graphlet import Graphlet, Term
from kernel.net.node import Node
from kernel.running import Frame
from kernel.stepping import RunningStep

# Below the least preference that is considered: followed only where nothing that was taught applies and succeeds.
TELLING_FAILURES: Final = Operator(
    Directive("NOTE", Graphlet((Term("act-1", frozenset({"fail"})),), "act-1")),
    sequence(Directive("EXCUSE")),
    preference=0.1,
)


def complain(
    mind: object, commons: Commons, focus: Focus, failure: Failure, act: Node | None
) -> Run:
    """Note that the act failed and follow the advice on that; taught advice first, then what the robot is born with."""
    memory = commons.memory
    why = memory.net.new("why", failure.reason.replace("_", " "))
    links = {"agt": memory.me, "because": why} | ({"obj": act} if act is not None else {})
    fail = memory.net.new("act", "fail", **links)
    focus.nodes |= dict.fromkeys((fail, why, *([act] if act is not None else ())))
    memory.changed()
    step = RunningStep(Frame(commons, focus, {}), Directive("NOTE"))
    step.selection.facts = (fail,)
    verdict = yield from DIRECTIVES["NOTE"](step)
    if not step.advised and step.desperate():
        step.selection.within = tuple(step.followed)  # what failed is not tried again
        verdict = yield from DIRECTIVES["NOTE"](step)
    return verdict


def failed_act(focus: Focus) -> Node | None:
    """The act that failed; where none had begun, what was commanded, as it was said."""
    if focus.failure is not None and focus.failure.act is not None:
        return focus.failure.act
    return next(focus.speech_act.to("cmd"), None) if focus.speech_act is not None else None


def explanation(commons: Commons, failure: Failure) -> Reply:
    """Why, as the robot tells it unless it was taught otherwise."""
    act = describe(failure.act, news=commons.news) if failure.act is not None else None
    if failure.reason == "prohibited" and failure.by is not None and act is not None:
        return Refused(act, failure.by, failure.because)
    return Failed(act, failure.reason, failure.detail, failure.about)
