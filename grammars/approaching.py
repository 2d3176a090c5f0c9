"""Driving up to something, as brackets: "drive to within a foot of the wall" goes there until it is as near."""

from __future__ import annotations

from grammars.alist import AList
from grammars.errors import NoMeaningError
from grammars.sorts import kind


def approached(play: AList) -> AList:
    """The play with such a loop for each action that is one."""
    return AList(play.name, tuple(_loop(part) if part.has("up_close") else part for part in play))


def _loop(action: AList) -> AList:
    """What it is, written out."""
    near = action.first("up_close").first("nearer")
    if action.name != "action" or action.has("dest"):
        raise NoMeaningError(str(action))
    landmark = near.first("np")
    parts = (part for part in action if part.name != "up_close")
    going = AList("action", (*parts, AList("dest", (landmark,))))
    pred = AList("pred", (AList("compared", (AList("nearer", (near.first("measure"),)),)),))
    ended = AList("conds", (AList("clause", (_again(landmark), pred)),))
    return AList("loop", (AList("play", (going,)), AList("until", (ended,))))


def _again(np: AList) -> AList:
    """The same thing once more."""
    if not (called := kind(np)):
        return np
    return AList("np", (AList("det", value="the"), AList("ako", value=called)))
