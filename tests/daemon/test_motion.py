"""Motions read from samples of the true pose."""

import math
from collections.abc import Iterator

import pytest
from hypothesis import given
from hypothesis import strategies as st

from daemon.motion import Run, Sample, arcs, groups, runs, still

STEP_S = 0.05


def travelled(*legs: tuple[float, float, float]) -> tuple[Sample, ...]:
    """Samples of a body that goes at (cm/s, degrees/s) for so many seconds, leg after leg."""

    def places() -> Iterator[Sample]:
        t = x = y = heading = 0.0
        yield Sample(t, x, y, heading, 0, 1000)
        for speed, rate, seconds in legs:
            for _ in range(round(seconds / STEP_S)):
                middle = math.radians(heading + rate * STEP_S / 2)
                x += speed * STEP_S * math.cos(middle)
                y += speed * STEP_S * math.sin(middle)
                heading += rate * STEP_S
                t += STEP_S
                yield Sample(t, x, y, (heading + 180) % 360 - 180, 0, 1000)

    return tuple(places())


def kinds(samples: tuple[Sample, ...]) -> list[tuple[str, int]]:
    return [(run.kind, round(run.amount)) for run in runs(samples)]


def test_a_square_corner_is_travel_then_turn() -> None:
    assert kinds(travelled((20, 0, 1), (0, -90, 1))) == [("forward", 20), ("right", 90)]


def test_amounts_do_not_depend_on_the_heading_or_the_wrap_at_180_degrees() -> None:
    samples = travelled((0, 90, 1.9), (-20, 0, 1), (0, 90, 1))
    assert kinds(samples) == [("left", 171), ("backward", 20), ("left", 90)]


def test_an_arc_is_travel_and_turn_at_once() -> None:
    found = runs(travelled((20, 45, 2)))
    assert [(run.kind, round(run.amount)) for run in found] == [("forward", 40), ("left", 90)]
    assert arcs(found, "left") == (found[1],)
    assert arcs(found, "right") == ()


def test_a_turn_after_a_drive_is_no_arc() -> None:
    assert arcs(runs(travelled((20, 0, 1), (0, 45, 1))), "left") == ()


def test_creeping_and_settling_are_no_motion() -> None:
    samples = travelled((0.5, 2, 2), (15, 0, 0.05))
    assert runs(samples) == ()


def test_lift_and_grip_are_told_apart() -> None:
    samples = [Sample(t / 10, 0, 0, 0, 50 * t, 1000 - 100 * t) for t in range(11)]
    assert {(run.kind, run.amount) for run in runs(samples)} == {("close", 1000), ("up", 500)}


def test_two_turns_with_only_a_pause_between_are_one_group() -> None:
    found = runs(travelled((0, 90, 1), (0, 0, 0.5), (0, 90, 1)))
    assert len(found) == 2
    assert [round(run.amount) for run in groups(found, "left")] == [180]
    assert sorted(round(run.amount) for run in groups(found, "left", pieces=True)) == [90, 90, 180]


def test_two_turns_with_a_drive_between_are_two_groups() -> None:
    found = runs(travelled((0, 90, 1), (20, 0, 1), (0, 90, 1)))
    assert [round(run.amount) for run in groups(found, "left")] == [90, 90]


@pytest.mark.parametrize(
    ("legs", "expected"),
    [(((0, 0, 1),), True), (((20, 0, 1),), False), (((0, 30, 1),), False), (((20, 0, 0.3), (-20, 0, 0.3)), False)],
)  # fmt: skip
def test_still_is_judged_by_every_sample(
    legs: tuple[tuple[float, float, float], ...], expected: bool
) -> None:
    assert still(travelled(*legs)) is expected


def test_still_may_be_asked_from_a_moment_on() -> None:
    assert still(travelled((20, 0, 0.3), (0, 0, 1)), after_s=0.3)


@given(st.lists(st.sampled_from([(20, 0), (-20, 0), (0, 90), (0, -90)]), min_size=1, max_size=6))
def test_amounts_add_up_whatever_the_order(legs: list[tuple[float, float]]) -> None:
    found = runs(travelled(*[(speed, rate, 1.0) for speed, rate in legs]))
    total = sum(run.amount for run in found)
    assert total == pytest.approx(sum(abs(speed) + abs(rate) for speed, rate in legs), abs=0.1)


def test_overlap_is_the_time_both_went_on() -> None:
    assert Run("forward", 0, 2, 1).overlap_s(Run("left", 1.5, 3, 1)) == 0.5
