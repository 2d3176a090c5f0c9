"""Rules that fire, and what they conclude: the data of the halo."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from kernel.memory.contraries import ended_by
from kernel.memory.lesson import Rule
from kernel.memory.rules import RuleInForce, is_loose
from kernel.net.canon import canonical_names
from kernel.net.changes import Changes
from kernel.net.graphlet import Graphlet, Term
from kernel.net.match import Binding, holds, matches
from kernel.net.node import BAND_1, WORKING, Net, Node

Key = tuple[
    object, ...
]  # what is concluded: equal for two rules that conclude the same of the same


@dataclass(frozen=True, slots=True)
class Unless:
    """An unless-pattern: names it shares with the condition, and words that tell it may have come to hold or not."""

    pattern: Graphlet
    shared: tuple[str, ...]
    words: frozenset[str]


@dataclass(frozen=True, slots=True)
class Plan:
    """What is worked out once for a rule that fires.

    Attributes:
        names: every name of the condition, sorted.
        alias: words that the conclusion adds to a node of the condition; empty if it makes nodes of its own.
        shape: text of the conclusion, equal for equal ones; known: names of the condition in it, in order.
        canon: canonical name of every name of the conclusion.
        new: terms of the nodes that the conclusion makes.
        denied: the contraries of the conclusion.
        words: of the conclusion; "" among them where a word alone does not tell.
    """

    names: tuple[str, ...]
    alias: tuple[str, ...]
    shape: str
    known: tuple[str, ...]
    canon: dict[str, str]
    new: tuple[Term, ...]
    denied: tuple[Graphlet, ...]
    words: frozenset[str]
    unless: tuple[Unless, ...]

    @classmethod
    def of(cls, rule: Rule) -> Plan:
        """Work it out."""
        condition, conclusion = rule.condition.mentioned, rule.conclusion
        words = conclusion.head.lex if conclusion.head is not None else ()
        alias = tuple(sorted(words)) if conclusion.main in condition else ()
        canon = canonical_names([conclusion])
        known = tuple(
            sorted((n for n in conclusion.mentioned if n in condition), key=canon.__getitem__)
        )
        names = canon | {name: f"known-{index}" for index, name in enumerate(known)}
        shape = repr(
            sorted(
                (names[t.name], sorted(t.lex), t.literal or "", t.negated,
                 sorted((role, names[to]) for role, to in t.links))
                for t in conclusion.terms
            )
        )  # fmt: skip
        denied = tuple(ended_by(conclusion, condition))
        return cls(
            tuple(sorted(condition)),
            alias,
            shape,
            known,
            canon,
            () if alias else tuple(_made(conclusion, condition)),
            denied,
            frozenset().union(*map(_telling, (conclusion, *denied))),
            tuple(
                Unless(g, tuple(n for n in sorted(g.mentioned) if n in condition), _telling(g))
                for g in rule.unless
            ),
        )


def _made(conclusion: Graphlet, condition: frozenset[str]) -> Iterator[Term]:
    """The terms of what the condition does not name; of what is only linked to, too."""
    described = {term.name: term for term in conclusion.terms}
    names = dict.fromkeys((conclusion.main, *described))
    names |= {to: None for term in conclusion.terms for _, to in term.links}
    for name in names:
        if name not in condition:
            yield described.get(name, Term(name))


def _telling(graphlet: Graphlet) -> frozenset[str]:
    words = graphlet.words()
    return words | {""} if is_loose(graphlet) else words


@dataclass(slots=True, eq=False)
class Instance:
    """A rule's condition met.

    Attributes:
        band: BAND_1 if by working memory alone, else BAND_2.
        premise: belief of the least believed premise.
        premises: nodes it rests on; words: (node, word): concluded words it rests on.
        keys: what it concludes; known: the part of the binding that the conclusion mentions.
        blocked: an exception holds.
    """

    rule: RuleInForce
    plan: Plan
    binding: Binding
    band: int
    premise: float
    premises: tuple[Node, ...]
    words: tuple[tuple[Node, str], ...]
    keys: tuple[Key, ...]
    known: Binding
    blocked: bool = False

    @property
    def belief(self) -> float:
        """Rule belief times lowest premise belief (mind.md)."""
        return self.rule.strength * self.premise

    @classmethod
    def of(cls, rule: RuleInForce, plan: Plan, binding: Binding, threshold: float) -> Instance:
        """The instance for a match of the condition within BAND_1 that was found with this threshold."""
        premises, words = [], []
        band = WORKING
        for node in binding.values():
            if node.level > band:
                band = node.level
        for term in rule.rule.condition.terms:
            node = binding[term.name]
            premises.append(node)
            for word in term.lex:
                if word not in node.lex:
                    words.append((node, word))
                    band = max(band, _level(node, word, threshold)[0])
        band += 1
        known = {name: binding[name] for name in plan.known}
        keys: tuple[Key, ...]
        if plan.alias:
            main = binding[rule.rule.conclusion.main]
            keys = tuple((band, word, main) for word in plan.alias)
        else:
            keys = ((band, plan.shape, *known.values()),)
        words.sort(key=lambda item: (item[0].number, item[1]))
        made = cls(rule, plan, binding, band, 1.0, tuple(premises), tuple(words), keys, known)
        made.weigh(threshold)
        return made

    def weigh(self, threshold: float) -> None:
        """Take the premises' beliefs as they are now."""
        least = 1.0
        for node in self.premises:
            if node.belief < least:
                least = node.belief
        for node, word in self.words:
            least = min(least, _level(node, word, threshold)[1])
        self.premise = least

    def excepted(self, net: Net, depth: int, threshold: float) -> bool:
        """Whether an exception of the rule holds."""
        return any(
            holds(e.pattern, net, depth, {n: self.binding[n] for n in e.shared}, threshold)
            for e in self.plan.unless
        )

    def contradicted(self, net: Net, key: Key) -> bool:
        """Whether what was told or sensed says the contrary: that beats any conclusion."""
        if self.plan.alias:
            return _told_otherwise(net, self.binding[self.rule.rule.conclusion.main], str(key[1]))
        return any(
            match[denied.main].rule == 0
            for denied in self.plan.denied
            if all(map(net.has_word, denied.words())) and may_hold(denied, WORKING, self.known)
            for match in matches(denied, net, WORKING, self.known, 0.0)
        )


def _level(node: Node, word: str, threshold: float) -> tuple[int, float]:
    """The nearest level at which the word is concluded and believed that much, and its belief there."""
    return min(
        ((n, belief) for n, belief in node.halo_lex.get(word, {}).items() if belief >= threshold),
        default=(WORKING, 1.0),  # it was told meanwhile
    )


def _told_otherwise(net: Net, node: Node, word: str) -> bool:
    """Whether the node under this further word says the contrary of a told one."""
    return bool(node.links) and any(
        word in other.lex
        and other.negated != node.negated
        and other.level == WORKING
        and other.rule == 0
        and all(link in other.links for link in node.links)
        for other in net.with_word(word)
    )


@dataclass(slots=True, eq=False)
class Conclusion:
    """Something rules conclude: the instances that do, and the nodes or word that stand for it.

    Attributes:
        best: the instance it is asserted by; None while it is not.
        words: that may tell that it is known or denied otherwise.
        made: for a conclusion with nodes of its own, each node's canonical name in it.
    """

    key: Key
    words: frozenset[str]
    instances: dict[Instance, None] = field(default_factory=dict)
    best: Instance | None = None
    made: dict[Node, str] = field(default_factory=dict)

    @property
    def band(self) -> int:
        """BAND_1 or BAND_2."""
        return BAND_1 if self.key[0] == BAND_1 else BAND_1 + 1


def may_hold(graphlet: Graphlet, depth: int, known: Binding) -> bool:
    """A cheap look before matching: does anything within the depth say of a known thing what the main term says?"""
    if graphlet.main in known:
        return True
    main = graphlet.head
    if main is None:
        return True
    for role, name in main.links:
        if (thing := known.get(name)) is not None:
            return any(
                r == role and node.level <= depth and node.negated == main.negated
                for r, node in thing.into
            )
    return True


def telling_words(changes: Changes) -> dict[str, None]:
    """Words that tell which patterns the changes can concern; "" always does."""
    words: dict[str, None] = {"": None, **changes.words}
    for group, wide in (
        (changes.extended, False),
        (changes.altered, True),
        (changes.dropped, False),
    ):
        for node in group:
            words |= dict.fromkeys(node.words())
            if wide or not node.lex:
                for _, other in (*node.links, *node.into):
                    words |= dict.fromkeys(other.words())
    return words
