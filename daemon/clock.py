"""The daemon's clocks. Nothing below the daemon asks them."""

from __future__ import annotations

import os
import time
from pathlib import Path


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

    @staticmethod
    def utc_offset_s() -> float:
        """How far the clock on the wall is ahead of UTC here and now, s: what "today" is."""
        return float(time.localtime().tm_gmtoff)


def process_age_s() -> float:
    """Seconds since this process was started, its own start-up included (Linux: proc(5), field 22 of stat)."""
    fields = Path("/proc/self/stat").read_text().rpartition(")")[2].split()
    began_s = int(fields[19]) / os.sysconf("SC_CLK_TCK")
    return time.clock_gettime(time.CLOCK_BOOTTIME) - began_s
