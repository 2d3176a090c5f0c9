"""Noticing that the wheels turn and the robot does not get anywhere."""

from __future__ import annotations

from typing import Final

ROLLED_M: Final = 0.05  # mind.md: so far commanded ...
CHANGED_M: Final = 0.01  # ... and the range changed by less than this
STRAIGHT_RAD: Final = 0.05  # a turn sweeps the beam over other things


class Stall:
    """Compares what the wheels rolled with what the rangefinder saw of it."""

    def __init__(self) -> None:
        self._seen_m: float | None = None
        self._rolled_m = self._turned_rad = 0.0

    def update(self, rolled_m: float, turned_rad: float, range_m: float | None) -> bool:
        """Whether the robot is stuck.

        Args:
            rolled_m: since the last call, forward positive.
            turned_rad: since the last call.
            range_m: distance of what is in the beam, None for nothing: then nothing can be told.
        """
        self._rolled_m += rolled_m
        self._turned_rad += turned_rad
        moved_on = (
            range_m is None
            or self._seen_m is None
            or abs(range_m - self._seen_m) >= CHANGED_M
            or abs(self._turned_rad) > STRAIGHT_RAD
        )
        stuck = not moved_on and abs(self._rolled_m) >= ROLLED_M
        if moved_on or stuck:
            self._seen_m = range_m
            self._rolled_m = self._turned_rad = 0.0
        return stuck
