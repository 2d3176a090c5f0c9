"""Typed text as a source: what is typed was heard without doubt, at the moment it was typed."""

from __future__ import annotations

from daemon.hearing.events import Heard, HearingEvent, StopWord
from daemon.hearing.stop_spotter import StopSpotter


def typed(line: str, at_s: float, robot_name: str = "robot") -> list[HearingEvent]:
    """The events of a line of text; none for an empty one. A stop word alone stops as a spoken one does."""
    text = line.strip()
    if not text:
        return []
    heard = Heard(at_s, at_s, at_s, text, 1.0)
    plain = " ".join(text.lower().replace(",", " ").rstrip("!.").split())
    if word := StopSpotter(robot_name).heard(plain, quiet=True):
        return [StopWord(at_s, word), heard]
    return [heard]
