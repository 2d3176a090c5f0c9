"""Lessons in force by what they might be equal to, contradict or be about, so that few have to be compared (ours)."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from kernel.memory.lesson import Content, Lesson, Operator, Rule
from kernel.memory.likeness import alike, contradicts
from kernel.net.graphlet import Graphlet

Key = tuple[str, frozenset[str]]


class Shelves:
    """Each lesson by all of its words, and by what a contradiction would have to be about (facts: told ones are taken
    back by their opposites at once)."""

    def __init__(self) -> None:
        self._cases: dict[str, dict[frozenset[str], dict[int, Lesson]]] = {}

    def add(self, lesson: Lesson) -> None:
        """Put it where its like would be."""
        for sort, words in _keys(lesson.content):
            self._cases.setdefault(sort, {}).setdefault(words, {})[lesson.ident] = lesson

    def remove(self, lesson: Lesson) -> None:
        """Take it away."""
        for sort, words in _keys(lesson.content):
            shelf = self._cases[sort][words]
            del shelf[lesson.ident]
            if not shelf:
                del self._cases[sort][words]

    def alike(self, content: Content) -> list[Lesson]:
        """Lessons equal to it but for strength, newest first."""
        return [x for x in self._on(_keys(content)[0]) if alike(x.content, content)]

    def contradicting(self, content: Content) -> Lesson | None:
        """The newest lesson that it contradicts."""
        there = self._on(_keys(content)[1])
        return next((x for x in there if contradicts(x.content, content)), None)

    def mentioning(self, words: frozenset[str]) -> list[Lesson]:
        """Rules and operators with all of these words somewhere in them, newest first."""
        return self._where(("rule", "operator"), words.issubset)

    def triggered(self, words: frozenset[str]) -> list[Lesson]:
        """Operators with any of these words in the trigger, newest first."""
        return self._where(("trigger",), words.intersection)

    def _where(
        self, sorts: tuple[str, ...], fits: Callable[[frozenset[str]], object]
    ) -> list[Lesson]:
        found = [
            lesson
            for sort in sorts
            for there, shelf in self._cases.get(sort, {}).items()
            if fits(there)
            for lesson in shelf.values()
        ]
        return sorted(found, key=lambda lesson: -lesson.ident)

    def _on(self, key: Key) -> Iterator[Lesson]:
        sort, words = key
        return reversed(list(self._cases.get(sort, {}).get(words, {}).values()))


def _keys(content: Content) -> tuple[Key, ...]:
    match content:
        case Rule(condition=condition, conclusion=conclusion, unless=unless):
            words = condition.words().union(conclusion.words(), *(g.words() for g in unless))
            return ("rule", words), ("conclusion", conclusion.words())
        case Operator(trigger=trigger, chain=chain):
            asked = trigger.graphlet.words() if trigger.graphlet else frozenset()
            steps = [d.graphlet for d in chain.directives() if d.graphlet]
            parts = (*content.enablement, *content.unless, *steps)
            return ("operator", asked.union(*(g.words() for g in parts))), ("trigger", asked)
        case Graphlet():
            return (("fact", content.words()),)
