"""The daemon's clocks. Nothing below the daemon asks them."""

from __future__ import annotations

import time


class Clock:
    """Seconds since it was made, on a clock that never jumps; and wall time, s since 1970."""

    def __init__(self) -> None:
        self._began_s = time.monotonic()

    def now_s(self) -> float:
        """Monotonic time."""
        return time.monotonic() - self._began_s

    @staticmethod
    def wall_s() -> float:
        """Wall time: what lessons and the log are dated with."""
        return time.time()
