"""Stuck: the wheels turn, the range does not change; and nothing else is called stuck."""

from __future__ import annotations

import pytest

from kernel.bodies.forklift.stall import Stall

STEP_M = 0.01


@pytest.mark.parametrize(
    ("ranges", "turn", "stuck"),
    [
        ([0.10] * 8, 0.0, True),
        ([0.10, 0.104, 0.097, 0.103, 0.10, 0.10, 0.10], 0.0, True),
        ([0.30 - STEP_M * i for i in range(20)], 0.0, False),
        ([None] * 8, 0.0, False),
        ([0.10] * 8, 0.06, False),
        ([0.10] * 5, 0.0, False),
    ],
    ids=[
        "held",
        "held with noise",
        "approaching",
        "nothing ahead",
        "turning",
        "not far enough yet",
    ],
)
def test_stuck(ranges: list[float | None], turn: float, stuck: bool) -> None:
    stall = Stall()
    assert any(stall.update(STEP_M, turn, seen) for seen in ranges) is stuck


def test_standing_still_is_not_stuck() -> None:
    stall = Stall()
    assert not any(stall.update(0.0, 0.0, 0.1) for _ in range(100))
