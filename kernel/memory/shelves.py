"""Lessons in force by what they might be equal to or contradict, so that few have to be compared (ours)."""

from __future__ import annotations

from collections.abc import Iterator

from kernel.memory.lesson import Content, Lesson, Operator, Rule
from kernel.memory.likeness import alike, contradicts
from kernel.net.graphlet import Graphlet

Key = tuple[str, frozenset[str]]


class Shelves:
    """Each lesson by all of its words, and by what a contradiction would have to be about (facts: told ones are taken
    back by their opposites at once)."""

    def __init__(self) -> None:
        self._shelves: dict[Key, dict[int, Lesson]] = {}

    def add(self, lesson: Lesson) -> None:
        """Put it where its like would be."""
        for key in _keys(lesson.content):
            self._shelves.setdefault(key, {})[lesson.ident] = lesson

    def remove(self, lesson: Lesson) -> None:
        """Take it away."""
        for key in _keys(lesson.content):
            shelf = self._shelves[key]
            del shelf[lesson.ident]
            if not shelf:
                del self._shelves[key]

    def alike(self, content: Content) -> list[Lesson]:
        """Lessons equal to it but for strength, newest first."""
        return [x for x in self._on(_keys(content)[0]) if alike(x.content, content)]

    def contradicting(self, content: Content) -> Lesson | None:
        """The newest lesson that it contradicts."""
        there = self._on(_keys(content)[1])
        return next((x for x in there if contradicts(x.content, content)), None)

    def _on(self, key: Key) -> Iterator[Lesson]:
        return reversed(list(self._shelves.get(key, {}).values()))


def _keys(content: Content) -> tuple[Key, ...]:
    match content:
        case Rule(condition=condition, conclusion=conclusion):
            words = condition.words() | conclusion.words()
            return ("rule", words), ("conclusion", conclusion.words())
        case Operator(trigger=trigger, chain=chain):
            asked = trigger.graphlet.words() if trigger.graphlet else frozenset()
            steps = (d.graphlet.words() for d in chain.directives() if d.graphlet)
            return ("operator", asked.union(*steps)), ("trigger", asked)
        case Graphlet():
            return (("fact", content.words()),)
