"""What the robot says to tell that something is so: "if you see a spider, tell me", "wait until it is dark, then tell
me"."""

from __future__ import annotations

from collections.abc import Sequence

from grammars.alist import AList
from grammars.errors import NoMeaningError
from grammars.render.clauses import conditions
from grammars.render.telling import Telling
from kernel.action.chain import Directive, Loop, Play
from kernel.net.graphlet import Graphlet


def so_told(so: Graphlet, found: tuple[Graphlet, ...] = ()) -> AList:
    """The chain that says it: "I see a spider".

    found: what describes its things.
    """
    said = conditions(Telling((so, *found), (), "robot"), so)
    action = AList("action", (AList("speech", (AList("say"), AList("quote", value=said))),))
    return AList("chain", (AList("play", (action,)),))


def reported(plays: Sequence[Play]) -> AList:
    """The chain that says what was waited for, or what something was done until."""
    parts = plays[-1].required if plays else ()
    match parts:
        case [Directive("WAIT", Graphlet() as so)]:
            pass
        case [Loop(until=Graphlet() as so)]:
            pass
        case _:
            raise NoMeaningError("nothing to tell")
    found = (
        part.graphlet for play in plays for part in play.required if isinstance(part, Directive)
    )
    return so_told(so, tuple(graphlet for graphlet in found if graphlet is not None))
