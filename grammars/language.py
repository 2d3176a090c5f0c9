"""What may be said, as the recognisers get it: sentences to listen for, and all others the parser reads.

An engine weighs which words follow which, as it learns from phrases: what people say word for word (the examples),
sentences like these with other words, and one for every rule of the grammar. Whether what it then heard is a sentence
the parser says; those that `heard.py` lists are taken to be likelier.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache, cached_property
from itertools import cycle
from typing import Final

from grammars.automaton import Automaton, sample
from grammars.drawn import Deal, Shape, drawn, words
from grammars.earley import closed_words
from grammars.finite_state import POSSESSIVE
from grammars.heard import automaton
from grammars.parse import understood
from grammars.vocabulary import BORN, Readings, Vocabulary

LIKE_EACH: Final = 100
"""Sentences like each example: with 30 two in a hundred fewer were heard whole."""
KEPT: Final = 0.25
"""Share of the words of an example that stay in sentences like it: "drive forward" is said oftener than other pairs."""
TYPICAL: Final = 40
"""How often a sentence that people say is put among the phrases."""
OF_EACH_WORD: Final = 10
"""Sentences, at most, with each word that was taught and of those that are listened for."""


@dataclass(frozen=True)
class Language:
    """What may be said.

    Attributes:
        listed: sentences that are listened for; all else that can be typed is heard if the words are plain.
        typical: sentences that people say, word for word.
        likely: other sentences, of every shape and with every word.
        taught: the words beyond those known at birth, with their categories and lemmas.
    """

    listed: Automaton
    typical: tuple[str, ...]
    likely: tuple[str, ...]
    taught: Mapping[str, Readings]

    @cached_property
    def words(self) -> frozenset[str]:
        """Every word that may be heard."""
        return self.listed.words.union(*(said.split() for said in (*self.typical, *self.likely)))

    @property
    def phrases(self) -> tuple[str, ...]:
        """What an engine learns from: what people say counts TYPICAL times."""
        return (*self.typical * TYPICAL, *self.likely)

    def plain(self) -> Language:
        """With no other words than those that are listened for."""
        known = self.listed.words
        likely = (said for said in self.likely if known.issuperset(said.split()))
        return replace(self, likely=tuple(likely))

    def lists(self, text: str) -> bool:
        """Whether this is one of the sentences that are listened for."""
        return self.listed.accepts(text.split())

    def reads(self, text: str) -> bool:
        """Whether this is any sentence at all: some 5 ms."""
        return self.lists(text) or understood(text, self._vocabulary) is not None

    @cached_property
    def _vocabulary(self) -> Vocabulary:
        return Vocabulary(BORN.born, self.taught)


def language(vocabulary: Vocabulary = BORN) -> Language:
    """What may be said by someone who has taught these words."""
    likely = (*_born(), *_with_each(vocabulary.taught))
    listed = automaton(vocabulary) if vocabulary.taught else _listed()
    return Language(listed, drawn().typical, likely, vocabulary.taught)


@cache
def _listed() -> Automaton:
    """What is listened for at birth."""
    return automaton()


@cache
def listened_for(count: int) -> tuple[str, ...]:
    """So many of the sentences that are listened for at birth, drawn at random."""
    return tuple(sample(_listed(), count, random.Random(1)))


@cache
def _born() -> tuple[str, ...]:
    deal, found = Deal(words()), drawn()
    like = (
        deal.said(shape, given, KEPT) for shape, given in found.examples for _ in range(LIKE_EACH)
    )
    common = {word: BORN.born[word] for word in sorted(_listed().words) if word in BORN.born}
    likely = (*like, *map(deal.said, found.rules), *_with_each(common))
    return (*likely, *_unsaid(frozenset(word for said in likely for word in said.split())))


def _unsaid(said: frozenset[str]) -> Iterator[str]:
    """A sentence with each of the words that are none of those said: plurals, most of them; or the word alone."""
    deal = Deal(words())
    yield from sorted(closed_words() - said)
    whole = [shape for shape in drawn().rules if f'"{POSSESSIVE}"' not in shape]
    for category, known in words().items():
        shapes = [shape for shape in whole if category in shape]
        left = [word for word in known if not said.issuperset(word.split())]
        for word, shape in zip(left, cycle(shapes), strict=False):
            yield deal.said(tuple(f'"{word}"' if part == category else part for part in shape))


def _with_each(lexicon: Mapping[str, Readings]) -> Iterator[str]:
    """Examples with each of these words in the place of another of its category."""
    holding: dict[str, list[tuple[Shape, Shape]]] = {}
    for shape, given in drawn().examples:
        for category in set(shape):
            holding.setdefault(category, []).append((shape, given))
    for word, readings in lexicon.items():
        for category in readings:
            deal = Deal({**words(), category: (word,)})
            examples = holding.get(category, [])
            for shape, given in examples[:: 1 + len(examples) // OF_EACH_WORD]:
                parts = zip(shape, given, strict=True)
                yield deal.said(tuple(part if part == category else old for part, old in parts))
