"""Which operators apply to a directive, and how: triggers, enablements, exceptions, permissions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain
from typing import Final

from kernel.commons import Commons
from kernel.memory.attention import Focus
from kernel.memory.lesson import Lesson, Operator
from kernel.memory.recall import known, may_be_somebody
from kernel.memory.wondering import SEEKING_VERBS
from kernel.net.graphlet import Graphlet, Term
from kernel.net.match import Binding, holds, matches
from kernel.net.node import Node
from kernel.using import use

ALWAYS_CONSIDERED: Final = ("ANTE", "POST", "ALLOW")


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
        supposed: nodes of the condition that is entertained (kernel.hypothesis): triggers see them, nothing else does.
        desperate: what is hardly believed or hardly liked counts too.
        ruled_out: the only operators that apply are being run already.
    """

    commons: Commons
    focus: Focus
    within: tuple[Lesson, ...]
    node: Node | None = None
    facts: tuple[Node, ...] = ()
    supposed: frozenset[Node] = frozenset()
    desperate: bool = False
    ruled_out: bool = False

    @property
    def threshold(self) -> float:
        """Belief below which a match does not count."""
        return self.commons.settings.premises(self.desperate)

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
        if tag == "DO":
            lessons = chain(lessons, self._searching())
        for lesson in lessons:
            operator = lesson.content
            if not isinstance(operator, Operator) or operator.trigger.graphlet is None:
                continue
            preference = self.commons.policy.strength(lesson)
            liked = preference >= self.commons.settings.least_preference
            if not (liked or self.desperate or tag in ALWAYS_CONSIDERED):
                continue
            choice = self._match(lesson, operator, self._threshold_for(operator))
            if choice is None:
                continue
            if lesson in self.within:  # advice does not apply to the carrying out of itself
                self.ruled_out = self.ruled_out or tag == "DO"
                continue
            yield choice

    def _sought(self) -> Node | None:
        """What a seeking act is after: the ball of "find the ball"."""
        seeking = self.node is not None and self.node.words() & SEEKING_VERBS
        return next(self.node.to("obj"), None) if self.node and seeking else None

    def _searching(self) -> Iterator[Lesson]:
        """How a thing is found is advice for the act of finding it, too."""
        if (thing := self._sought()) is not None:
            yield from self.commons.operators.for_node("FIND", thing, self.commons.memory.net)

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
        if operator.trigger.tag == "FIND" and (sought := self._sought()) is not None:
            start = {trigger.main: sought}
        elif operator.trigger.tag != "NOTE" and self.node is not None:
            start = {trigger.main: self.node}
        for binding in matches(trigger, net, depth, start, threshold, self.supposed):
            if operator.trigger.tag == "NOTE" and not self._takes_part(binding):
                continue
            if not all(may_be_somebody(n) for n in _somebodies(trigger, binding)):
                continue
            enabled = self._enabled(operator.enablement, binding, threshold)
            if enabled is None or any(
                self._excepted(g, enabled, threshold) for g in operator.unless
            ):
                continue
            terms = (*trigger.terms, *(t for g in operator.enablement for t in g.terms))
            # One that says nothing is not written, and must not count before a restart either.
            telling = sum(term != Term(term.name) for term in terms)
            return Chosen(lesson, operator, enabled, max(1, telling))
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

    def _excepted(self, exception: Graphlet, binding: Binding, threshold: float) -> bool:
        """Whether the exception holds; one about the speaker ("only Mary may ...") for whoever may be speaking."""
        memory, bound = self.commons.memory, known(exception, binding)
        starts = [bound]
        if (teller := _teller((exception,))) and teller not in bound:
            starts = [{**bound, teller: who} for who in self.speakers()] or starts
        return all(holds(exception, memory.net, memory.depth, s, threshold) for s in starts)

    def speakers(self) -> tuple[Node, ...]:
        """Where it is unsure which of several known persons speaks: these."""
        act = self.focus.speech_act
        found = tuple(act.to("agt")) if act is not None else ()
        return found[1:]

    def permitted(self, prohibition: Chosen) -> bool:
        """Whether permissions at least as specific void this prohibition; on a tie the newer one counts.

        A veto about a speaker is lifted only by a permission that names that speaker: all of them, where it is unsure
        who speaks. Nobody lifts a prohibition of somebody else's that is not theirs (Commons.may).
        """
        about_speaker = names_speaker(prohibition.operator)
        by: list[Chosen] = []
        for permission in self.applicable("ALLOW"):
            if about_speaker and not _named_teller(permission.operator):
                continue
            if not self.commons.may(permission.lesson.teacher, prohibition.lesson):
                continue
            newer = permission.lesson.ident > prohibition.lesson.ident
            if permission.specificity > prohibition.specificity or (
                permission.specificity == prohibition.specificity and newer
            ):
                by.append(permission)
        speakers = self.speakers()
        for permission in by:
            if speakers and _named_teller(permission.operator):
                continue
            use(self.commons, self.focus, permission.operator.patterns, permission.binding)
            self.commons.record("permitted", self.focus, by=permission.lesson.words)
            return True
        named = [permission for permission in by if _named_teller(permission.operator)]
        return bool(speakers) and all(
            any(self._allows(permission, who) for permission in named) for who in speakers
        )

    def _allows(self, permission: Chosen, speaker: Node) -> bool:
        """Whether it permits this very speaker."""
        teller = _named_teller(permission.operator)
        words = next(
            (t.lex for g in permission.operator.patterns for t in g if t.name == teller),
            frozenset(),
        )
        return bool(words) and words <= speaker.words()


def _somebodies(trigger: Graphlet, binding: Binding) -> list[Node]:
    """What stands where the trigger has "somebody"."""
    return [binding[term.name] for term in trigger if term.ref == "somebody"]


def names_speaker(operator: Operator) -> bool:
    """Whether it asks who gave the order."""
    return bool(_teller(operator.patterns))


def names_act(operator: Operator) -> bool:
    """Whether its trigger says which act it is about."""
    trigger = operator.trigger.graphlet
    return trigger is not None and trigger.head is not None and bool(trigger.head.lex)


def _teller(graphlets: tuple[Graphlet, ...]) -> str:
    """Name of who gives the order, "" where none is asked about."""
    for term in (term for graphlet in graphlets for term in graphlet):
        if "cmd" in dict(term.links):
            return dict(term.links).get("agt", "?")
    return ""


def _named_teller(operator: Operator) -> str:
    """The same, if he is called by his name."""
    teller = _teller(operator.patterns)
    named = any(t.name == teller and t.lex for g in operator.patterns for t in g)
    return teller if named else ""
