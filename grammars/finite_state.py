"""The grammar as a finite-state automaton: what the recognisers are told may be said.

The rules of the parser (context-free, word categories as terminals) are compiled once: left and right recursion become
loops, recursion in the middle is unrolled to a bounded depth, and the result is determinised and minimised while a
category is still one token. Only then does a vocabulary put its words in the place of the categories, so a thousand
names cost a thousand arcs where a name may stand and nothing else.

The automaton may hear less than the parser reads (deep nesting), and now and then more (words of two categories): the
parser decides what may act.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from grammars.automaton import Automaton, renumbered, useful

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
    ("can", "not"): "can't",
    ("is", "not"): "isn't",
    ("what", "is"): "what's",
    ("where", "is"): "where's",
    ("that", "is"): "that's",
}
POSSESSIVE = "'s"
"""What the parser reads as two words and people say as one."""

Rule = tuple[str, tuple[str, ...]]
"""A name, and what may be written for it. What no rule is named after is a terminal."""


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
    spoken = {*_short_forms(arcs), *(arc for arc in arcs if arc[1] != POSSESSIVE)}
    return useful(replace(skeleton, arcs=tuple(sorted(spoken))))


def _short_forms(arcs: Iterable[tuple[int, str, int]]) -> Iterator[tuple[int, str, int]]:
    seconds = {POSSESSIVE, *(second for _, second in SHORT_FORMS)}
    onward: dict[int, list[tuple[str, int]]] = {}
    for source, word, target in arcs:
        if word in seconds:
            onward.setdefault(source, []).append((word, target))
    for source, first, middle in arcs:
        for second, target in onward.get(middle, ()):
            if second == POSSESSIVE:
                yield source, first + POSSESSIVE, target
            elif short := SHORT_FORMS.get((first, second)):
                yield source, short, target


class Compiler:
    """Compiles each rule once for each set of rules it stands inside of."""

    def __init__(self, rules: Iterable[Rule], max_depth: int = MAX_DEPTH) -> None:
        self.rules: dict[str, list[tuple[str, ...]]] = {}
        for origin, symbols in rules:
            self.rules.setdefault(origin, []).append(symbols)
        self._max_depth = max_depth
        self._made: dict[tuple[str, tuple[str, ...]], Automaton] = {}
        self._reach = _closure(
            {origin: {s for way in ways for s in way} for origin, ways in self.rules.items()}
        )

    def compiled(self, origin: str, inside: tuple[str, ...] = ()) -> Automaton:
        """The minimal automaton of a rule that stands inside these; its words are the terminals.

        Raises:
            KeyError: there is no such rule.
        """
        relevant = tuple(sorted(rule for rule in inside if rule in self._reach[origin]))
        key = (origin, relevant)
        if key not in self._made:
            self._made[key] = self._compile(origin, relevant)
        return self._made[key]

    def sequence(self, symbols: Sequence[str]) -> Automaton:
        """The minimal automaton of symbols in a row."""
        draft, state = _Draft(), 0
        for symbol in symbols:
            state = self._append(draft, state, symbol, ())
        draft.skip(state, 1)
        return draft.finished(0, 1)

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
