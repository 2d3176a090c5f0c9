"""The halo: what the rules conclude now.

Band 1 rests on working memory, band 2 on working memory and band 1, nothing goes deeper (Connell 2019, section 3:
deduction is limited to two steps). It is never stored. It follows the changes of the net one by one: rules that fire
are kept, those that rest on a changed node go, and a changed node is tried with the rules that have a word of it. What
comes of it is always what deriving everything afresh would give.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

from kernel.memory.fired import Fired, discard
from kernel.memory.instance import Conclusion, Instance, Key, Plan, may_hold, telling_words
from kernel.memory.rules import RuleBook, RuleInForce
from kernel.net.changes import Changes
from kernel.net.match import holds, solutions
from kernel.net.node import BAND_1, BAND_2, Net, Node

PREMISE_THRESHOLD: Final = (
    0.2  # mind.md: caution counts premises down to here; others look at the conclusion's belief
)


class Halo:
    """Conclusions as nodes and further words of the net, made and unmade here alone."""

    def __init__(self, net: Net, rules: RuleBook, threshold: float = PREMISE_THRESHOLD) -> None:
        """threshold: premises below it conclude nothing."""
        self._net, self._rules, self._threshold = net, rules, threshold
        self._plans: dict[RuleInForce, Plan] = {}
        self._fired = Fired()
        self._conclusions: dict[Key, Conclusion] = {}
        self._by_word: dict[str, dict[Conclusion, None]] = {}
        self._of: dict[Node, Conclusion] = {}
        self._unsettled: dict[Conclusion, None] = {}

    # -- looking ---------------------------------------------------------------------------

    @property
    def nodes(self) -> list[Node]:
        """Nodes that stand for conclusions."""
        return list(self._of)

    def conclusion(self, node: Node, word: str = "") -> Conclusion | None:
        """The conclusion that this node stands for, or that this word of it is; the nearer band first."""
        if not word:
            return self._of.get(node)
        for band in (BAND_1, BAND_2):
            found = self._conclusions.get((band, word, node))
            if found is not None and found.best is not None:
                return found
        return None

    def resting_on(self, node: Node) -> Iterator[Node]:
        """Nodes concluded now with this one as a premise."""
        for instance in self._fired.on(node):
            for key in instance.keys:
                conclusion = self._conclusions[key]
                if conclusion.best is instance and node in instance.premises:
                    yield from conclusion.made

    # -- following -------------------------------------------------------------------------

    def update(self, changes: Changes) -> None:
        """Follow the changes of working memory and rules."""
        rules = self._rules
        for rule in rules.removed:
            self._withdraw(self._fired.by(rule))
            self._plans.pop(rule, None)
        for rule in rules.weighed:
            for instance in self._fired.by(rule):
                self._unsettle(instance)
        self._withdraw(self._fired.resting_on((*changes.dropped, *changes.altered), BAND_1))
        for rule in rules.added:
            if rules.is_possible(rule, self._net):
                self._match(rule)
        rules.added.clear()
        rules.removed.clear()
        rules.weighed.clear()
        words = telling_words(changes)
        self._seed(changes)
        self._review(words, BAND_1)
        self._settle(BAND_1)
        self._second_band()

    def rebuild(self) -> None:
        """Derive everything afresh."""
        for changed in (self._rules.added, self._rules.removed, self._rules.weighed):
            changed.clear()
        self._clear()
        self._net.take_changes()
        for rule in self._rules.possible(self._net):
            self._match(rule)
        self._settle(BAND_1)
        self._second_band()

    def _second_band(self) -> None:
        """Conclude from what the first band has changed."""
        changes = self._net.take_changes()
        if changes:
            self._withdraw(self._fired.resting_on((*changes.dropped, *changes.altered), BAND_2))
            self._seed(changes)
            self._review(telling_words(changes), BAND_2)
        self._settle(BAND_2)
        self._net.take_changes()  # band 2 concerns no rule

    def _clear(self) -> None:
        """Conclude nothing."""
        for conclusion in self._conclusions.values():
            self._retract(conclusion)
        self._fired.clear()
        self._conclusions.clear()
        self._by_word.clear()
        self._unsettled.clear()

    def _seed(self, changes: Changes) -> None:
        """Try the rules that may fire anew."""
        nodes = dict.fromkeys((*changes.extended, *changes.altered))
        for node in [n for n in nodes if n in self._net]:
            if node in changes.altered or not node.lex:
                nodes |= {other: None for _, other in (*node.links, *node.into)}
        for node in nodes:
            if node.level <= BAND_1 and node in self._net and (words := node.words()):
                for rule in self._rules.concerned(words, self._net):
                    for term in rule.rule.condition.terms:
                        if term.lex and term.lex <= words:
                            self._match(rule, term.name, node)
        for rule in self._rules.loose():
            self._withdraw(self._fired.by(rule))
            if self._rules.is_possible(rule, self._net):
                self._match(rule)

    def _match(self, rule: RuleInForce, name: str = "", node: Node | None = None) -> None:
        """Add every instance of the rule, or those in which the name is this node; its words are all there."""
        bound = {name: node} if node is not None else {}
        terms = list(rule.rule.condition.terms)
        plan = self._plans.get(rule)
        for binding in solutions(terms, self._net, BAND_1, bound, self._threshold):
            if plan is None:
                plan = self._plans[rule] = Plan.of(rule.rule)
            ident = (rule, *map(binding.__getitem__, plan.names))
            if ident not in self._fired:
                self._add(Instance.of(rule, plan, binding, self._threshold), ident)

    def _add(self, instance: Instance, ident: Key) -> None:
        self._fired.add(instance, ident)
        instance.blocked = bool(instance.plan.unless) and self._excepted(instance)
        for key in instance.keys:
            conclusion = self._conclusions.get(key)
            if conclusion is None:
                words = frozenset({str(key[1])}) if instance.plan.alias else instance.plan.words
                conclusion = self._conclusions[key] = Conclusion(key, words)
                for word in words:
                    self._by_word.setdefault(word, {})[conclusion] = None
            conclusion.instances[instance] = None
            self._unsettled[conclusion] = None

    def _withdraw(self, instances: Iterable[Instance]) -> None:
        for instance in list(instances):
            self._fired.remove(instance)
            for key in instance.keys:
                conclusion = self._conclusions[key]
                conclusion.instances.pop(instance, None)
                self._unsettled[conclusion] = None

    def _unsettle(self, instance: Instance) -> None:
        for key in instance.keys:
            self._unsettled[self._conclusions[key]] = None

    def _review(self, words: Iterable[str], least_band: int) -> None:
        """Look again at exceptions and at conclusions that may be known or denied otherwise now."""
        for word in sorted(w for w in words if w in self._by_word or self._fired.watching(w)):
            for instance in self._fired.watching(word):
                blocked = self._excepted(instance)
                if blocked != instance.blocked and instance.band >= least_band:
                    instance.blocked = blocked
                    self._unsettle(instance)
            for conclusion in self._by_word.get(word, ()):
                if conclusion.band >= least_band:
                    self._unsettled[conclusion] = None

    def _excepted(self, instance: Instance) -> bool:
        return instance.excepted(self._net, instance.band - 1, self._threshold)

    # -- concluding ------------------------------------------------------------------------

    def _settle(self, band: int) -> None:
        for conclusion in [c for c in self._unsettled if c.band == band]:
            del self._unsettled[conclusion]
            best = self._best(conclusion)
            if best is not None and (
                self._is_known(conclusion, best) or best.contradicted(self._net, conclusion.key)
            ):
                best = None
            if best is None:
                self._retract(conclusion)
            elif best.plan.alias:
                conclusion.best = best
                _, word, node = conclusion.key
                assert isinstance(node, Node)
                self._net.overlay(node, str(word), band, best.belief)
            else:
                self._assert(conclusion, best)
            if not conclusion.instances:
                self._forget(conclusion)

    def _best(self, conclusion: Conclusion) -> Instance | None:
        """The instance that is believed most; of equal ones that of the older rule and the older premises."""
        best: Instance | None = None
        for instance in conclusion.instances:
            if instance.blocked:
                continue
            if (
                best is None
                or instance.belief > best.belief
                or (instance.belief == best.belief and self._rank(instance) < self._rank(best))
            ):
                best = instance
        return best

    def _rank(self, instance: Instance) -> tuple[object, ...]:
        nodes = tuple(self._node_rank(instance.binding[name]) for name in instance.plan.names)
        return (instance.rule.order, instance.plan.names, nodes)

    def _node_rank(self, node: Node) -> tuple[object, ...]:
        """An order of nodes that does not depend on when the halo made them."""
        conclusion = self._of.get(node)
        if conclusion is None:
            return (0, node.number)
        known = tuple(self._node_rank(n) for n in conclusion.key[2:] if isinstance(n, Node))
        return (1, str(conclusion.key[1]), known, list(conclusion.made).index(node))

    def _is_known(self, conclusion: Conclusion, best: Instance) -> bool:
        """Whether something nearer says the same and is believed as much."""
        nearer, pattern = conclusion.band - 1, best.rule.rule.conclusion
        if best.plan.alias:
            node = best.binding[pattern.main]
            return node.known_as(str(conclusion.key[1]), nearer, best.belief)
        if not all(map(self._net.has_word, pattern.words())):
            return False
        if not may_hold(pattern, nearer, best.known):
            return False
        return holds(pattern, self._net, nearer, best.known, best.belief)

    def _assert(self, conclusion: Conclusion, best: Instance) -> None:
        if conclusion.best is None:
            self._make(conclusion, best)
        if conclusion.best is not best:
            reasons = frozenset(best.premises)
            for node in conclusion.made:
                node.reasons, node.rule = reasons, best.rule.lesson.ident
        conclusion.best = best
        for node in conclusion.made:
            self._net.believe(node, best.belief)

    def _make(self, conclusion: Conclusion, best: Instance) -> None:
        plan = best.plan
        bound = dict(best.known)
        for term in plan.new:
            node = bound[term.name] = self._net.from_term(term)
            node.level, node.belief = conclusion.band, best.belief
            conclusion.made[node] = plan.canon[term.name]
            self._of[node] = conclusion
        for term in plan.new:
            for role, to in term.links:
                self._net.link(bound[term.name], role, bound[to])

    def _retract(self, conclusion: Conclusion) -> None:
        if conclusion.best is None:
            return
        if conclusion.best.plan.alias:
            _, word, node = conclusion.key
            assert isinstance(node, Node)
            self._net.lift(node, str(word), conclusion.band)
        for node in self._give_up(conclusion):
            self._net.drop(node)

    def release(self, conclusion: Conclusion) -> list[Node]:
        """Give the conclusion's nodes away: they are not the halo's any more."""
        self._unsettled[conclusion] = None
        return self._give_up(conclusion)

    def _give_up(self, conclusion: Conclusion) -> list[Node]:
        made, conclusion.made, conclusion.best = list(conclusion.made), {}, None
        for node in made:
            del self._of[node]
        return made

    def _forget(self, conclusion: Conclusion) -> None:
        del self._conclusions[conclusion.key]
        for word in conclusion.words:
            discard(self._by_word, word, conclusion)
