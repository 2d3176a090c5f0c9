"""Chains of plays: the procedure part of an operator, and of a command.

Source: Connell 2019, section 3: a chain is plays one after another; a play is directives at the same time, all of
which must complete, and optional auxiliary ones that end when the required ones end.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from kernel.net.graphlet import Graphlet

PAPER_TAGS: Final = ("NOTE", "DO", "ANTE", "POST", "CHK", "FIND", "ACH", "KEEP", "PUNT", "FCN")
OUR_TAGS: Final = ("ADD", "EDIT", "ALLOW", "ASK")


@dataclass(frozen=True, slots=True)
class Directive:
    """A tag on a graphlet: DO[act-1 -lex- drive]. PUNT carries none."""

    tag: str
    graphlet: Graphlet | None = None


@dataclass(frozen=True, slots=True)
class Play:
    """Directives (or whole chains) side by side.

    Attributes:
        required: all must succeed; one failing ends the others and the play.
        auxiliary: run beside the required ones and end with them.
    """

    required: tuple[Directive | Chain, ...]
    auxiliary: tuple[Directive | Chain, ...] = ()


@dataclass(frozen=True, slots=True)
class Chain:
    """Plays one after another."""

    plays: tuple[Play, ...] = ()

    def directives(self) -> Iterator[Directive]:
        """Every directive in reading order, however deep."""
        for play in self.plays:
            for part in (*play.required, *play.auxiliary):
                if isinstance(part, Directive):
                    yield part
                else:
                    yield from part.directives()

    @property
    def parallel(self) -> bool:
        """True where some play holds two things at once."""
        return any(
            len(play.required) + len(play.auxiliary) > 1
            or any(isinstance(p, Chain) and p.parallel for p in (*play.required, *play.auxiliary))
            for play in self.plays
        )


def sequence(*parts: Directive | Chain) -> Chain:
    """A chain of one-part plays."""
    return Chain(tuple(Play((part,)) for part in parts))
