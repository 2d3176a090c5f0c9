"""Words for how strongly something is meant, both ways: to numbers for parsing, to words for reading back.

Source: Connell 2019, section 4.1 (could 0.8, plain 1.0, must always 1.2); the other values are ours (docs/net.md).
"""

from __future__ import annotations

from typing import Final

from grammars.alist import AList

PREFERENCE: Final = {
    "must always": 1.2,
    "must": 1.1,
    "always": 1.1,
    "should always": 1.1,
    "should": 1.0,
    "can": 1.0,
    "could": 0.8,
    "might": 0.6,
    "might want to": 0.6,
    "may": 0.6,
    "maybe": 0.6,
    "perhaps": 0.6,
}

BELIEF: Final = {
    "definitely": 1.0,
    "always": 1.0,
    "certainly": 1.0,
    "usually": 0.8,
    "generally": 0.8,
    "normally": 0.8,
    "often": 0.8,
    "most": 0.8,
    "typically": 0.8,
    "mostly": 0.8,
    "almost always": 0.8,
    "nearly always": 0.8,
    "quite often": 0.8,
    "tend to": 0.8,
    "tends to": 0.8,
    "certain": 1.0,
    "probably": 0.7,
    "probable": 0.7,
    "very likely": 0.7,
    "likely": 0.7,
    "sometimes": 0.5,
    "may": 0.5,
    "might": 0.5,
    "possibly": 0.5,
    "possible": 0.5,
    "perhaps": 0.5,
    "rarely": 0.2,
    "maybe": 0.5,
    "occasionally": 0.5,
    "frequently": 0.8,
    "most likely": 0.7,
    "almost certainly": 0.8,
    "surely": 1.0,
    "unlikely": 0.2,
    "nearly never": 0.2,
    "almost never": 0.2,
    "seldom": 0.2,
    "hardly ever": 0.2,
}


def preference(words: str) -> float:
    """Preference of a wording; 1.0 for none."""
    return PREFERENCE.get(words, 1.0)


def belief(words: str) -> float:
    """Belief of a wording; 1.0 for none.

    Raises:
        KeyError: no such wording is known.
    """
    return BELIEF[words] if words else 1.0


def hedge_of(said: AList) -> str:
    """The wording by which a clause says how sure it is; "" for none."""
    return said.slot("hedge") or ("may" if said.has("may") else "")


def belief_of(said: AList) -> float:
    """How sure a clause says that it is."""
    return belief(hedge_of(said))
