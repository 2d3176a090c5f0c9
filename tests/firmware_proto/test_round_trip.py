"""How long an answer takes, and the other clock."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from firmware_proto.round_trip import RESEND_MAX_S, RESEND_MIN_S, RoundTrip


@given(st.lists(st.floats(0.0, 3.0)))
def test_the_resend_time_stays_within_its_bounds(measured: list[float]) -> None:
    trip = RoundTrip()
    for seconds in measured:
        trip.took(seconds)
    assert RESEND_MIN_S <= trip.resend_s <= RESEND_MAX_S


def test_a_steady_line_is_learned_and_a_shaky_one_is_given_more_time() -> None:
    steady, shaky = RoundTrip(), RoundTrip()
    for number in range(40):
        steady.took(0.08)
        shaky.took(0.02 if number % 2 else 0.14)
    assert steady.srtt_s == pytest.approx(0.08)
    assert steady.resend_s == pytest.approx(0.08, abs=0.01)
    assert shaky.resend_s > 0.2


@given(st.floats(0.0, 1e6), st.integers(0, 2**32 - 1))
def test_the_fastest_round_trip_tells_the_other_clock(now_s: float, mcu_ms: int) -> None:
    trip = RoundTrip()
    trip.clocks(now_s, mcu_ms + 400, 0.8)  # slow on one leg only: off by 400 ms
    trip.clocks(now_s + 1, mcu_ms + 1000, 0.002)
    trip.clocks(now_s + 2, mcu_ms + 2300, 0.6)
    assert trip.mcu_ms(now_s + 5) == pytest.approx(mcu_ms + 5001, abs=2)
