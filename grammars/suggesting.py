"""The nearest sentence that would work: the same with a word spelt otherwise or left out, else an example like it.

A suggestion is never acted on: it is said, and the person says it, or something else.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice, product
from typing import Final

from rapidfuzz import process
from rapidfuzz.distance import OSA

from grammars.nearest import UNLIKELY, english, slip
from grammars.normalise import Piece

Works = Callable[[str], bool]


@dataclass(frozen=True, slots=True)
class Words:
    """The words known: such as the rules of the grammar have written out, and all others."""

    written: Collection[str]
    others: Collection[str]


MOST_TRIED: Final = 6  # sentences of each sort
MOST_SHORTER: Final = 4
MOST_OTHER: Final = 2
MOST_WORDS: Final = 10  # of a sentence that is tried out
MOST_STRANGE: Final = 2
SHORT: Final = 4  # letters; a shorter one has a letter left out, if anything
LONG: Final = 6  # letters of a word that may have two slips
LEAST_KEPT: Final = 0.6  # share of the words that a suggestion keeps
# Without these a sentence says the contrary, or something else altogether.
KEPT: Final = frozenset(
    "not never no don't if when whenever unless until while before after instead nothing nobody"
    " only what who where why how which whose is are was were do does did i my means or".split()
)


def respelt(
    text: str, found: Sequence[Piece], strange: Sequence[int], words: Words, works: Works
) -> str | None:
    """The sentence with its unknown words spelt as words that are known, if it works then."""
    if not 0 < len(strange) <= MOST_STRANGE or len(found) > MOST_WORDS:
        return None
    near = [_near(found[at].text, words) for at in strange]
    choices = islice(product(*near), MOST_TRIED)
    spelt = (_with(text, found, dict(zip(strange, choice, strict=True))) for choice in choices)
    return next(filter(works, spelt), None)


def rather(
    text: str, found: Sequence[Piece], reached: int, words: Words, works: Works
) -> str | None:
    """The sentence with a word or two left out, or with its last word of those understood spelt otherwise, if it works
    then."""
    if not 2 < len(found) <= MOST_WORDS:
        return None
    at = min(reached, len(found)) - 1
    same = () if at < 1 else _near(found[at].text, words)
    other = (_with(text, found, {at: word}) for word in same if len(word) == len(found[at].text))
    shorter = islice(_shorter(text, found, reached), MOST_SHORTER)
    return next(filter(works, (*islice(other, MOST_OTHER), *shorter)), None)


def _near(word: str, words: Words) -> list[str]:
    """Known words that may be meant by it, the likest first, of these such as the grammar has written out; a long one
    may have two slips, a word of English one likely slip."""
    known, real = (*words.written, *words.others), word in english()
    slips = 1 + (len(word) >= LONG and not real)
    found = process.extract(word, known, scorer=OSA.distance, score_cutoff=slips, limit=None)
    ranked = sorted(
        (distance, slip(word, other), other not in words.written, other)
        for other, distance, _ in found
        if not real or slip(word, other) < UNLIKELY
        if sorted(word) == sorted(other)
        or (word[0] == other[0] and (len(word) >= SHORT or len(other) > len(word)))
    )
    return list(dict.fromkeys(other for *_, other in ranked if other != word))


def _with(text: str, found: Sequence[Piece], instead: dict[int, str]) -> str:
    """The text with those pieces replaced; "" leaves one out."""
    for at in sorted(instead, reverse=True):
        text = text[: found[at].begin] + instead[at] + text[found[at].end :]
    return " ".join(text.split()).strip(" ,.;:!?")


def _shorter(text: str, found: Sequence[Piece], reached: int) -> Iterator[str]:
    """The sentence without a word or two: at its end, at its beginning, where it broke off."""
    last = len(found) - 1
    far = reached >= LEAST_KEPT * len(found)
    ends = [(last,), (last - 1, last)] if far else []
    for places in (*ends, (0,), (0, 1), (reached,)):
        enough = max(2.0, LEAST_KEPT * len(found))
        if places[-1] > last or len(found) - len(places) < enough:
            continue
        if any(found[at].text in KEPT for at in places):
            continue
        if all(found[at].kind == "word" for at in places):
            yield _with(text, found, dict.fromkeys(places, ""))
