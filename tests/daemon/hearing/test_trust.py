"""The best alternative that parses and is trusted, or none."""

from __future__ import annotations

import pytest

from daemon.hearing.events import Ended, Heard, NotHeard
from daemon.hearing.trust import Thresholds, choose

SENTENCES = {"drive forward", "turn left"}
ROWS = [
    ((("drive forward", 0.9),), False, "drive forward"),
    ((("dive forward", 0.9), ("drive forward", 0.8)), False, "drive forward"),
    ((("dive forward", 0.9),), False, "outside"),
    ((("drive forward", 0.1),), False, "outside"),
    ((("drive forward", 0.5),), False, "unsure"),
    ((), False, "noise"),
    ((("drive forward", 0.9),), True, "too_long"),
]


@pytest.mark.parametrize(("alternatives", "cut", "expected"), ROWS)
def test_choosing(alternatives: tuple[tuple[str, float], ...], cut: bool, expected: str) -> None:
    chosen = choose(
        Ended(0.0, 1.0, 1.3, alternatives, cut), SENTENCES.__contains__, Thresholds(0.3, 0.6)
    )
    if isinstance(chosen, Heard):
        assert chosen.text == expected
    else:
        assert isinstance(chosen, NotHeard)
        assert chosen.reason == expected
    assert (chosen.began_s, chosen.ended_s, chosen.decided_s) == (0.0, 1.0, 1.3)
