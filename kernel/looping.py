"""Loops: a chain again and again (mind.md: "chains may loop (repeat n times, until, while, for each)")."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import repeat
from typing import TYPE_CHECKING, Final

from kernel.action.chain import Chain, Directive, Loop
from kernel.action.step import Run, break_off
from kernel.action.verdict import Verdict
from kernel.memory.recall import is_so, missing, now_so, referents
from kernel.net.match import Binding
from kernel.net.node import Node

if TYPE_CHECKING:
    from kernel.running import Frame

MOST_IDLE: Final = 100  # mind.md: rounds one after another in which no time passes


def looped(frame: Frame, loop: Loop) -> Run:
    """Round after round, until its number is full, its condition ends it, or a round fails.

    The condition is watched all the time: once it ends the loop, the body ends in that very tick and the loop succeeds;
    where that is so at the start, it does so at once and nothing moves. "For each" takes its list when it begins,
    newest mention first, no more than its number; there being none fails it. So do 100 rounds, one after another, that
    take no time.
    """
    rounds = _rounds(frame, loop)
    if rounds is None:
        return Verdict.FAILED
    clock, endless, idle = frame.commons.tick, _is_open(loop), 0

    def over() -> bool:
        return _holding(frame, loop) is None

    made: list[list[Node]] = [[], []]  # in the round before, and in this one
    try:
        while (held := _holding(frame, loop)) is not None:
            binding = next(rounds, None)
            if binding is None:
                break
            began_s = clock.now_s
            frame.put_away(made[0])
            made.reverse()
            inner = frame.inner({**held, **binding}, made[1])
            inner.endless = endless
            inner.overs = (*frame.overs, over)
            run = inner.chain(loop.body)
            verdict = yield from break_off(run, over)
            if not verdict.ok:
                return verdict
            idle = idle + 1 if clock.now_s == began_s else 0
            if idle >= MOST_IDLE:
                frame.explain("runaway", None)
                return Verdict.FAILED
    finally:
        if frame.made is not None:
            frame.made += [node for nodes in made for node in nodes]
    return Verdict.SUCCEEDED


def _rounds(frame: Frame, loop: Loop) -> Iterator[Binding] | None:
    """The binding each round starts with; None where there is nothing to do it for."""
    if loop.each is not None:
        threshold = frame.commons.settings.threshold
        found = [
            binding
            for binding in referents(loop.each, frame.commons.memory, frame.binding, threshold)
            if is_so({loop.each.main: binding[loop.each.main]})
        ]
        for binding in found:
            frame.mention(binding[loop.each.main])
        if not found:
            frame.explain("nothing_found", None, missing(Directive("FIND", loop.each)))
            return None
        return iter(found[: loop.times])
    if loop.times is not None:
        return repeat(frame.binding, loop.times)
    return repeat(frame.binding)


def _holding(frame: Frame, loop: Loop) -> Binding | None:
    """What its condition binds while the loop goes on; None once it is over."""
    memory, threshold = frame.commons.memory, frame.commons.settings.threshold
    if loop.until is not None and now_so(loop.until, memory, frame.binding, threshold) is not None:
        return None
    return {} if loop.whilst is None else now_so(loop.whilst, memory, frame.binding, threshold)


def _is_open(loop: Loop) -> bool:
    """Whether its body is one action without an amount, so that the body may go on with it without a break.

    mind.md: "until/keep have no distance limit".
    """
    if loop.times is not None or loop.each is not None:
        return False
    step = _only_step(loop.body)
    if step is None or step.tag != "DO" or step.graphlet is None:
        return False
    return not any(role in ("amt", "cnt") for term in step.graphlet for role, _ in term.links)


def _only_step(chain: Chain) -> Directive | None:
    part = chain.plays[0].only if len(chain.plays) == 1 else None
    return part if isinstance(part, Directive) else None
