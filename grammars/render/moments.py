"""Wall time in words, as seen from the day on which it is told."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta


def moment(at_s: float, told_s: float, utc_offset_s: float = 0.0) -> str:
    """When it was; "" where either is not known.

    Args:
        at_s: s since 1970. told_s: when this is told, the same.
        utc_offset_s: how far the clock on the wall is ahead of UTC.

    >>> moment(14 * 3600 + 300, 20 * 3600), moment(3600, 86_400 + 3600), moment(3600, 86_400 * 9)
    ('today at 14:05', 'yesterday at 1:00', 'on 1 January')
    """
    if at_s <= 0 or told_s <= 0:
        return ""
    at, told = (_wall(time_s, utc_offset_s) for time_s in (at_s, told_s))
    days = (told.date() - at.date()).days
    if days <= 1:
        return f"{'yesterday' if days == 1 else 'today'} at {at.hour}:{at.minute:02}"
    return f"on {at.day} {at:%B}" + (f" {at.year}" if at.year != told.year else "")


def lasting(seconds: float) -> str:
    """How long.

    >>> lasting(1.0), lasting(4.0), lasting(2.5)
    ('1 second', '4 seconds', '2.5 seconds')
    """
    number = f"{round(seconds, 1):g}"
    return f"{number} second{'' if number == '1' else 's'}"


def _wall(time_s: float, utc_offset_s: float) -> datetime:
    return datetime.fromtimestamp(0, UTC) + timedelta(seconds=time_s + utc_offset_s)
