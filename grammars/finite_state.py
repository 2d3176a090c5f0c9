"""The grammar as a finite-state automaton: what the recognisers are told may be said.

The rules of the parser (context-free, word categories as terminals) are compiled once: left and right recursion become
loops, recursion in the middle is unrolled to a bounded depth, and the result is determinised and minimised while a
category is still one token. Only then does a vocabulary put its words in the place of the categories, so a thousand
names cost a thousand arcs where a name may stand and nothing else.

The automaton may hear less than the parser reads (deep nesting), and now and then more (words of two categories): the
parser decides what may act.
"""

from __future__ import annotations

import random
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from importlib.resources import files

from grammars import morphology
from grammars.automaton import Automaton, renumbered, sample, useful
from grammars.parse import grammar
from grammars.vocabulary import BORN, Vocabulary, lines

MAX_DEPTH = 0
"""How often a rule may stand inside itself, other than at its beginning or end ("the block next to the ball next to
...". Our choice: deeper, the automaton is many times as big and hearing no better."""
SHORT_FORMS = {
    ("do", "not"): "don't",
    ("did", "not"): "didn't",
    ("i", "am"): "i'm",
    ("you", "are"): "you're",
    ("it", "is"): "it's",
    ("should", "not"): "shouldn't",
    ("must", "not"): "mustn't",
}
"""What the parser reads as two words and people say as one."""


Rule = tuple[str, tuple[str, ...]]
"""A name, and what may be written for it. What no rule is named after is a terminal."""


def automaton(vocabulary: Vocabulary = BORN) -> Automaton:
    """What may be said by someone who has taught these words."""
    return expand(skeleton(), spoken_words(vocabulary))


def phrases(vocabulary: Vocabulary, count: int, seed: int) -> list[str]:
    """Sentences that may be heard, drawn at random; the same seed draws the same ones."""
    return sample(automaton(vocabulary), count, random.Random(seed))


@cache
def skeleton() -> Automaton:
    """The language with categories in the place of their words, compiled once."""
    rules = heard_rules(spoken_rules(), files("grammars").joinpath("heard.lark").read_text("utf8"))
    return compile_rules(rules, "start")


def spoken_rules() -> list[Rule]:
    """The parser's rules; words written out in them stand in quotation marks, which tells them from rules."""
    words = {name: f'"{word}"' for word, name in grammar().literal.items()}
    return [
        (
            rule.origin.name,
            tuple(words.get(s.name, s.name) if s.is_term else s.name for s in rule.expansion),
        )
        for rule in grammar().rules
    ]


def heard_rules(rules: Iterable[Rule], text: str) -> list[Rule]:
    """The rules with some replaced by those of a text in lark's notation: names, quoted words, bars, nothing else."""
    replaced: list[Rule] = []
    plain = re.sub(r"//.*", "", text)
    for found in re.finditer(r"(\w+):((?:(?!\w+:)[\s\S])*)", plain):
        replaced += [(found[1], tuple(way.split())) for way in found[2].split("|")]
    origins = {origin for origin, _ in replaced}
    return replaced + [rule for rule in rules if rule[0] not in origins]


def spoken_words(vocabulary: Vocabulary) -> dict[str, tuple[str, ...]]:
    """The words for each terminal: those the ears know at birth, and all that were taught."""
    found: dict[str, dict[str, None]] = {}
    for line in lines("heard"):
        category, _, words = line.partition(":")
        entries = words.split("|") if "|" in words or category == "QUOTED" else words.split()
        found.setdefault(category, {}).update(dict.fromkeys(entry.strip() for entry in entries))
    for category, plural in (("NOUN", "NOUNS"),):
        found[plural] = dict.fromkeys(morphology.plural(word) for word in found[category])
    for word, readings in vocabulary.taught.items():
        for category in readings:
            found.setdefault(category, {})[word] = None
    return {category: tuple(words) for category, words in found.items()}


def compile_rules(rules: Iterable[Rule], start: str, max_depth: int = MAX_DEPTH) -> Automaton:
    """Compile rules into a minimal automaton whose words are the terminals.

    Raises:
        KeyError: no rule is named start.
    """
    compiler = _Compiler(rules, max_depth)
    if start not in compiler.rules:
        raise KeyError(start)
    return compiler.compiled(start, ())


def expand(skeleton: Automaton, words: Mapping[str, Sequence[str]]) -> Automaton:
    """Put words in the place of terminals. A terminal with no words disappears, with what only it led to.

    An entry of several words ("pick up") becomes a path of its own.
    """
    arcs: set[tuple[int, str, int]] = set()
    fresh = skeleton.size
    for source, terminal, target in skeleton.arcs:
        entries = (terminal.strip('"'),) if terminal.startswith('"') else words.get(terminal, ())
        for entry in entries:
            *firsts, last = entry.split()
            state = source
            for word in firsts:
                arcs.add((state, word, fresh))
                state, fresh = fresh, fresh + 1
            arcs.add((state, last, target))
    arcs |= set(_short_forms(arcs))
    return useful(Automaton(skeleton.start, skeleton.finals, tuple(sorted(arcs))))


def _short_forms(arcs: Iterable[tuple[int, str, int]]) -> Iterator[tuple[int, str, int]]:
    firsts = {first for first, _ in SHORT_FORMS}
    onward: dict[int, list[tuple[str, int]]] = {}
    for source, word, target in arcs:
        onward.setdefault(source, []).append((word, target))
    for source, first, middle in arcs:
        if first in firsts:
            for second, target in onward.get(middle, ()):
                if short := SHORT_FORMS.get((first, second)):
                    yield source, short, target


class _Compiler:
    """Compiles each rule once for each set of rules it stands inside of."""

    def __init__(self, rules: Iterable[Rule], max_depth: int) -> None:
        self.rules: dict[str, list[tuple[str, ...]]] = {}
        for origin, symbols in rules:
            self.rules.setdefault(origin, []).append(symbols)
        self._max_depth = max_depth
        self._made: dict[tuple[str, tuple[str, ...]], Automaton] = {}
        self._reach = _closure(
            {origin: {s for way in ways for s in way} for origin, ways in self.rules.items()}
        )

    def compiled(self, origin: str, inside: tuple[str, ...]) -> Automaton:
        """The automaton of a rule that stands inside these."""
        relevant = tuple(sorted(rule for rule in inside if rule in self._reach[origin]))
        key = (origin, relevant)
        if key not in self._made:
            self._made[key] = self._compile(origin, relevant)
        return self._made[key]

    def _compile(self, origin: str, inside: tuple[str, ...]) -> Automaton:
        """States 0 and 1 are the ends; a way that begins or ends with its own origin loops at that end."""
        draft = _Draft()
        if inside.count(origin) > self._max_depth:
            return draft.finished(0, 1)
        for way in self.rules[origin]:
            first, last, symbols = 0, 1, way
            if symbols[:1] == (origin,):
                first, last, symbols = 1, 1, symbols[1:]
            elif symbols[-1:] == (origin,):
                first, last, symbols = 0, 0, symbols[:-1]
            state = first
            for symbol in symbols:
                state = self._append(draft, state, symbol, (*inside, origin))
            draft.skip(state, last)
        return draft.finished(0, 1)

    def _append(self, draft: _Draft, state: int, symbol: str, inside: tuple[str, ...]) -> int:
        if symbol not in self.rules:
            after = draft.state()
            draft.arc(state, symbol, after)
            return after
        return draft.insert(state, self.compiled(symbol, inside))


class _Draft:
    """An automaton under construction, with empty moves."""

    def __init__(self) -> None:
        self._arcs: dict[int, list[tuple[str, int]]] = {}
        self._skips: dict[int, set[int]] = {}
        self._count = 2

    def state(self) -> int:
        self._count += 1
        return self._count - 1

    def arc(self, source: int, word: str, target: int) -> None:
        self._arcs.setdefault(source, []).append((word, target))

    def skip(self, source: int, target: int) -> None:
        self._skips.setdefault(source, set()).add(target)

    def insert(self, state: int, part: Automaton) -> int:
        """Copy an automaton in after a state; return the state behind it."""
        base, self._count = self._count, self._count + part.size
        after = self.state()
        self.skip(state, base + part.start)
        for source, word, target in part.arcs:
            self.arc(base + source, word, base + target)
        for final in part.finals:
            self.skip(base + final, after)
        return after

    def finished(self, start: int, final: int) -> Automaton:
        """Determinised and minimised."""
        closures: dict[int, frozenset[int]] = {}

        def closure(state: int) -> frozenset[int]:
            if state not in closures:
                found, left = {state}, [state]
                while left:
                    for following in self._skips.get(left.pop(), ()):
                        if following not in found:
                            found.add(following)
                            left.append(following)
                closures[state] = frozenset(found)
            return closures[state]

        first = closure(start)
        numbers, left = {first: 0}, [first]
        arcs: list[tuple[int, str, int]] = []
        while left:
            here = left.pop()
            reached: dict[str, set[int]] = {}
            for state in here:
                for word, target in self._arcs.get(state, ()):
                    reached.setdefault(word, set()).update(closure(target))
            for word, targets in reached.items():
                there = frozenset(targets)
                if there not in numbers:
                    numbers[there] = len(numbers)
                    left.append(there)
                arcs.append((numbers[here], word, numbers[there]))
        finals = frozenset(number for states, number in numbers.items() if final in states)
        return _minimal(useful(Automaton(0, finals, tuple(sorted(arcs)))))


def _minimal(automaton: Automaton) -> Automaton:
    """Merge the states nothing can tell apart (Moore's refinement of a deterministic automaton)."""
    rows: list[list[tuple[str, int]]] = [[] for _ in range(automaton.size)]
    for source, word, target in automaton.arcs:
        rows[source].append((word, target))
    block = [int(state in automaton.finals) for state in range(automaton.size)]
    count = len(set(block))
    while True:
        signatures: dict[tuple[object, ...], int] = {}
        refined = [
            signatures.setdefault(
                (block[state], *((word, block[target]) for word, target in rows[state])),
                len(signatures),
            )
            for state in range(automaton.size)
        ]
        block = refined
        if len(signatures) == count:
            break
        count = len(signatures)
    arcs = {(block[source], word, block[target]) for source, word, target in automaton.arcs}
    finals = frozenset(block[state] for state in automaton.finals)
    return renumbered(Automaton(block[automaton.start], finals, tuple(sorted(arcs))))


def _closure(edges: Mapping[str, set[str]]) -> dict[str, set[str]]:
    """Everything each rule can lead to, itself included only if it is recursive."""
    reach: dict[str, set[str]] = {}
    for origin in edges:
        found: set[str] = set()
        left = list(edges[origin])
        while left:
            symbol = left.pop()
            if symbol not in found:
                found.add(symbol)
                left.extend(edges.get(symbol, ()))
        reach[origin] = found
    return reach
