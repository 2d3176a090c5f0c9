"""Sayings that are never meant for the robot, whatever their words would mean."""

from __future__ import annotations

from functools import cache

from grammars.normalise import pieces
from grammars.vocabulary import lines


@cache
def _sayings(sort: str) -> frozenset[tuple[str, ...]]:
    return frozenset(tuple(piece.text for piece in pieces(line)) for line in lines(sort))


def is_chatter(words: tuple[str, ...]) -> bool:
    """A saying, or what starts as nothing but a saying does."""
    starts = _sayings("openings")
    return words in _sayings("idioms") or any(words[: len(start)] == start for start in starts)
