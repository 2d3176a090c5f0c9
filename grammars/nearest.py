"""Near words for typos, and the nearest sentence that would work."""

from __future__ import annotations

from collections.abc import Container, Sequence
from functools import cache
from typing import Final

from rapidfuzz import fuzz, process
from rapidfuzz.distance import OSA

from grammars.registry import discover

NEAR_ENOUGH: Final = (
    60.0  # rapidfuzz's percentage; below it the suggestion is not about the same thing
)
SHORTEST: Final = 3  # letters of a word that may be a typo


def near_words(word: str, words: Sequence[str], common: Container[str] = frozenset()) -> list[str]:
    """Words one slip away (a letter too many, too few, wrong, or two swapped), likeliest first, at most four.

    Args:
        word: as typed.
        words: to choose from.
        common: words that come before others of the same likelihood.
    """
    if len(word) < SHORTEST:
        return []
    found = process.extract(word, words, scorer=OSA.distance, score_cutoff=1, limit=None)
    near = {other for other, distance, _ in found if distance == 1 and len(other) >= SHORTEST}
    return sorted(near, key=lambda other: (*_slip(word, other), other not in common, other))[:4]


def _slip(typed: str, meant: str) -> tuple[int, int]:
    """Likelihood of a slip: swapped letters, then a letter left out, then the rest; same first letter first."""
    swapped = sorted(typed) == sorted(meant)
    kind = 0 if swapped else 1 if len(meant) > len(typed) else 2
    return kind, int(typed[0] != meant[0])


@cache
def _examples() -> tuple[str, ...]:
    return tuple(example for form in discover().values() for example in form.examples)


def nearest_sentence(text: str) -> str | None:
    """An example of some form that is like the text, or None."""
    found = process.extractOne(
        text.lower(), _examples(), scorer=fuzz.token_sort_ratio, score_cutoff=NEAR_ENOUGH
    )
    return None if found is None else found[0]
