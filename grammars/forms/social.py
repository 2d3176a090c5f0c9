"""Manners: greetings, thanks, goodbyes."""

from __future__ import annotations

from typing import Literal

from grammars.alist import AList
from grammars.registry import sentence_form
from kernel.memory.meaning import Social

EXAMPLES = ("hello robot", "Thank you!", "good morning", "see you later", "see you in an hour")
ACTS: tuple[Literal["hello", "thanks", "bye", "sorry"], ...] = ("hello", "thanks", "bye", "sorry")


@sentence_form("social", "social", EXAMPLES)
def social(alist: AList) -> Social:
    """Which of the manners it is."""
    return Social(next(act for act in ACTS if alist.has(act)))
