"""The halo: what the rules conclude now.

Band 1 rests on working memory, band 2 on working memory and band 1, nothing goes deeper (Connell 2019, section 3:
deduction is limited to two steps). It is derived anew when working memory changes and is never stored.
"""

from __future__ import annotations

from kernel.memory.lesson import Lesson, Rule
from kernel.memory.rules import RuleBook
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding, holds, matches
from kernel.net.node import BAND_1, BAND_2, WORKING, Net, Node, instantiate


class Halo:
    """Conclusions as nodes of the net, made and unmade here alone."""

    def __init__(self, net: Net, threshold: float = 0.2) -> None:
        """threshold: premises below it conclude nothing; caution may count weak ones (mind.md: 0.2)."""
        self._net = net
        self._threshold = threshold
        self.nodes: list[Node] = []

    def clear(self) -> None:
        """Drop every conclusion."""
        self._net.clear_overlay()
        for node in self.nodes:
            self._net.drop(node)
        self.nodes.clear()

    def derive(self, rules: RuleBook) -> None:
        """Conclude afresh from what is in working memory."""
        self.clear()
        for band in (BAND_1, BAND_2):
            depth = WORKING if band == BAND_1 else BAND_1
            # All conclusions of a band are collected first: one band never feeds itself.
            found = [
                (lesson, rule, binding)
                for lesson, rule in rules.candidates(self._net)
                for binding in matches(rule.condition, self._net, depth, threshold=self._threshold)
                if not any(
                    holds(g, self._net, depth, _shared(g, binding), self._threshold)
                    for g in rule.unless
                )
            ]
            for lesson, rule, binding in found:
                self._conclude(lesson, rule, binding, band)

    def _conclude(self, lesson: Lesson, rule: Rule, binding: Binding, band: int) -> None:
        conclusion = rule.conclusion
        main = binding.get(conclusion.main)
        if main is not None:
            words = next(
                (t.lex for t in conclusion.terms if t.name == conclusion.main), frozenset()
            )
            for word in sorted(words):
                if word not in main.words():
                    self._net.overlay(main, word, band)
            return
        known = _shared(conclusion, binding)
        if holds(conclusion, self._net, band, known, 0.0):
            return
        if holds(conclusion.denied(), self._net, WORKING, known, 0.0):
            return  # a person said otherwise, and told facts beat conclusions
        premises = [binding[t.name] for t in rule.condition.terms if t.name in binding]
        belief = rule.belief * min((node.belief for node in premises), default=1.0)
        bound = instantiate(self._net, conclusion, known)
        for name, node in bound.items():
            if name not in known:
                node.level, node.belief = band, belief
                node.reasons, node.rule = frozenset(premises), lesson.ident
                self.nodes.append(node)


def _shared(graphlet: Graphlet, binding: Binding) -> Binding:
    return {name: binding[name] for name in graphlet.mentioned if name in binding}
