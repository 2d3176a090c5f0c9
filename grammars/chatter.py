"""Sayings that are never meant for the robot, whatever their words would mean."""

from __future__ import annotations

from functools import cache
from typing import Final

from grammars.normalise import pieces
from grammars.vocabulary import lines

TOLD: Final = frozenset("as said says they that because so like my".split())


@cache
def _sayings(sort: str) -> frozenset[tuple[str, ...]]:
    return frozenset(tuple(piece.text for piece in pieces(line)) for line in lines(sort))


def is_chatter(words: tuple[str, ...]) -> bool:
    """A saying, one that somebody is told to have said, or what starts as nothing but a saying does."""
    starts, idioms = _sayings("openings"), _sayings("idioms")
    ends = (at for at, word in enumerate(words) if word in TOLD)
    quoted = any(words[:at] in idioms for at in ends)
    return words in idioms or quoted or any(words[: len(start)] == start for start in starts)
