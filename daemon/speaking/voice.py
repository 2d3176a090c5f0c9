"""The voice protocol: one utterance at a time; the cycle keeps the queue and asks each step whether it has ended."""

from __future__ import annotations

from typing import Protocol


class Voice(Protocol):
    """A way to say something aloud. No method waits."""

    def start(self, text: str, now_s: float) -> None:
        """Begin to say it; only called when not busy."""

    def busy(self, now_s: float) -> bool:
        """Speech is still going on: False is its end event."""

    def interrupt(self) -> None:
        """End speech at once; nothing to do where none is going on."""
