"""The operators in force, found by directive tag and a word of the trigger."""

from __future__ import annotations

from collections.abc import Iterator

from kernel.memory.lesson import Lesson, Operator
from kernel.net.graphlet import Graphlet
from kernel.net.node import Net, Node


class Operators:
    """Operator lessons by tag and word.

    NOTE triggers are filed under their rarest-looking word; the others under a word of their main node, or "" where it
    has none ("if Rick tells you to do something don't").
    """

    def __init__(self) -> None:
        self._by_key: dict[tuple[str, str], list[Lesson]] = {}
        self._reactions: dict[str, list[Lesson]] = {}

    def add(self, lesson: Lesson) -> None:
        """Put an operator lesson in force.

        Raises:
            TypeError: the lesson is not an operator.
        """
        self._shelf(lesson).append(lesson)

    def remove(self, lesson: Lesson) -> None:
        """Take an operator lesson out of force."""
        self._shelf(lesson).remove(lesson)

    def _shelf(self, lesson: Lesson) -> list[Lesson]:
        if not isinstance(lesson.content, Operator):
            raise TypeError(lesson.content)
        trigger = lesson.content.trigger
        word = _key(trigger.tag, trigger.graphlet) if trigger.graphlet else ""
        if trigger.tag == "NOTE":
            return self._reactions.setdefault(word, [])
        return self._by_key.setdefault((trigger.tag, word), [])

    def for_node(self, tag: str, node: Node) -> Iterator[Lesson]:
        """Operators whose main node might be this one."""
        for word in ("", *sorted(node.words())):
            yield from self._by_key.get((tag, word), ())

    def for_fact(self, net: Net) -> Iterator[Lesson]:
        """NOTE operators whose words are in mind."""
        for word, lessons in self._reactions.items():
            if not word or net.has_word(word):
                yield from lessons


def _key(tag: str, graphlet: Graphlet) -> str:
    if tag == "NOTE":
        words = graphlet.words()
    else:
        words = next((t.lex for t in graphlet.terms if t.name == graphlet.main), frozenset())
    return max(words, key=lambda word: (len(word), word), default="")
