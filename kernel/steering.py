"""Steering what is going on: dropping the newest request, going on with what was interrupted, stopping one activity.

A stop leaves nothing behind that goes on by itself; only "go on" does, said by a person.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final, Protocol

from kernel.action.arbiter import Claim
from kernel.action.call import Bid, Halt
from kernel.action.step import Run
from kernel.action.verdict import Verdict
from kernel.commons import Commons
from kernel.memory.attention import Focus, Progress
from kernel.memory.reply import Dropped, Halted, Resumed
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding
from kernel.running import Frame
from kernel.stopping import stop_matching

KEPT: Final = 8  # commands that can be gone on with, one after another


class Steered(Protocol):
    """What a mind lets steering do."""

    def active(self) -> list[Focus]:
        """Foci not handled yet, newest first."""

    def close(self, focus: Focus, verdict: Verdict) -> None:
        """End a focus."""


def remember_interrupted(commons: Commons, foci: Iterable[Focus], afresh: bool = False) -> None:
    """Commands that were broken off, oldest first; afresh: what was broken off before is past."""
    broken = [focus.progress for focus in foci if focus.progress is not None]
    if broken:
        commons.interrupted[:] = [*([] if afresh else commons.interrupted), *broken][-KEPT:]


def drop_newest(mind: Steered, commons: Commons, focus: Focus) -> None:
    """ "Never mind": the newest request that is not finished ends as stopped; what else goes on goes on."""
    waiting = [other for other in mind.active() if other is not focus and other.heard is not None]
    for newest in waiting[:1]:
        words = newest.progress.words if newest.progress else newest.words
        mind.close(newest, Verdict.STOPPED)
        commons.replies.append(Dropped(words))
    if not waiting:
        commons.replies.append(Dropped(""))


def go_on(commons: Commons, focus: Focus) -> Run:
    """ "Go on": the command that was broken off last, from the play on in which it was; asked again, the one before it.

    Where what its look-ups had found is forgotten, it starts afresh, and says so. It is under the vetoes on whoever
    says "go on".
    """
    if not commons.interrupted:
        commons.replies.append(Resumed(""))
        return Verdict.SUCCEEDED
    last = commons.interrupted.pop()
    binding = _still_known(commons, last)
    afresh = binding is None
    commons.replies.append(Resumed(last.words, afresh and last.at > 0))
    frame = Frame(commons, focus, {} if binding is None else binding)
    return (yield from frame.command(last.chain, last.words, 0 if afresh else last.at))


def _still_known(commons: Commons, last: Progress) -> Binding | None:
    """What its look-ups had found, if all of it is still in memory."""
    in_memory = set(commons.memory.net)
    return dict(last.binding) if in_memory.issuperset(last.binding.values()) else None


def stop_doing(commons: Commons, focus: Focus, what: Graphlet) -> None:
    """ "Stop turning": only what matches ends. Where nothing does but something is going on, all motion ends: a person
    who says stop may not have the robot's word for what it does (safety first; ours)."""
    under_way = [doing for doing in commons.doing if doing.focus is not focus]
    if not stop_matching(commons, what) and under_way:
        commons.claims.append(Claim(focus.number, Bid("wheels", Halt(), commons.next_number())))
        commons.replies.append(Halted(True))
        return
    commons.replies.append(Halted(bool(under_way), what))
