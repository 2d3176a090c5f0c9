"""Text that is hardly a sentence: what a parser meets from a bad microphone, a cat on the keyboard and an attacker."""

from __future__ import annotations

import random
from collections.abc import Callable
from functools import cache
from typing import Final

from grammars.earley import closed_words
from grammars.registry import discover
from grammars.vocabulary import BORN

# People's sentences are of these lengths, the middle ones most often.
LONGEST: Final = 14
# What a terminal, an editor or a badly decoded stream puts between letters.
ODD: Final = "\x00\t\n\x1b\u200b\u202e\ufffd\U0001f916ÄßñœİıﬁＡ右№½°'’\"“”-–—,;:.!?…%$#@/\\()[]{}<>=+*^~`|_0123456789"
# As long, as deep and as repetitive as it can be made: each is refused, and at once.
ENDLESS: Final[dict[str, str]] = {
    "500 words": "turn left and " * 167,
    "500 words, no commands": "the red block next to " * 100,
    "10,000 letters": "a" * 10_000,
    "10,000 letters of one sentence": "drive forward then " * 530,
    "deep places": "grab the block " + "next to the block " * 15,
    "deep relatives": "grab the block " + "that is next to the block " * 9,
    "deep owners": "grab " + "the girl's " * 28 + "block",
    "deep conditions": "if something is close " * 15,
    "many commas": "turn left, " * 20 + "if",
    "many ands": "turn left and " * 20,
    "many untils": "drive forward until something is close " * 9,
    "quotes in quotes": "say say say " * 20,
    "every word anything": "left back right close open light " * 10,
    "quotation marks": '"' * 999,
    "apostrophes": "'s" * 450,
    "combining marks": "e\u0301" * 490,
}


@cache
def _words() -> tuple[str, ...]:
    return tuple(sorted({*BORN.everything, *closed_words()}))


@cache
def _sentences() -> tuple[tuple[str, ...], ...]:
    return tuple(
        tuple(example.rstrip("?.!").split())
        for form in discover().values()
        for example in form.examples
    )


def words(chance: random.Random) -> str:
    """Known words in any order, those that build sentences as often as all others."""
    pool = (_words(), tuple(sorted(closed_words())))
    count = min(LONGEST, max(1, round(chance.triangular(1, LONGEST, 5))))
    return " ".join(chance.choice(chance.choice(pool)) for _ in range(count))


def mutated(chance: random.Random) -> str:
    """An example with a few words dropped, swapped, said twice, put in, replaced or cut off."""
    said = list(chance.choice(_sentences()))
    for _ in range(chance.choice((1, 1, 2, 3))):
        at, other = chance.randrange(len(said)), chance.randrange(len(said))
        match chance.randrange(6):
            case 0 if len(said) > 1:
                del said[at]
            case 1:
                said[at], said[other] = said[other], said[at]
            case 2:
                said.insert(at, said[other])
            case 3:
                said.insert(at, chance.choice(_words()))
            case 4:
                said[at] = chance.choice(_words())
            case _:
                said = said[: at + 1]
    return " ".join(said)


def spliced(chance: random.Random) -> str:
    """The beginning of one example and the end of another."""
    one, other = chance.choice(_sentences()), chance.choice(_sentences())
    return " ".join(one[: chance.randint(1, len(one))] + other[chance.randrange(len(other)) :])


def noise(chance: random.Random) -> str:
    """Bytes taken for text, or a sentence with odd characters in it."""
    if chance.random() < 0.5:
        data = chance.randbytes(chance.randint(1, 80))
        return data.decode(chance.choice(("utf8", "latin1", "utf16", "cp437")), "replace")
    said = list(" ".join(chance.choice(_sentences())))
    for _ in range(chance.randint(1, 8)):
        said.insert(chance.randrange(len(said)), chance.choice(ODD))
    return "".join(said)


SORTS: Final[dict[str, Callable[[random.Random], str]]] = {
    "words": words,
    "mutated": mutated,
    "spliced": spliced,
    "noise": noise,
}
