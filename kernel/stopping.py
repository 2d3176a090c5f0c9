"""Ending single acts while others go on.

An act that is stopped ends with the verdict STOPPED and takes the chain it stood in along: no other operator is tried
for it, nothing that was to come after it begins, its POST operators do not run. What runs beside it in its play goes
on.
"""

from __future__ import annotations

from kernel.action.step import Run
from kernel.action.verdict import Verdict
from kernel.commons import Commons, Doing
from kernel.memory.attention import Focus
from kernel.net.graphlet import Graphlet
from kernel.net.match import holds
from kernel.net.node import Node


def stoppable(commons: Commons, focus: Focus, node: Node, run: Run) -> Run:
    """Carry out a DO so that it can be stopped from outside."""
    doing = Doing(focus, node)
    commons.doing.append(doing)
    try:
        while not doing.stopped:
            try:
                next(run)
            except StopIteration as end:
                verdict: Verdict = end.value
                return verdict
            yield
        return Verdict.STOPPED
    finally:
        run.close()
        commons.doing.remove(doing)


def stop_matching(
    commons: Commons, pattern: Graphlet, excepted: tuple[Node, ...] = ()
) -> list[Doing]:
    """Mark every act under way that matches the pattern as stopped, but for those excepted; return them.

    An act whose turn in this tick is still to come ends in this tick, another one in the next.
    """
    memory = commons.memory
    memory.refresh()
    found = [
        doing
        for doing in commons.doing
        if doing.node not in excepted
        and holds(pattern, memory.net, memory.depth, {pattern.main: doing.node})
    ]
    for doing in found:
        doing.stopped = True
        commons.record("halted", doing.focus, text=" ".join(sorted(doing.node.lex)))
    return found
