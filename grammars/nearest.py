"""Near words for typos, and the nearest sentence that would work."""

from __future__ import annotations

import re
from collections.abc import Container, Sequence
from functools import cache
from typing import Final

from rapidfuzz import fuzz, process
from rapidfuzz.distance import OSA

from grammars.registry import discover
from grammars.vocabulary import lines

NEAR_ENOUGH: Final = (
    70.0  # rapidfuzz's percentage; below it the suggestion is not about the same thing
)
SHORTEST: Final = (
    4  # letters of a word that may be a typo; of one that builds sentences, or is none, one less
)

MOST_SLIPS: Final = 2
UNLIKELY: Final = 2
OTHER_WORD: Final = 3  # sort of a slip that is none


def near_words(
    word: str, words: Sequence[str], common: Container[str] = frozenset(), likely: bool = True
) -> list[str]:
    """Words one slip away, in alphabetical order; all of them are as likely.

    Two letters swapped are the likeliest slip, then a letter left out or doubled; a wrong letter or one too many is as
    likely another word that nobody taught. A word of English is no typo.

    Args:
        word: as typed.
        words: to choose from.
        common: words that build sentences; others are not looked for behind a very short word.
        likely: slips of the first two sorts; else of the last.
    """
    if word in english():
        return []
    found = process.extract(word, words, scorer=OSA.distance, score_cutoff=MOST_SLIPS, limit=None)
    near = [
        (sort, other)
        for other, distance, _ in found
        if (distance == 1 or _is_jumbled(word, other))
        and (len(word) >= SHORTEST or other in common or _is_no_word(word, other))
        if (sort := slip(word, other)) != OTHER_WORD and (sort < UNLIKELY) == likely
    ]
    likeliest = min(near, default=(OTHER_WORD, ""))[0]
    return sorted(other for sort, other in near if sort == likeliest)


@cache
def english() -> frozenset[str]:
    """Common words that the robot does not know: whoever types "money" does not mean "monkey"."""
    return frozenset(word for line in lines("english") for word in line.split())


def _is_jumbled(typed: str, meant: str) -> bool:
    """A longer word whose letters all stand there, some in another place: "presno"."""
    return len(typed) > SHORTEST and typed[0] == meant[0] and sorted(typed) == sorted(meant)


def _is_no_word(typed: str, meant: str) -> bool:
    """However short: it has no vowel, or one letter of two is lacking."""
    return not re.search("[aeiouy]", typed) or typed == re.sub(r"(.)\1", r"\1", meant)


def slip(typed: str, meant: str) -> int:
    """The sort of a slip, the likeliest first; a mark between letters is one."""
    if sorted(re.sub("[-']", "", typed)) == sorted(meant):
        return 0
    if typed[0] != meant[0] or len(typed) < SHORTEST - 1:
        return OTHER_WORD
    doubled = re.sub(r"(.)\1", r"\1", typed) == re.sub(r"(.)\1", r"\1", meant)
    if len(meant) > len(typed) or doubled:
        return 1
    return UNLIKELY if len(typed) > SHORTEST else OTHER_WORD


@cache
def _examples() -> tuple[str, ...]:
    return tuple(
        example for form in discover().values() if not form.expected for example in form.examples
    )


def typical_sentence(text: str) -> str | None:
    """The shortest example that begins with the same word, or None."""
    return _by_opening().get(_opening(text))


@cache
def _by_opening() -> dict[str, str]:
    return {_opening(example): example for example in sorted(_examples(), key=len, reverse=True)}


def _opening(text: str) -> str:
    word = re.match("[a-z']+", text.lower())
    return word[0] if word else ""


def nearest_sentence(text: str) -> str | None:
    """An example of some form that is like the text, or None."""
    found = process.extractOne(
        text.lower(), _examples(), scorer=fuzz.token_sort_ratio, score_cutoff=NEAR_ENOUGH
    )
    return None if found is None else found[0]
