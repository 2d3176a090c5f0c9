"""The silent voice: what would be said is shown, and takes as long as saying it would."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

WORD_S: Final = 0.35  # service.md: the silent voice takes 0.35 s a word


class SilentVoice:
    """Says nothing; time is an argument, so it serves real and virtual time alike.

    Args:
        show: called with each text when it starts.
        word_s: seconds a word.
    """

    def __init__(self, show: Callable[[str], None] | None = None, word_s: float = WORD_S) -> None:
        self._show = show
        self._word_s = word_s
        self._until_s = float("-inf")

    def start(self, text: str, now_s: float) -> None:
        """Show the text and be busy for as long as its words take."""
        self._until_s = now_s + self._word_s * len(text.split())
        if self._show is not None:
            self._show(text)

    def busy(self, now_s: float) -> bool:
        """Words are left."""
        return now_s < self._until_s

    def interrupt(self) -> None:
        """Forget the rest."""
        self._until_s = float("-inf")
