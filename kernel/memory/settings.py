"""Numbers a user may set for the mind."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Settings:
    """Defaults are those of mind.md.

    Attributes:
        threshold: belief below which a premise does not count.
        desperate_threshold: the same, for a DO that found nothing applicable.
        prohibition_threshold: the same for prohibitions (caution); permission_threshold for permissions.
        least_preference: operators below it are not considered.
        sharpness: exponent on preference when choosing.
        fade_s: how long a handled focus stays in attention, s.
        utc_offset_s: how far the clock on the wall is ahead of UTC, s: what "today" is.
    """

    threshold: float = 0.5
    desperate_threshold: float = 0.25
    prohibition_threshold: float = 0.2
    permission_threshold: float = 0.8
    least_preference: float = 0.2
    sharpness: float = 1.0
    fade_s: float = 30.0
    utc_offset_s: float = 0.0
