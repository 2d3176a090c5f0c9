"""Reactions: operators on NOTE, in force all the time."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.conditions import condition, exception
from grammars.denying import denied
from grammars.hedges import preference
from grammars.pacing import HOLDING
from grammars.registry import sentence_form
from grammars.reporting import so_told
from grammars.triggers import asks_nothing
from kernel.action.chain import Chain, Directive
from kernel.memory.lesson import Operator
from kernel.memory.meaning import Teach
from kernel.net.graphlet import Graphlet

COMING: Final = ("come", "get", "move", "walk", "stand", "drive", "step", "go")
EXAMPLES = (
    "If something is very close then drive backwards",
    "when you are stuck back up then turn right",
    "When the battery is low, say feed me.",
    "if something is close and it is a person then stop and say pardon me",
    "if something is close back up unless it is a block",
    "if something is very close unless the light is red then back up",
    "Close the door whenever you see Mom coming.",
    "say bless you when someone sneezes",
    "if you fail to grab something say oops",
    "When you can't do something, say sorry.",
    "whenever you see a spider, let me know",
    "if something is close stop, otherwise drive forward",
)


@sentence_form("reaction", "reaction", EXAMPLES)
def reaction(alist: AList) -> Teach:
    """An operator on NOTE with all conditions in its trigger."""
    build = Build()
    if not alist.has("conds"):
        alist = _contrary(alist)
    conds = alist.all("conds")
    if alist.parts[0].name == "chain" and asks_nothing(alist.parts[0]):
        raise NoMeaningError("what follows is the question")
    trigger = condition(build, conds[0] if len(conds) == 1 else AList("conds", tuple(conds)))
    said = alist.find("chain")
    if said is not None and _is_close_by(conds[-1], said):
        raise NoMeaningError("comes close")
    if said is not None and _is_way(build, trigger, said):
        raise NoMeaningError("a way of doing it")
    chain = build.chain(said or so_told(trigger))
    if alist.has("also_telling"):
        chain = Chain((*chain.plays, *build.chain(so_told(trigger)).plays))
    return Teach(
        "reaction",
        Operator(
            Directive("NOTE", trigger),
            chain,
            unless=exception(build, alist),
            preference=preference(alist.slot("pref")),
        ),
    )


def _contrary(alist: AList) -> AList:
    """ "Turn left unless the light is red": if it is not red."""
    out = alist.first("exception")
    if out.has("exception"):
        raise NoMeaningError(str(alist))
    rest = tuple(part for part in alist if part is not out)
    return AList(alist.name, (denied(out.first("conds")), *rest))


def _is_way(build: Build, trigger: Graphlet, chain: AList) -> bool:
    """ "Go slower", when the robot does something: that is how it is to do it (revision)."""
    actions = [part for part in chain.walk() if part.name == "action"]
    head = trigger.head
    if len(actions) != 1 or head is None or not head.lex.isdisjoint(HOLDING):
        return False
    going = actions[0].slot("act") == "go" and [part.name for part in actions[0]][1:] == ["manner"]
    agent = dict(head.links).get("agt", "")
    return going and bool(agent) and "you" in build.sketch.terms[agent].lex


def _is_close_by(conds: AList, chain: AList) -> bool:
    """ "If something comes close, back away": nothing is to be closed."""
    first = next((part for part in chain.walk() if part.name == "action"), None)
    bare = first is not None and first.slot("act") == "close" and len(first.parts) <= 1
    return bare and any(part.value in COMING for part in conds.walk() if part.name == "does")
