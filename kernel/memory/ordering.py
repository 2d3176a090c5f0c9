"""Steps of a lesson in another order: "swap the first two steps", "the wave should come before the bow". Pure; ours."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from kernel.action.chain import Chain, Directive, Play
from kernel.memory.editing import meant
from kernel.memory.lesson import Operator, graphlets
from kernel.memory.meaning import Beside
from kernel.net.graphlet import Graphlet


def reordered(
    operator: Operator, step: Graphlet, mark: Graphlet | None, beside: Beside
) -> Operator | None:
    """The operator with that step moved before or after the one that the mark describes, or to the end; beside
    nothing, the two change places. None where one of them is no play of its own, or both are the same."""
    plays, drawn = list(operator.chain.plays), tuple(graphlets(operator))
    at = _place(plays, meant(step, operator.chain, drawn))
    other = len(plays)
    if mark is not None:
        other = _place(plays, meant(mark, operator.chain, drawn))
    if at < 0 or other < 0 or at == other:
        return None
    if mark is not None and not beside:
        plays[at], plays[other] = plays[other], plays[at]
    else:
        moving = plays.pop(at)
        other -= at < other
        plays.insert(other + (beside == "after"), moving)
    return replace(operator, chain=Chain(tuple(_looked_up_first(plays))))


def _place(plays: list[Play], is_it: Callable[[Graphlet], bool]) -> int:
    for at, play in enumerate(plays):
        step = _alone(play, "DO")
        if step is not None and is_it(step):
            return at
    return -1


def _alone(play: Play, tag: str) -> Graphlet | None:
    """What the directive of that tag is about, of which the play consists."""
    only = play.only
    return only.graphlet if isinstance(only, Directive) and only.tag == tag else None


def _looked_up_first(plays: list[Play]) -> list[Play]:
    """Every look-up before the first play that speaks of its thing."""
    made = list(plays)
    for play in plays:
        if (found := _alone(play, "FIND")) is None:
            continue
        users = [
            at
            for at, other in enumerate(made)
            if other is not play
            and any(found.main in graphlet.mentioned for graphlet in Chain((other,)).graphlets())
        ]
        at = made.index(play)
        if users and users[0] < at:
            made.insert(users[0], made.pop(at))
    return made
