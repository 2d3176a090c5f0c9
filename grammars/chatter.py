"""Sayings that are never meant for the robot, whatever their words would mean."""

from __future__ import annotations

from functools import cache
from typing import Final

from grammars.normalise import pieces
from grammars.vocabulary import lines

MANNERS: Final = frozenset(
    "please now so well oh okay and everyone everybody folks mate love darling dear then ,".split()
)
TOLD: Final = frozenset("as said says they that because so like my".split())


@cache
def _sayings(sort: str) -> frozenset[tuple[str, ...]]:
    return frozenset(tuple(piece.text for piece in pieces(line)) for line in lines(sort))


def _without_manners(words: tuple[str, ...]) -> tuple[str, ...]:
    """What is left without the words that go with any sentence, before and after it."""
    at = [place for place, word in enumerate(words) if word not in MANNERS]
    return words[at[0] : at[-1] + 1] if at else words


def is_chatter(words: tuple[str, ...]) -> bool:
    """A saying, one that somebody is told to have said, or what starts or ends as nothing but a saying does."""
    starts, idioms, closings = map(_sayings, ("openings", "idioms", "closings"))
    words = _without_manners(words)
    ends = (at for at, word in enumerate(words) if word in TOLD)
    quoted = any(words[:at] in idioms for at in ends)
    begun = any(words[: len(start)] == start for start in starts)
    ended = any(words[-len(end) :] == end for end in closings)
    return words in idioms or quoted or begun or ended
