"""Errors of the English side."""

from __future__ import annotations

from grammars.asking import AskWord


class NotUnderstoodError(Exception):
    """A sentence has no reading.

    Attributes:
        text: the sentence.
        understood: how much of its beginning could start a sentence.
        nearest: a sentence that would work, or None.
        unknown_words: words that nobody taught, in order.
        asking: what the answer to would help.
    """

    def __init__(
        self,
        text: str,
        understood: str = "",
        nearest: str | None = None,
        unknown_words: tuple[str, ...] = (),
        asking: AskWord | None = None,
    ) -> None:
        super().__init__(f"not understood: {text[:80]!r}")
        self.text, self.understood, self.nearest = text, understood, nearest
        self.unknown_words, self.asking = unknown_words, asking


class NoMeaningError(Exception):
    """A reading that the grammar allows and the net has no room for; the next reading is tried."""


class BrokenOffError(Exception):
    """The words have no derivation. at: how many of them could begin one."""

    def __init__(self, at: int) -> None:
        super().__init__(at)
        self.at = at
