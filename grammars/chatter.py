"""Sayings that are never meant for the robot, whatever their words would mean."""

from __future__ import annotations

from functools import cache

from grammars.normalise import pieces
from grammars.vocabulary import lines


@cache
def _idioms() -> frozenset[tuple[str, ...]]:
    return frozenset(tuple(piece.text for piece in pieces(line)) for line in lines("idioms"))


@cache
def _openings() -> frozenset[tuple[str, ...]]:
    return frozenset(tuple(piece.text for piece in pieces(line)) for line in lines("openings"))


def is_chatter(words: tuple[str, ...]) -> bool:
    """A saying, or what starts as nothing but a saying does."""
    return words in _idioms() or any(words[: len(start)] == start for start in _openings())
