"""The rules in force, found by the words their conditions need."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from kernel.memory.lesson import Lesson, Rule
from kernel.net.node import Net


class RuleBook:
    """Rule lessons by one word each of their conditions: only rules whose word is in mind are tried."""

    def __init__(self) -> None:
        self._by_word: dict[str, list[tuple[Lesson, Rule]]] = {}

    def add(self, lesson: Lesson) -> None:
        """Put a rule lesson in force.

        Raises:
            TypeError: the lesson is not a rule.
        """
        if not isinstance(lesson.content, Rule):
            raise TypeError(lesson.content)
        self._by_word.setdefault(_key(lesson.content), []).append((lesson, lesson.content))

    def remove(self, lesson: Lesson) -> None:
        """Take a rule lesson out of force."""
        if isinstance(lesson.content, Rule):
            there = self._by_word[_key(lesson.content)]
            there[:] = [pair for pair in there if pair[0].ident != lesson.ident]

    def believe(self, lesson: Lesson, belief: float) -> None:
        """From now on conclude by the rule with this belief; the taught one stays with the lesson."""
        if isinstance(lesson.content, Rule):
            there = self._by_word[_key(lesson.content)]
            at = next(i for i, (known, _) in enumerate(there) if known.ident == lesson.ident)
            there[at] = (lesson, replace(lesson.content, belief=belief))

    def candidates(self, net: Net) -> Iterator[tuple[Lesson, Rule]]:
        """Rules that might fire on what the net holds, in the order they were taught."""
        found: list[tuple[Lesson, Rule]] = list(self._by_word.get("", ()))
        words: Iterable[str] = net.present_words()
        if len(self._by_word) < len(net):
            words = [word for word in self._by_word if net.has_word(word)]
        for word in words:
            found += self._by_word.get(word, ())
        found.sort(key=lambda pair: abs(pair[0].ident))
        return iter(found)


def _key(rule: Rule) -> str:
    """The longest word of the condition: long words are rare ones."""
    return max(rule.condition.words(), key=lambda word: (len(word), word), default="")
