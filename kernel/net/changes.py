"""What became of a net: its diary, for those who follow it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kernel.net.node import Node


@dataclass(slots=True)
class Changes:
    """What became of the net since somebody last took note.

    Attributes:
        extended: nodes that are new or came into view, or got a word or a link: nothing that held is lost by it.
        altered: nodes of which something else became different: level, belief, a word or a link taken away.
        dropped: nodes that are gone; they still know their words and neighbours.
        words: words that were taken from nodes.
    """

    extended: dict[Node, None] = field(default_factory=dict)
    altered: dict[Node, None] = field(default_factory=dict)
    dropped: dict[Node, None] = field(default_factory=dict)
    words: dict[str, None] = field(default_factory=dict)

    def __bool__(self) -> bool:
        return bool(self.extended or self.altered or self.dropped)
