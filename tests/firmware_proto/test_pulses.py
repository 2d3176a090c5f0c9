"""Slewed servos."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from firmware_proto.pulses import Slew

PERMILLE = st.floats(0, 1000)


@given(PERMILLE, PERMILLE, st.floats(1, 4000), st.lists(st.floats(0, 0.2), max_size=20))
def test_a_slew_never_exceeds_its_rate_nor_its_target(
    at: float, target: float, rate: float, steps: list[float]
) -> None:
    slew = Slew(at, target, rate)
    for dt_s in steps:
        before = slew.at
        slew.advance(dt_s)
        assert abs(slew.at - before) <= rate * dt_s + 1e-6
        assert min(at, target) <= slew.at <= max(at, target)


def test_it_arrives_exactly_and_hold_keeps_it() -> None:
    slew = Slew(0.0, 500.0, 1000.0)
    slew.advance(0.2)
    assert slew.at == pytest.approx(200)
    assert slew.moving
    slew.hold()
    slew.advance(1.0)
    assert slew.at == pytest.approx(200)
    slew.target = 500.0
    slew.advance(1.0)
    assert slew.at == 500.0
    assert not slew.moving
