"""The operators in force, found by directive tag and the words of the trigger."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kernel.memory.index import WordIndex
from kernel.memory.lesson import Lesson, Operator
from kernel.memory.rules import is_loose
from kernel.net.graphlet import Graphlet
from kernel.net.node import Net, Node


class Operators:
    """Operator lessons by tag and word.

    NOTE triggers are filed under a word of each of their terms: a noted fact has to take part. The others are filed
    under a word of their main node, or under none ("if Rick tells you to do something don't").
    """

    def __init__(self) -> None:
        self._by_tag: dict[str, WordIndex[int]] = {}
        self._lessons: dict[int, tuple[Lesson, Operator]] = {}
        self._numbers: dict[int, int] = {}
        self._count = 0

    def __len__(self) -> int:
        return len(self._lessons)

    def add(self, lesson: Lesson) -> None:
        """Put an operator lesson in force.

        Raises:
            TypeError: the lesson is not an operator.
        """
        operator = lesson.content
        if not isinstance(operator, Operator):
            raise TypeError(operator)
        self.remove(lesson)
        self._count += 1
        self._numbers[lesson.ident] = self._count
        self._lessons[self._count] = lesson, operator
        tag, graphlet = operator.trigger.tag, operator.trigger.graphlet
        keys = _keys(tag, graphlet) if graphlet else ()
        words = graphlet.words() if graphlet else ()
        self._by_tag.setdefault(tag, WordIndex()).add(self._count, keys, words)

    def remove(self, lesson: Lesson) -> None:
        """Retire an operator lesson; one that is not in force is no matter."""
        number = self._numbers.pop(lesson.ident, None)
        if number is not None:
            _, operator = self._lessons.pop(number)
            self._by_tag[operator.trigger.tag].remove(number)

    def for_node(self, tag: str, node: Node, net: Net) -> Iterator[Lesson]:
        """Operators whose main node might be this one, in the order they were taught."""
        return self._found(tag, node.words(), net)

    def for_facts(self, facts: Iterable[Node], net: Net) -> Iterator[Lesson]:
        """NOTE operators in which one of these nodes might take part."""
        words: set[str] = set()
        for node in facts:
            words |= node.words()
            for _, other in (*node.links, *node.into):
                words |= other.words()
        return self._found("NOTE", words, net)

    def _found(self, tag: str, words: Iterable[str], net: Net) -> Iterator[Lesson]:
        index = self._by_tag.get(tag)
        if index is not None:
            for number in sorted(index.concerned(words, net)):
                yield self._lessons[number][0]


def _keys(tag: str, graphlet: Graphlet) -> list[str]:
    """A word of every term that something noted could match, or of the main term."""
    if tag == "NOTE":
        if is_loose(graphlet):
            return []
        terms = [term for term in graphlet.terms if term.lex]
    else:
        terms = [graphlet.head] if graphlet.head is not None and graphlet.head.lex else []
    return [max(term.lex, key=lambda word: (len(word), word)) for term in terms]
