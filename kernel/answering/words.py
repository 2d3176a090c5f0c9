"""What is the opposite of a word."""

from __future__ import annotations

from kernel.asking import Asking, answers
from kernel.memory.contraries import opposites
from kernel.memory.explanation import Contrary


@answers("opposite")
def opposite(asking: Asking) -> Contrary:
    """The words that say the opposite of the one asked about."""
    word = min(asking.main.lex, default="")
    return Contrary(word, opposites(word))
