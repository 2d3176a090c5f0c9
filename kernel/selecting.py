"""Which operators apply to a directive, and how: triggers, enablements, exceptions, permissions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from kernel.commons import Commons
from kernel.memory.attention import Focus
from kernel.memory.lesson import Lesson, Operator
from kernel.memory.recall import known
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding, holds, matches
from kernel.net.node import Node
from kernel.using import use


@dataclass(frozen=True, slots=True)
class Chosen:
    """An operator that applies, and how."""

    lesson: Lesson
    operator: Operator
    binding: Binding
    specificity: int


@dataclass(slots=True)
class Selection:
    """What a directive looks for operators with.

    Attributes:
        within: operators being carried out already; their advice does not apply to the carrying out of itself.
        node: the directive's main node; facts: the nodes noted, for NOTE.
        threshold: belief below which a match does not count.
        ruled_out: the only operators that apply are being run already.
    """

    commons: Commons
    focus: Focus
    within: tuple[Lesson, ...]
    threshold: float
    node: Node | None = None
    facts: tuple[Node, ...] = ()
    ruled_out: bool = False

    def applicable(self, tag: str) -> Iterator[Chosen]:
        """Operators of the tag whose trigger and enablement match."""
        memory = self.commons.memory
        memory.refresh()
        if tag == "NOTE":
            nodes = memory.resting_on(self.facts)
            lessons: Iterator[Lesson] = self.commons.operators.for_facts(nodes, memory.net)
        elif self.node is not None:
            lessons = self.commons.operators.for_node(tag, self.node, memory.net)
        else:
            return
        self.ruled_out = False
        for lesson in lessons:
            operator = lesson.content
            if not isinstance(operator, Operator) or operator.trigger.graphlet is None:
                continue
            if operator.preference < self.commons.settings.least_preference and tag in (
                "NOTE",
                "DO",
            ):
                continue
            choice = self._match(lesson, operator, self._threshold_for(operator))
            if choice is None:
                continue
            if lesson in self.within:  # advice does not apply to the carrying out of itself
                self.ruled_out = self.ruled_out or tag == "DO"
                continue
            yield choice

    def _threshold_for(self, operator: Operator) -> float:
        """A prohibition counts weak premises, a permission only strong ones (mind.md)."""
        if operator.prohibits:
            return self.commons.settings.prohibition_threshold
        if operator.trigger.tag == "ALLOW":
            return self.commons.settings.permission_threshold
        return self.threshold

    def _match(self, lesson: Lesson, operator: Operator, threshold: float) -> Chosen | None:
        """The first binding under which the operator applies, or None."""
        memory = self.commons.memory
        net, depth, trigger = memory.net, memory.depth, operator.trigger.graphlet
        if trigger is None:
            return None
        start: Binding = {}
        if operator.trigger.tag != "NOTE" and self.node is not None:
            start = {trigger.main: self.node}
        for binding in matches(trigger, net, depth, start, threshold):
            if operator.trigger.tag == "NOTE" and not self._takes_part(binding):
                continue
            enabled = self._enabled(operator.enablement, binding, threshold)
            if enabled is None or any(
                holds(g, net, depth, known(g, enabled), threshold) for g in operator.unless
            ):
                continue
            terms = (*trigger.terms, *(t for g in operator.enablement for t in g.terms))
            return Chosen(lesson, operator, enabled, max(1, len(terms)))
        return None

    def _enabled(
        self, patterns: tuple[Graphlet, ...], binding: Binding, threshold: float
    ) -> Binding | None:
        """The binding extended so that all patterns hold."""
        if not patterns:
            return binding
        memory = self.commons.memory
        for more in matches(patterns[0], memory.net, memory.depth, binding, threshold):
            whole = self._enabled(patterns[1:], more, threshold)
            if whole is not None:
                return whole
        return None

    def _takes_part(self, binding: Binding) -> bool:
        """Whether the noted fact, or a conclusion that rests on it, is in the match."""
        facts = set(self.facts)
        return any(
            node in facts or node.reasons & facts or any(r.reasons & facts for r in node.reasons)
            for node in binding.values()
        )

    def permitted(self, prohibition: Chosen) -> bool:
        """Whether a permission at least as specific voids this prohibition; on a tie the newer one counts."""
        about_speaker = names_speaker(prohibition.operator)
        for permission in self.applicable("ALLOW"):
            if about_speaker and not names_speaker(permission.operator):
                continue
            newer = permission.lesson.ident > prohibition.lesson.ident
            if permission.specificity > prohibition.specificity or (
                permission.specificity == prohibition.specificity and newer
            ):
                use(self.commons, self.focus, permission.operator.asks, permission.binding)
                self.commons.record("permitted", self.focus, by=permission.lesson.words)
                return True
        return False


def names_speaker(operator: Operator) -> bool:
    """Whether it asks who gave the order."""
    graphlets = (operator.trigger.graphlet, *operator.enablement)
    return any(role == "cmd" for g in graphlets if g for t in g.terms for role, _ in t.links)
