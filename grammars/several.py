"""What an order does to several things: "pick up the blocks" picks up each of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final

from grammars.alist import AList
from grammars.mentions import is_group
from grammars.sorts import agrees, classes, is_nothing, kind, usages
from kernel.action.chain import Chain, Loop, Play

if TYPE_CHECKING:
    from grammars.things import Things

NOT_EACH: Final = ("telling", "gathering")  # done to all at once: "count the blocks"


def spread(build: Things, action: AList) -> AList:
    """The deed as it is done to each of the things it is done to; the same where they are one, or taken as one, or were
    spoken of before."""
    if (speech := action.find("speech", "speaking")) is not None:
        heard = _heard(speech)
        return AList(action.name, tuple(heard if part is speech else part for part in action))
    if any(part.name == "every" for part in action.walk()):
        return action  # "look for my shoes in every room"
    np = action.find("np")
    if np is None or not _is_several(np) or kind(np) in classes()["pairs"]:
        return action
    if build.same(np) is not None or not usages(action.slot("act")).isdisjoint(NOT_EACH):
        return action
    return AList(action.name, tuple(_each(np) if part is np else part for part in action))


def _heard(speech: AList) -> AList:
    """What is said to each of those who hear it."""
    hearer = speech.find("hearer")
    np = None if hearer is None else hearer.find("np")
    if np is None or not _is_several(np):
        return speech
    each = AList("hearer", (_each(np),))
    return AList(speech.name, tuple(each if part is hearer else part for part in speech))


def _is_several(np: AList) -> bool:
    return is_group(np) and np.has("akos") and agrees(np) and not is_nothing(np)


def _each(np: AList) -> AList:
    return AList("every", tuple(part for part in np if part.name != "det"))


def gathered(plays: Sequence[Play]) -> list[Play]:
    """With what is done later to each of several things as part of the same round: "pick up the toys, then put them in
    the box"."""
    for at, play in enumerate(plays):
        loop = play.required[0]
        if not isinstance(loop, Loop) or loop.each is None:
            continue
        again = [
            later for later, other in enumerate(plays) if later > at and _tells_of(other, loop)
        ]
        if again:
            end = again[-1] + 1
            body = Chain((*loop.body.plays, *plays[at + 1 : end]))
            whole = Play((replace(loop, body=body),))
            return gathered([*plays[:at], whole, *plays[end:]])
    return list(plays)


def _tells_of(play: Play, loop: Loop) -> bool:
    """It is about each of the things of the loop."""
    assert loop.each is not None
    graphlets = Chain((play,)).graphlets()
    return any(loop.each.main in graphlet.mentioned for graphlet in graphlets)
