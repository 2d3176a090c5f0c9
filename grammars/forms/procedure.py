"""Procedures: operators on DO that say how something is done, and on ACH that say how it is brought about."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.conditions import condition
from grammars.hedges import preference
from grammars.registry import sentence_form
from grammars.speaking import UNQUOTED
from kernel.action.chain import Chain, Directive
from kernel.memory.lesson import Operator
from kernel.memory.meaning import Teach

# How no name of a deed begins: "turn left when I tell you to", "when I say so".
NO_NAMES: Final = ("to", "so", "that")
EXAMPLES = (
    "To cha-cha drive forward then drive backwards",
    "To run away, you could drive backward.",
    "to greet somebody you must always say good day",
    "when i say hop raise the lift then lower the lift",
    "to retreat means to drive backwards then turn around",
    "Inspecting means driving forward slowly and then backing up.",
    "here is how to sweep turn left slowly then turn right slowly",
    "Let me teach you to stretch: raise the lift, wait one second, then lower it.",
    "another way to celebrate is to drive forward then say yay",
    "to make sure the gripper is closed, close the gripper",
    "to make the door open push it",
    "to patrol repeat drive forward then turn left four times",
    "to calm down stop turning",
)


@sentence_form("procedure", "procedure", EXAMPLES)
def procedure(alist: AList) -> Teach:
    """An operator on DO, or on ACH."""
    build = Build()
    said = alist.find("said")
    if (made := alist.find("conds", "clause")) is not None:
        conds = made if made.name == "conds" else AList("conds", (made,))
        return _taught(build, alist, Directive("ACH", condition(build, conds)))
    if (sought := _sought(alist)) is not None:
        with build.drawing(pattern=True):
            return _taught(build, alist, Directive("FIND", build.graphlet(build.thing(sought))))
    with build.drawing(pattern=True, trigger=True):
        if said is not None:
            first = said.slot("quote").lower().partition(" ")[0]
            if first in NO_NAMES or (alist.has("cried") and first in UNQUOTED):
                raise NoMeaningError(str(said))  # "if I call for help"
            act = build.add("act", said.slot("quote").lower())
        else:
            deed = alist.first("action", "gerunding")
            if any(np.slot("pron") == "you" for np in deed.all("np")):
                raise NoMeaningError(str(deed))  # "to yodel you say ..."
            build.naming = True
            act = build.action(deed)
            build.naming = False
        trigger = Directive("DO", build.graphlet(act))
    return _taught(build, alist, trigger)


def _sought(alist: AList) -> AList | None:
    """What "one way to find it" is about, as "to find it" is."""
    action = alist.find("action")
    if action is None or action.slot("act") != "find" or len(action.parts) > 2:
        return None
    return action.find("np")


def _taught(build: Build, alist: AList, trigger: Directive) -> Teach:
    """The operator, with the steps and the strength that the sentence gives."""
    chains = [build.chain(part) for part in alist.all("chain")]
    if not chains:
        raise NoMeaningError(str(alist))
    chain = Chain(tuple(play for part in chains for play in part.plays))
    strength = preference(alist.slot("pref"))
    strength = next((preference(said) for said in ("could", "might") if alist.has(said)), strength)
    return Teach("procedure", Operator(trigger, chain, preference=strength))
