"""How long an answer takes, and what the far end's clock shows."""

from __future__ import annotations

from collections import deque

RESEND_MIN_S, RESEND_MAX_S = 0.060, 0.500


class RoundTrip:
    """Smoothed round trip as in RFC 6298, and the offset of the far end's clock."""

    def __init__(self) -> None:
        self.srtt_s: float | None = None
        self._variance_s = 0.0
        self._offsets: deque[tuple[float, float]] = deque(maxlen=8)

    @property
    def resend_s(self) -> float:
        """How long to wait for an answer before sending again, s."""
        if self.srtt_s is None:
            return 2 * RESEND_MIN_S
        return min(max(self.srtt_s + 4 * self._variance_s, RESEND_MIN_S), RESEND_MAX_S)

    def took(self, seconds: float) -> None:
        """One more measurement."""
        if self.srtt_s is None:
            self.srtt_s, self._variance_s = seconds, seconds / 2
            return
        self._variance_s += (abs(self.srtt_s - seconds) - self._variance_s) / 4
        self.srtt_s += (seconds - self.srtt_s) / 8

    def clocks(self, host_s: float, mcu_ms: int, seconds: float) -> None:
        """At host_s, half a round trip ago, the far end's clock showed mcu_ms."""
        self._offsets.append((seconds, mcu_ms - (host_s - seconds / 2) * 1000))

    def mcu_ms(self, host_s: float) -> int:
        """What the far end's clock shows at host_s; the fastest of the last round trips decides."""
        _, offset = min(self._offsets)
        return round(host_s * 1000 + offset)
