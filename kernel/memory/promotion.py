"""Conclusions that were used: taken into working memory, with their reasons, for as long as these last.

Source: Connell 2019, section 3 (halo nodes that take part in a match are moved into working memory). When they go is
mind.md's.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from kernel.memory.halo import PREMISE_THRESHOLD, Halo
from kernel.memory.instance import Instance, Key
from kernel.memory.rules import RuleBook
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding
from kernel.net.node import WORKING, Net, Node

Item = tuple[Node, str]  # a node that was concluded (""), or a concluded word of a node


@dataclass(frozen=True, slots=True)
class Step:
    """One step behind an item that was used: what fired, and the canonical name of each node it made."""

    item: Item
    instance: Instance
    made: Mapping[Node, str]


@dataclass(slots=True)
class Promotion:
    """An item in working memory. holders: for a word, marks of the foci that used it."""

    step: Step
    key: Key
    holders: list[Node] = field(default_factory=list)


def items_used(patterns: Iterable[Graphlet], binding: Binding) -> list[Item]:
    """Concluded nodes and words without which the patterns would not hold under the binding."""
    items: dict[Item, None] = {}
    for pattern in patterns:
        nodes = (binding[name] for name in sorted(pattern.mentioned) if name in binding)
        items |= {(node, ""): None for node in nodes if node.rule}
        for term in pattern.terms:
            if (node := binding.get(term.name)) is not None:
                items |= {(node, word): None for word in sorted(term.lex) if word not in node.lex}
    return list(items)


class Promotions:
    """The promoted conclusions of one memory."""

    def __init__(self, net: Net, halo: Halo, rules: RuleBook) -> None:
        self._net, self._halo, self._rules = net, halo, rules
        self._promoted: dict[Item, Promotion] = {}

    def __len__(self) -> int:
        return len(self._promoted)

    def __contains__(self, item: Item) -> bool:
        return item in self._promoted

    def step(self, item: Item) -> Step | None:
        """The inference that the item comes from, None if it was told."""
        there = self._promoted.get(item)
        if there is not None:
            return there.step
        conclusion = self._halo.conclusion(*item)
        if conclusion is None or conclusion.best is None:
            return None
        return Step(item, conclusion.best, conclusion.made)

    def steps_before(self, step: Step) -> list[Step]:
        """The inferences that this one rests on."""
        items: list[Item] = [(node, "") for node in step.instance.premises if node.rule]
        found = [self.step(item) for item in (*items, *step.instance.words)]
        return [s for s in found if s is not None]

    def resting_on(self, node: Node) -> list[Node]:
        """Promoted nodes with this one as a premise."""
        return [n for n, word in self._promoted if not word and node in n.reasons]

    # -- promoting -------------------------------------------------------------------------

    def promote(self, items: Iterable[Item], holder: dict[Node, None]) -> list[Step]:
        """Take items into working memory with what they rest on.

        Args:
            items: see items_used.
            holder: nodes of the focus that used them; what is promoted is added, and stays while it is in attention.

        Returns:
            The steps promoted now, reasons before what rests on them.
        """
        done: list[Step] = []
        for item in items:
            self._promote(item, holder, done)
        return done

    def _promote(self, item: Item, holder: dict[Node, None], done: list[Step]) -> None:
        step = self.step(item)
        if step is None:
            return
        for before in self.steps_before(step):
            self._promote(before.item, holder, done)
        holder |= dict.fromkeys(step.instance.premises)
        if item not in self._promoted:
            done.append(self._take(step))
        if item[1]:
            self._hold(self._promoted[item], holder)
        else:
            holder |= dict.fromkeys(self._promoted[item].step.made)

    def _take(self, step: Step) -> Step:
        (node, word), instance = step.item, step.instance
        conclusion = self._halo.conclusion(node, word)
        if conclusion is None:
            return step
        step = Step(step.item, instance, dict(conclusion.made))
        if word:
            self._promoted[step.item] = Promotion(step, conclusion.key)
            self._net.overlay(node, word, WORKING, instance.belief)
            return step
        for made in self._halo.release(conclusion):
            self._net.place(made, WORKING)
            self._promoted[made, ""] = Promotion(step, conclusion.key)
        return step

    def _hold(self, promotion: Promotion, holder: dict[Node, None]) -> None:
        """A word is no node that a focus could hold: a mark stands for it."""
        if not any(mark in holder for mark in promotion.holders):
            mark = self._net.new("use")
            promotion.holders.append(mark)
            holder[mark] = None

    # -- ending ----------------------------------------------------------------------------

    def prune(self, words: Iterable[str]) -> bool:
        """Drop what has lost its focus, a reason, its rule, or was denied; words: see telling_words.

        Returns:
            Whether anything was dropped.
        """
        told = set(words)
        before = len(self._promoted)
        # Reasons were promoted before what rests on them, so one pass sees every consequence.
        for item, promotion in list(self._promoted.items()):
            if not self._lasts(promotion, told):
                del self._promoted[item]
                node, word = item
                if word:
                    self._net.lift(node, word, WORKING)
                else:
                    self._net.drop(node)
            else:
                promotion.step.instance.weigh(PREMISE_THRESHOLD)
                self._follow_belief(item, promotion.step.instance.belief)
        return len(self._promoted) != before

    def _lasts(self, promotion: Promotion, told: set[str]) -> bool:
        instance, (node, word) = promotion.step.instance, promotion.step.item
        if (
            node not in self._net
            or self._rules.get(instance.rule.lesson.ident) is not instance.rule
            or (word and not any(mark in self._net for mark in promotion.holders))
            or not all(n in self._net and n.level == WORKING for n in instance.binding.values())
            or not all(n.belief >= PREMISE_THRESHOLD for n in instance.premises)
            or not all(n.known_as(w, WORKING, PREMISE_THRESHOLD) for n, w in instance.words)
        ):
            return False
        if told.isdisjoint(instance.plan.words) and all(
            told.isdisjoint(unless.words) for unless in instance.plan.unless
        ):
            return True
        return not (
            instance.contradicted(self._net, promotion.key)
            or instance.excepted(self._net, WORKING, PREMISE_THRESHOLD)
        )

    def _follow_belief(self, item: Item, belief: float) -> None:
        node, word = item
        if word:
            self._net.overlay(node, word, WORKING, belief)
        else:
            self._net.believe(node, belief)


def shared_names(first: Step, second: Instance) -> dict[str, str]:
    """Names in the condition of the second rule to those of the first rule that stand for the same nodes."""
    of = {node: name for name, node in first.instance.binding.items()}
    named = {canonical: name for name, canonical in first.instance.plan.canon.items()}
    of |= {node: named[canonical] for node, canonical in first.made.items()}
    return {name: of[node] for name, node in second.binding.items() if node in of}
