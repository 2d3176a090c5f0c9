"""Choosing among applicable operators."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from typing import Final, TypeVar

SPECIFICITY_BASE: Final = 10.0  # ours: one more matched node is ten times likelier
T = TypeVar("T")


def choice_weights(
    preference: Sequence[float],
    specificity: Sequence[int],
    sharpness: float = 1.0,
    base: float = SPECIFICITY_BASE,
) -> list[float]:
    """Chance of choosing each applicable operator.

    Args:
        preference: n values > 0; 0.8 is "you could", 1.2 "you must always".
        specificity: n values >= 1; matched nodes in the trigger and enablement.
        sharpness: exponent on preference; 0 explores, large exploits.
        base: how much one more matched node counts.

    Returns:
        n non-negative values summing to 1; empty for n = 0.

    Raises:
        ValueError: lengths differ, or a value is out of range.

    Source: Connell 2019, section 3. How the two are combined is not given there; mind.md decides.
    """
    if len(preference) != len(specificity):
        raise ValueError(f"{len(preference)} preferences, {len(specificity)} specificities")
    if any(p <= 0 for p in preference) or any(s < 1 for s in specificity):
        raise ValueError("preferences must be > 0 and specificities >= 1")
    highest = max(specificity, default=0)
    raw = [
        p**sharpness * base ** (s - highest) for p, s in zip(preference, specificity, strict=True)
    ]
    total = sum(raw)
    return [weight / total for weight in raw]


def in_turn(items: Sequence[T], weights: Sequence[float], chance: random.Random) -> Iterator[T]:
    """The items in random order by weight, without repeating one."""
    left, odds = list(items), list(weights)
    while left:
        index = chance.choices(range(len(left)), odds)[0]
        odds.pop(index)
        yield left.pop(index)
