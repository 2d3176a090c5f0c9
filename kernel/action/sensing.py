"""Senses: what turns the body's report into facts, on edges only."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, Protocol

from kernel.action.call import BodyState
from kernel.net.graphlet import Graphlet


@dataclass(frozen=True, slots=True)
class Edge:
    """Something began to be so (fact) or ceased to be (None).

    Attributes:
        key: names the sensed fact; the same key ends it.
        fact: names in it that another held fact of the sense uses mean the same node.
        fleeting: an event, not a state: it is not held.
        part: (name in the fact, noun): the name means the robot's own part of that noun, "gripper".
        noted: False where it was so before anybody looked: it is held, and nothing reacts to it.
    """

    key: str
    fact: Graphlet | None
    fleeting: bool = False
    part: tuple[str, str] | None = None
    noted: bool = True


class Sense(Protocol):
    """Watches one body; keeps what it needs to see edges."""

    def update(self, body: BodyState) -> list[Edge]:
        """Edges since the last report."""


SENSES: Final[dict[str, Callable[[], Sense]]] = {}


def sense(name: str) -> Callable[[type[Sense]], type[Sense]]:
    """Register a class of senses; every mind makes one of each.

    Raises:
        ValueError: the name is taken.
    """

    def register(kind: type[Sense]) -> type[Sense]:
        if name in SENSES:
            raise ValueError(f"sense {name} is registered twice")
        SENSES[name] = kind
        return kind

    return register
