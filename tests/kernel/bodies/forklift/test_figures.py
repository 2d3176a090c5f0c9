"""What the body reckons with and what the twin is built to agree."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kernel.bodies.forklift import figures


@given(st.floats(0.0, figures.REACH_CM - 0.5))
def test_the_range_curve_reads_back_what_it_was_given(ahead_cm: float) -> None:
    adc = figures.to_adc(figures.range_volts(ahead_cm + 4))
    read_m = figures.range_m(adc)
    assert read_m is not None
    assert read_m * 100 == pytest.approx(ahead_cm, abs=0.25)


def test_beyond_reach_is_nothing() -> None:
    assert figures.range_m(figures.to_adc(figures.range_volts(None))) is None
    assert figures.range_m(figures.to_adc(figures.range_volts(41 + 4))) is None


def test_the_curve_folds_back_inside_the_fork() -> None:
    volts = [figures.range_volts(cm / 10) for cm in range(60)]
    assert max(volts) == volts[30]
    assert sorted(volts[:31]) == volts[:31]


@given(st.floats(-0.4, 0.4), st.floats(-1.6, 1.6))
def test_wheels_and_pulses_are_inverse(speed_m_s: float, rate_rad_s: float) -> None:
    left, right = figures.wheel_permille(speed_m_s, rate_rad_s)
    wheels = [figures.wheel_speed_m_s(1500 + round(p / 2)) for p in (left, right)]
    assert sum(wheels) / 2 == pytest.approx(speed_m_s, abs=0.002)
    assert (wheels[1] - wheels[0]) / figures.TRACK_M == pytest.approx(rate_rad_s, abs=0.02)


def test_too_fast_is_slowed_on_the_same_arc() -> None:
    left, right = figures.wheel_permille(1.0, math.pi)
    assert right == 1000
    assert left / right == pytest.approx((1 - math.pi / 20) / (1 + math.pi / 20), abs=0.01)
