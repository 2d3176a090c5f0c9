"""What was mentioned in a sentence, and the words that tell persons, places and pronouns apart."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

SELF: Final = {"you": "you", "yourself": "you", "me": "me", "i": "me"}
SELF_OWN: Final = {"my": "me", "your": "you"}
OWNING: Final = {"his": "he", "her": "she", "its": "it", "their": "they", "our": "we"}
PERSONAL: Final = frozenset("him her he she".split())
PERSON_WORDS: Final = frozenset("someone somebody anyone anybody nobody".split()) | {
    "someone else",
    "no one",
}
NOBODY: Final = frozenset(("nothing", "nobody", "no one"))
PERSONS: Final = frozenset(
    "person man woman boy girl child kid baby human guest visitor stranger friend neighbor owner".split()
)
ANY_KIND: Final = frozenset(("thing", "object", "item", "stuff"))
REFS: Final = {"the": "the", "this": "this", "that": "that", "these": "this", "those": "that"}
PLACES: Final = {
    "to the left of": "left of",
    "on the left of": "left of",
    "on the left side of": "left of",
    "to the right of": "right of",
    "on the right of": "right of",
    "on the right side of": "right of",
    "close to": "near",
    "near to": "near",
    "beside": "next to",
    "inside": "in",
    "inside of": "in",
    "in back of": "behind",
    "underneath": "under",
    "beneath": "under",
    "on top of": "on",
}


@dataclass
class Thing:
    """Something mentioned: its node and what it was called, for later "it" and "the block"."""

    name: str
    kind: str = ""
    person: bool = False
    named: bool = False

    @property
    def settled(self) -> bool:
        """It is known whether it is a person; "something" may be either."""
        return self.person or self.named or bool(self.kind)
