"""Which words may come next: from the finite-state grammar the recognisers use, so in no time."""

from __future__ import annotations

import re
from functools import cached_property
from typing import Final

from grammars.automaton import Automaton
from grammars.heard import automaton
from grammars.vocabulary import Vocabulary

COMMANDS: Final = ("/forget", "/help", "/lessons", "/quit", "/speaker", "/stop")
_WORD: Final = re.compile(r"[^\s,.;:!?\"]+")


class Words:
    """The words that can continue a sentence.

    Args:
        vocabulary: words known; taught ones are offered first.
    """

    def __init__(self, vocabulary: Vocabulary) -> None:
        self._vocabulary = vocabulary

    @cached_property
    def _language(self) -> Automaton:
        """Made when it is first needed: a quarter of a second."""
        return automaton(self._vocabulary)

    def warm_up(self) -> None:
        """Make the automaton now."""
        self.after("")

    def after(self, text: str) -> list[str]:
        """Words that may follow the text, or finish its last word; taught ones first, then by the alphabet."""
        if text.startswith("/"):
            return [c for c in COMMANDS if c.startswith(text)] if " " not in text else []
        words = _WORD.findall(text.lower())
        begun = words.pop() if words and not text.endswith((" ", ",")) else ""
        found = {
            word
            for state in self._language.after(words)
            for word in self._language.moves.get(state, {})
            if word.startswith(begun) and word != begun
        }
        return sorted(found, key=lambda word: (word not in self._vocabulary.taught, word))

    @staticmethod
    def begun(text: str) -> str:
        """The word that is being typed: what a completion takes the place of."""
        if text.startswith("/"):
            return text
        return re.split(r"[\s,.;:!?\"]", text)[-1]
