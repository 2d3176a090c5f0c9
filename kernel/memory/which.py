"""Which of the things that fit equally well is meant: a question that the robot puts to a person.

The other one that it puts, what to do with a doubtful lesson, is kernel.memory.recent.Doubt; questions of a person's
about the robot are kernel.asking's.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

from kernel.memory.reply import AskWhich
from kernel.net.describing import describe
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding, holds
from kernel.net.node import REMEMBERED, Net, Node

PATIENCE_S: Final = 20.0  # ours: how long an act waits for the answer
_DESCRIBING: Final = ("ako", "hq", "loc", "own", "sub")


@dataclass(slots=True, eq=False)
class Which:
    """The question while it is open.

    Attributes:
        focus: number of the focus that waits for the answer.
        question: as it was put.
        things: those it asks about, in the question's order.
        chosen: the answer.
    """

    focus: int
    question: AskWhich
    things: tuple[Node, ...]
    chosen: Node | None = None

    def take(self, described: Graphlet, net: Net) -> Node | None:
        """The thing meant, if the description fits just one; that is the answer."""
        fitting = [n for n in self.things if _fits(described, n, net)]
        if len(fitting) == 1:
            self.chosen = fitting[0]
        return self.chosen


def equal_best(
    graphlet: Graphlet, options: Sequence[Binding], rank: Callable[[Node], int]
) -> tuple[Node, ...]:
    """The things between which only a person can decide; none where there is nothing to ask.

    Args:
        graphlet: what was said: only "the block" claims that there is just one.
        options: what fits it.
        rank: number of the newest focus that mentions a thing, 0 where it is no longer in attention.
    """
    main = graphlet.head
    if main is None or main.ref != "the" or len(options) < 2:
        return ()
    things = [option[graphlet.main] for option in options]
    best = max(map(rank, things))
    equal = tuple(node for node in things if rank(node) == best)
    told_apart = {frozenset(_description(node)) for node in equal}
    return equal if len(equal) > 1 and len(told_apart) == len(equal) else ()


def ask_which(graphlet: Graphlet, things: Sequence[Node]) -> AskWhich:
    """The question as a reply."""
    return AskWhich(graphlet, tuple(describe(node, depth=REMEMBERED) for node in things))


def _description(node: Node) -> set[str]:
    """Words that describe a thing."""
    said = [other for role, other in node.into if role in _DESCRIBING]
    said += [more for other in said for role, more in other.into if role in ("sub", "deg")]
    return set(node.lex) | {f"{n.negated} {word}" for n in said for word in n.lex}


def _fits(described: Graphlet, node: Node, net: Net) -> bool:
    return holds(described, net, REMEMBERED, {described.main: node})
