"""Sentences drawn from the grammar: of each form those like its examples, with other words; and of every rule of the
grammar the shortest in which it has a part.

A shape is a sentence with categories in the place of their words; words written out in a rule stand in quotation marks.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from heapq import heappop, heappush
from typing import Any, Final

from grammars.earley import productions
from grammars.finite_state import POSSESSIVE, SHORT_FORMS
from grammars.heard import SILENT, derivations, kind, said, spoken_words, written_examples
from grammars.parse import parse
from grammars.registry import Form, discover
from grammars.source import digest, grammar_text, kept, set_categories
from grammars.vocabulary import BORN, lines

Shape = tuple[str, ...]

COMPILED: Final = "drawn.json"
NEVER: Final = 10**6
"""The cost of what has no end."""
AROUND: Final = 2
"""Depth of the phrases around the rule that a sentence is drawn for."""
LONGEST: Final = 14
"""Words of a shape: longer ones show no pair of words that others do not."""


class Draw:
    """Draws shapes from the rules of the grammar.

    Args:
        known: the categories that have words; a rule that needs another is left out.
        seed: the same seed draws the same shapes.
    """

    def __init__(self, known: Iterable[str], seed: int) -> None:
        self._known, self._chance = frozenset(known) | SILENT, random.Random(seed)
        self._ways: dict[str, list[Shape]] = {}
        for rule in productions():
            if rule.origin not in set_categories():
                self._ways.setdefault(rule.origin, []).append(rule.symbols)
        self._forms = {form.name: form for form in discover().values() if not form.expected}
        self._cost: dict[str, int] = {}
        self._find_costs()
        self._inside = self._contexts()

    def of(self, symbol: str, budget: int) -> Iterator[str]:
        """The terminals of a derivation at most so deep, or of the least deep one."""
        if symbol not in self._ways:
            yield symbol
            return
        ways = [way for way in self._ways[symbol] if self._deep(way) <= budget]
        way = self._chance.choice(ways or [min(self._ways[symbol], key=self._deep)])
        for part in way:
            yield from self.of(part, budget - 1)

    def of_each_rule(self) -> Iterator[tuple[Form, tuple[Shape, ...]]]:
        """For each rule the shapes of some sentences in which it has a part, and the form they should be of."""
        for origin, ways in self._ways.items():
            if origin not in self._inside and origin not in self._forms:
                continue
            for way in ways:
                if self._deep(way) < NEVER:
                    shapes = (self._with(origin, way, depth) for depth in (AROUND, AROUND + 1))
                    yield self._form_around(origin), tuple(shapes)

    def _form_around(self, origin: str) -> Form:
        while origin not in self._forms:
            origin = self._inside[origin][0]
        return self._forms[origin]

    def _with(self, origin: str, way: Shape, depth: int) -> Shape:
        row = list(self._row(way, depth))
        while origin not in self._forms:
            outer, way, place = self._inside[origin]
            before = self._row(way[:place], AROUND)
            row = [*before, *row, *self._row(way[place + 1 :], AROUND)]
            origin = outer
        return tuple(row)

    def _row(self, way: Shape, budget: int) -> Iterator[str]:
        for symbol in way:
            yield from (part for part in self.of(symbol, budget) if part not in SILENT)

    def _deep(self, way: Shape) -> int:
        return 1 + max(map(self._costing, way), default=0)

    def _costing(self, symbol: str) -> int:
        if symbol in self._ways:
            return self._cost.get(symbol, NEVER)
        return 0 if symbol.startswith('"') or symbol in self._known else NEVER

    def _find_costs(self) -> None:
        """The least depth of a derivation of each rule."""
        changed = True
        while changed:
            changed = False
            for origin, ways in self._ways.items():
                least = min(map(self._deep, ways))
                if least < self._cost.get(origin, NEVER):
                    self._cost[origin], changed = least, True

    def _contexts(self) -> dict[str, tuple[str, Shape, int]]:
        """For each rule the one it stands in, its other symbols and its place, on the shortest way from a form."""
        lengths = dict.fromkeys(self._forms, 0)
        left = [(0, name) for name in self._forms]
        inside: dict[str, tuple[str, Shape, int]] = {}
        while left:
            length, origin = heappop(left)
            for way in self._ways[origin] if length == lengths[origin] else ():
                if self._deep(way) >= NEVER:
                    continue
                for place, symbol in enumerate(way):
                    longer = length + len(way)
                    if symbol in self._ways and longer < lengths.get(symbol, NEVER):
                        lengths[symbol], inside[symbol] = longer, (origin, way, place)
                        heappush(left, (longer, symbol))
        return inside


class Deal:
    """Puts words into shapes: every word of a category in turn, in an order that chance has made."""

    def __init__(self, words: Mapping[str, Sequence[str]], seed: int = 0) -> None:
        self._words, self._chance = words, random.Random(seed)
        self._left: dict[str, list[str]] = {}

    def word(self, category: str) -> str:
        """The next word of a category."""
        left = self._left.setdefault(category, [])
        if not left:
            left.extend(self._words[category])
            self._chance.shuffle(left)
        return left.pop()

    def said(self, shape: Shape, given: Shape = (), kept: float = 0.0) -> str:
        """A sentence of this shape; this share of its words are those given."""
        words = [
            given[place] if given and self._chance.random() < kept else part
            for place, part in enumerate(shape)
        ]
        return spoken(part.strip('"') if part[0] == '"' else self.word(part) for part in words)


def spoken(words: Iterable[str]) -> str:
    """Words in a row as they are said: "do not" is "don't"."""
    said: list[str] = []
    for word in words:
        if said and word == POSSESSIVE:
            said[-1] += word
        elif said and (short := SHORT_FORMS.get((said[-1], word))):
            said[-1] = short
        else:
            said.append(word)
    return " ".join(said)


@dataclass(frozen=True, slots=True)
class Drawn:
    """What was drawn.

    Attributes:
        typical: what people say, word for word: the examples, as they are heard.
        examples: the shape of each example, and the words that stand in it there.
        rules: the shapes of sentences in which each rule of the grammar has a part.
    """

    typical: tuple[str, ...]
    examples: tuple[tuple[Shape, Shape], ...]
    rules: tuple[Shape, ...]


@cache
def drawn() -> Drawn:
    """From `drawn.json` if that was made of these very files, else drawn now."""
    data = kept(COMPILED, source(), compile_drawn)
    examples = ((tuple(shape), tuple(given)) for shape, given in data["examples"])
    return Drawn(tuple(data["typical"]), tuple(examples), tuple(map(tuple, data["rules"])))


def compile_drawn() -> dict[str, Any]:
    """The same as plain data: half a minute's work, so its result is kept in `drawn.json`."""
    return {
        "source": source(),
        "typical": list(_typical()),
        "examples": list(example_shapes()),
        "rules": list(rule_shapes(words())),
    }


def source() -> str:
    """What shapes are made of."""
    return digest("\n".join((grammar_text(), *lines("heard"), *written_examples())))


def _typical() -> Iterator[str]:
    for form in discover().values():
        if not form.expected:
            yield from (text for text in map(said, form.examples) if kind(text) == form.kind)


@cache
def words() -> Mapping[str, Sequence[str]]:
    """The words of each category that can be said; of what has no list of its own those of words/heard.txt."""
    found = dict[str, list[str]]()
    for word, readings in sorted(BORN.born.items()):
        for category in readings:
            found.setdefault(category, []).append(word)
    return {**spoken_words(BORN), **found}


def example_shapes() -> Iterator[tuple[Shape, Shape]]:
    """The shape of each example, and the words that stand in it there."""
    for form in discover().values():
        for example in () if form.expected else form.examples:
            tree = next(derivations(parse(example).trees[0], form.name))
            leaves = [leaf for leaf in tree.leaves() if leaf[0] not in SILENT]
            given = tuple(
                f'"{token.piece.text}"' if token.piece.kind == "word" else name
                for name, token in leaves
            )
            names = zip((name for name, _ in leaves), given, strict=True)
            yield tuple(name if name in words() else word for name, word in names), given


def rule_shapes(words: Mapping[str, Sequence[str]]) -> Iterator[Shape]:
    """For each rule of the grammar the shape of a sentence in which it has a part, and that is understood."""
    deal, seen = Deal(words), set[Shape]()
    for form, shapes in Draw(words, seed=0).of_each_rule():
        for shape in shapes:
            if shape in seen:
                break
            if len(shape) <= LONGEST and kind(deal.said(shape)) == form.kind:
                seen.add(shape)
                yield shape
                break
