"""Choosing among operators: the better liked oftener, the more fitting nearly always, none twice."""

import random
from collections import Counter

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kernel.memory.choice import choice_weights, in_turn

PREFERENCES = st.lists(st.tuples(st.floats(0.1, 1.5), st.integers(1, 9)), max_size=6)


@given(PREFERENCES, st.floats(0, 5))
def test_weights_are_chances(options: list[tuple[float, int]], sharpness: float) -> None:
    weights = choice_weights([p for p, _ in options], [s for _, s in options], sharpness)
    assert len(weights) == len(options)
    assert all(weight >= 0 for weight in weights)
    assert not options or sum(weights) == pytest.approx(1)


@given(st.integers(1, 5), st.floats(0.1, 1.5), st.integers(1, 9))
def test_equal_ones_share(count: int, preference: float, specificity: int) -> None:
    weights = choice_weights([preference] * count, [specificity] * count)
    assert weights == pytest.approx([1 / count] * count)


def test_must_always_beats_could_and_the_more_so_the_sharper() -> None:
    plain = choice_weights([1.2, 0.8], [2, 2])
    sharp = choice_weights([1.2, 0.8], [2, 2], sharpness=5)
    blunt = choice_weights([1.2, 0.8], [2, 2], sharpness=0)
    assert plain == pytest.approx([0.6, 0.4])
    assert sharp[0] > plain[0] > blunt[0] == pytest.approx(0.5)


def test_a_more_specific_one_nearly_always_wins_even_if_less_liked() -> None:
    assert choice_weights([0.8, 1.2], [4, 2])[0] > 0.98


@pytest.mark.parametrize(
    ("preference", "specificity"), [([1.0], [1, 2]), ([0.0], [1]), ([-1.0], [1]), ([1.0], [0])]
)
def test_what_makes_no_sense_is_refused(preference: list[float], specificity: list[int]) -> None:
    with pytest.raises(ValueError):  # noqa: PT011
        choice_weights(preference, specificity)


@given(st.lists(st.floats(0.01, 10), max_size=6), st.integers())
def test_everything_comes_once(weights: list[float], seed: int) -> None:
    items = list(range(len(weights)))
    assert sorted(in_turn(items, weights, random.Random(seed))) == items


def test_the_first_comes_as_often_as_its_weight_says() -> None:
    chance = random.Random(7)
    firsts = Counter(next(in_turn("ab", [0.6, 0.4], chance)) for _ in range(4000))
    assert firsts["a"] / 4000 == pytest.approx(0.6, abs=0.03)  # four standard deviations


@pytest.mark.parametrize("sharpness", [0.0, 1.0, 3.0])
def test_over_2000_choices_the_frequencies_are_those_of_the_weights(sharpness: float) -> None:
    preferences, specificities = [1.2, 1.0, 0.6, 1.5], [3, 3, 3, 2]
    raw = [p**sharpness * 10.0 ** (s - 3) for p, s in zip(preferences, specificities, strict=True)]
    weights = choice_weights(preferences, specificities, sharpness)
    chance = random.Random(11)
    first = [next(in_turn(range(4), weights, chance)) for _ in range(2000)]
    expected = [2000 * r / sum(raw) for r in raw]
    chi_square = sum((first.count(n) - e) ** 2 / e for n, e in enumerate(expected))
    assert chi_square < 16.27, "3 degrees of freedom, p = 0.001"
