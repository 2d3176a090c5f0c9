"""An automaton over words: the form in which the recognisers get the language, and what they ask of it."""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

LONGEST_SAMPLE = 12
"""Words after which a sampled sentence takes the shortest way to its end."""


@dataclass(frozen=True)
class Automaton:
    """An automaton without empty moves.

    Attributes:
        start: the state it begins in.
        finals: the states it may end in.
        arcs: (from, word, to), sorted.
    """

    start: int
    finals: frozenset[int]
    arcs: tuple[tuple[int, str, int], ...]

    @cached_property
    def moves(self) -> Mapping[int, Mapping[str, frozenset[int]]]:
        """The arcs by state and word."""
        found: dict[int, dict[str, frozenset[int]]] = {}
        for source, word, target in self.arcs:
            here = found.setdefault(source, {})
            here[word] = here[word] | {target} if word in here else frozenset((target,))
        return found

    @property
    def words(self) -> frozenset[str]:
        """Every word on an arc."""
        return frozenset(word for _, word, _ in self.arcs)

    @property
    def size(self) -> int:
        """Number of states."""
        return 1 + max((max(source, target) for source, _, target in self.arcs), default=0)

    def after(self, words: Iterable[str]) -> frozenset[int]:
        """The states these words lead to; empty if nothing in the language begins so."""
        states = frozenset({self.start})
        for word in words:
            here = (self.moves.get(state, {}).get(word, frozenset()) for state in states)
            states = frozenset[int]().union(*here)
        return states

    def accepts(self, words: Iterable[str]) -> bool:
        """Whether the words are a whole sentence."""
        return bool(self.after(words) & self.finals)


def sample(automaton: Automaton, count: int, chance: random.Random) -> list[str]:
    """Draw sentences; the same random source draws the same ones. Fewer than count if there are fewer.

    A walk ends at a final state as a coin says, and goes straight to the end once it is LONGEST_SAMPLE words long.
    """
    _, ways_out = _shortest_ways(automaton)
    drawn: dict[str, None] = {}
    for _ in range(count * 4):
        if len(drawn) == count:
            break
        state, said = automaton.start, list[str]()
        while state not in automaton.finals or (state in automaton.moves and chance.random() < 0.6):
            if len(said) >= LONGEST_SAMPLE:
                said.extend(ways_out[state])
                break
            word = chance.choice(sorted(automaton.moves[state]))
            state = chance.choice(sorted(automaton.moves[state][word]))
            said.append(word)
        drawn.setdefault(" ".join(said))
    return list(drawn)


def _shortest_ways(
    automaton: Automaton,
) -> tuple[Mapping[int, tuple[str, ...]], Mapping[int, tuple[str, ...]]]:
    """For each state, the fewest words that lead to it, and from it to an end."""
    onward: dict[int, list[tuple[str, int]]] = {}
    back: dict[int, list[tuple[str, int]]] = {}
    for source, word, target in automaton.arcs:
        onward.setdefault(source, []).append((word, target))
        back.setdefault(target, []).append((word, source))
    ways_in: dict[int, tuple[str, ...]] = {automaton.start: ()}
    for state in (left := [automaton.start]):
        for word, target in onward.get(state, ()):
            if target not in ways_in:
                ways_in[target] = (*ways_in[state], word)
                left.append(target)
    ways_out: dict[int, tuple[str, ...]] = dict.fromkeys(automaton.finals, ())
    for state in (left := sorted(automaton.finals)):
        for word, source in back.get(state, ()):
            if source not in ways_out:
                ways_out[source] = (word, *ways_out[state])
                left.append(source)
    return ways_in, ways_out


def useful(automaton: Automaton) -> Automaton:
    """Without the states that no sentence passes through."""
    onward: dict[int, set[int]] = {}
    back: dict[int, set[int]] = {}
    for source, _, target in automaton.arcs:
        onward.setdefault(source, set()).add(target)
        back.setdefault(target, set()).add(source)

    def reached(sources: Iterable[int], edges: Mapping[int, set[int]]) -> set[int]:
        found = set(sources)
        left = list(found)
        while left:
            for state in edges.get(left.pop(), ()):
                if state not in found:
                    found.add(state)
                    left.append(state)
        return found

    kept = reached([automaton.start], onward) & reached(automaton.finals, back)
    arcs = tuple(arc for arc in automaton.arcs if arc[0] in kept and arc[2] in kept)
    finals = frozenset(automaton.finals & kept)
    return renumbered(replace(automaton, finals=finals, arcs=arcs))


def renumbered(automaton: Automaton) -> Automaton:
    """Number the states in the order a reader meets them, so that equal languages look equal."""
    numbers = {automaton.start: 0}
    left = [automaton.start]
    rows: dict[int, list[tuple[str, int]]] = {}
    for source, word, target in automaton.arcs:
        rows.setdefault(source, []).append((word, target))
    for state in left:
        for _, target in sorted(rows.get(state, ())):
            if target not in numbers:
                numbers[target] = len(numbers)
                left.append(target)
    arcs = sorted((numbers[source], word, numbers[to]) for source, word, to in automaton.arcs)
    finals = frozenset(numbers[state] for state in automaton.finals)
    return replace(automaton, start=0, finals=finals, arcs=tuple(arcs))
