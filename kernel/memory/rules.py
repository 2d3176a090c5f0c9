"""The rules in force, found by the words they need."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Final

from kernel.memory.index import WordIndex
from kernel.memory.lesson import Lesson, Rule
from kernel.net.graphlet import Graphlet
from kernel.net.node import Net

UNWANTED_KEPT: Final = 1000  # ours: of the robot's own rules that it was told to forget


@dataclass(slots=True, eq=False)
class RuleInForce:
    """A rule lesson at work. strength: its belief now, which may have been adapted; the lesson keeps the taught one."""

    lesson: Lesson
    rule: Rule
    strength: float

    @property
    def order(self) -> int:
        """In which order rules are taken where nothing else decides."""
        return abs(self.lesson.ident)


class RuleBook:
    """Rule lessons by the words of their conditions.

    Attributes:
        added, removed, weighed: what changed since the halo last took note (weighed: the belief).
    """

    def __init__(self) -> None:
        self._index: WordIndex[RuleInForce] = WordIndex()
        self._loose: dict[RuleInForce, None] = {}
        self._by_lesson: dict[int, RuleInForce] = {}
        self._contents: dict[Rule, int] = {}
        self._unwanted: dict[Rule, None] = {}
        self.added: dict[RuleInForce, None] = {}
        self.removed: dict[RuleInForce, None] = {}
        self.weighed: dict[RuleInForce, None] = {}

    def __len__(self) -> int:
        return len(self._by_lesson)

    @property
    def changed(self) -> bool:
        """Whether the halo has to take note of something."""
        return bool(self.added or self.removed or self.weighed)

    def add(self, lesson: Lesson) -> None:
        """Put a rule lesson in force, believed as taught.

        Raises:
            TypeError: the lesson is not a rule.
        """
        rule = lesson.content
        if not isinstance(rule, Rule):
            raise TypeError(rule)
        if lesson.ident in self._by_lesson:
            self.remove(lesson)
        self._unwanted.pop(_bare(rule), None)
        new = RuleInForce(lesson, rule, rule.belief)
        self._by_lesson[lesson.ident] = new
        content = _bare(rule)
        self._contents[content] = self._contents.get(content, 0) + 1
        if is_loose(rule.condition):
            self._loose[new] = None
        keys = {max(t.lex, key=lambda w: (len(w), w)) for t in rule.condition.terms if t.lex}
        self._index.add(new, keys, rule.condition.words())
        self.added[new] = None

    def remove(self, lesson: Lesson) -> None:
        """Retire a rule lesson; what it concluded goes. One that is not in force is no matter."""
        old = self._by_lesson.pop(lesson.ident, None)
        if old is None:
            return
        self._index.remove(old)
        self._loose.pop(old, None)
        content = _bare(old.rule)
        self._contents[content] -= 1
        if not self._contents[content]:
            del self._contents[content]
        if lesson.origins:
            self._unwanted[content] = None  # what a person had it forget it does not make again
            while len(self._unwanted) > UNWANTED_KEPT:
                del self._unwanted[next(iter(self._unwanted))]
        self.weighed.pop(old, None)
        if old in self.added:
            del self.added[old]
        else:
            self.removed[old] = None

    def believe(self, lesson: Lesson, belief: float) -> None:
        """Change how far a rule in force is believed; its conclusions follow."""
        there = self._by_lesson.get(lesson.ident)
        if there is not None and there.strength != belief:
            there.strength = belief
            self.weighed[there] = None

    def get(self, ident: int) -> RuleInForce | None:
        """The rule of this lesson, if it is in force."""
        return self._by_lesson.get(ident)

    def is_new(self, rule: Rule) -> bool:
        """Whether no equal rule is in force, whatever its belief, and none that the robot made was retired."""
        content = _bare(rule)
        return content not in self._contents and content not in self._unwanted

    def is_possible(self, rule: RuleInForce, net: Net) -> bool:
        """Whether the net has every word that the rule's condition needs."""
        return all(map(net.has_word, rule.rule.condition.words()))

    def possible(self, net: Net) -> list[RuleInForce]:
        """Rules for whose conditions the net has every word."""
        return self._index.possible(net)

    def concerned(self, words: Iterable[str], net: Net) -> list[RuleInForce]:
        """Those among them with one of these words in the condition."""
        return self._index.concerned(words, net)

    def loose(self) -> Iterable[RuleInForce]:
        """Rules that have to be tried at every change."""
        return self._loose


def is_loose(graphlet: Graphlet) -> bool:
    """Whether something in it has no word and no neighbour with one: then no word tells that it may match anew."""
    near = set()
    for term in graphlet.terms:
        ends = [name for _, name in term.links]
        if term.lex:
            near |= {term.name, *ends}
        for name in ends:
            if any(t.lex for t in graphlet.terms if t.name == name):
                near.add(term.name)
    return not graphlet.mentioned <= near


def _bare(rule: Rule) -> Rule:
    """The rule whatever its belief."""
    return rule if rule.belief == 1.0 else replace(rule, belief=1.0)
