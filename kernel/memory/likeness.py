"""How lessons compare: equal, contradicting, never to fire. Pure; all ours, the paper has no such thing.

Small on purpose: what is found here is asked about, so it must be plain to a person that it is so. What was meant by a
question is matched more leniently: kernel.memory.meant.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Final, Literal, TypeVar

from kernel.action.chain import Chain, Directive
from kernel.memory.lesson import Content, Operator, Rule
from kernel.memory.notation import canonical, mapped
from kernel.net.graphlet import Graphlet, Term
from kernel.net.match import Binding, holds, matches
from kernel.net.node import WORKING, Net, instantiate

C = TypeVar("C", bound=Content)
OPPOSITES: Final = {
    frozenset(pair)
    for pair in (
        ("forward", "backward"),
        ("left", "right"),
        ("clockwise", "counterclockwise"),
        ("up", "down"),
        ("raise", "lower"),
        ("grab", "release"),
    )
}


def plain(content: C) -> C:
    """Canonical, without strength and without how things were referred to: what is compared."""
    unreferred: C = mapped(
        content, lambda g: Graphlet(tuple(replace(t, ref="") for t in g.terms), g.main)
    )
    match unreferred:
        case Rule():
            unreferred = replace(unreferred, belief=1.0)
        case Operator():
            unreferred = replace(unreferred, preference=1.0)
    return canonical(unreferred)


def alike(one: Content, other: Content) -> bool:
    """Equal but for strength: the same net, whatever sentence it came from."""
    return type(one) is type(other) and plain(one) == plain(other)


def contradicts(one: Content, other: Content) -> bool:
    """Whether no robot can follow both.

    Rules: opposite conclusions, and whenever the condition of one holds, so does the other's; a hedged rule
    ("usually") leaves room for others, unless their conditions are equal. A prohibition and a permission of the same
    thing under the same conditions. Two reactions to the same whose single acts differ in nothing but in words that are
    opposite. Two ways to do one thing are no contradiction.
    """
    match one, other:
        case Rule(), Rule():
            return _opposed(one, other) or _opposed(other, one)
        case Operator(), Operator():
            return _forbidden_and_permitted(one, other) or _opposite_reactions(one, other)
    return False


def _opposed(narrow: Rule, wide: Rule) -> bool:
    """Where the condition of `narrow` holds `wide` concludes the opposite."""
    if wide.unless or _denies(wide.conclusion) == _denies(narrow.conclusion):
        return False
    net, bound = _drawn([narrow.condition, narrow.conclusion])
    conditions = {t.name for t in narrow.condition.terms}
    conclusions = {n for n in bound if n not in narrow.condition.mentioned}
    concluded = {bound[n] for n in conclusions} or {bound[narrow.conclusion.main]}
    for found in matches(wide.condition, net, WORKING, threshold=0.0):
        if concluded & {found[t.name] for t in wide.condition.terms}:
            continue
        equal = len(wide.condition.terms) == len(conditions)
        if not equal and (narrow.belief < 1.0 or wide.belief < 1.0):
            continue
        shared = {n: node for n, node in found.items() if n in wide.conclusion.mentioned}
        for opposite in matches(wide.conclusion.denied(), net, WORKING, shared, 0.0):
            if opposite[wide.conclusion.main] is bound[narrow.conclusion.main]:
                return True
    return False


def _denies(conclusion: Graphlet) -> bool:
    return conclusion.head is not None and conclusion.head.negated


def _forbidden_and_permitted(one: Operator, other: Operator) -> bool:
    if one.trigger.tag == "ALLOW":
        one, other = other, one
    return one.forbids and other.trigger.tag == "ALLOW" and _when(one) == _when(other)


def _opposite_reactions(one: Operator, other: Operator) -> bool:
    if not (one.trigger.tag == other.trigger.tag == "NOTE" and _when(one) == _when(other)):
        return False
    deeds = [operator.chain.tagged("DO") for operator in (one, other)]
    if len(deeds[0]) != 1 or len(deeds[1]) != 1:
        return False
    (mine,), (others,) = deeds
    differing = mine.words() ^ others.words()
    return len(mine.terms) == len(others.terms) and differing in OPPOSITES


def _when(operator: Operator) -> Operator:
    """Trigger and conditions alone."""
    return plain(replace(operator, trigger=replace(operator.trigger, tag=""), chain=Chain()))


Never = Literal["both", "always_excepted", "only_itself", "denies_itself", "nothing_new"]


def never_fires(content: Content) -> Never | None:
    """Why the lesson can never come to anything.

    "both": it asks that something be so and not so; "always_excepted": an exception holds whenever it would apply;
    "only_itself": the procedure's steps are nothing but itself; "denies_itself", "nothing_new": the rule concludes that
    its own condition is not so, or is so.
    """
    match content:
        case Rule(condition=condition, unless=unless):
            return _vain([condition], unless) or _circular(content)
        case Operator(trigger=Directive(graphlet=trigger), enablement=enablement, unless=unless):
            needed = [g for g in (trigger, *enablement) if g is not None]
            return _vain(needed, unless) or _only_itself(content)
    return None


def _vain(needed: list[Graphlet], unless: tuple[Graphlet, ...]) -> Never | None:
    terms = [term for graphlet in needed for term in graphlet]
    if any(_denied_by(term, terms) for term in terms if term.negated):
        return "both"
    net, bound = _drawn(needed)
    for graphlet in unless:
        known = {n: bound[n] for n in graphlet.mentioned if n in bound}
        if holds(graphlet, net, WORKING, known, 0.0):
            return "always_excepted"
    return None


def _denied_by(denial: Term, terms: list[Term]) -> bool:
    """Something that is asked for says all that is denied, its modifiers included."""
    return any(
        not term.negated
        and (term.lex, term.literal, term.links) == (denial.lex, denial.literal, denial.links)
        and _modified(denial.name, terms) <= _modified(term.name, terms)
        for term in terms
    )


def _modified(name: str, terms: Iterable[Term]) -> set[tuple[str, frozenset[str]]]:
    return {(role, term.lex) for term in terms for role, to in term.links if to == name}


def _circular(rule: Rule) -> Never | None:
    net, bound = _drawn([rule.condition])
    known = {n: bound[n] for n in rule.conclusion.mentioned if n in bound}
    if len(known) == len(rule.conclusion.mentioned):  # an alias: the conclusion adds a word
        return None
    if holds(rule.conclusion.denied(), net, WORKING, known, 0.0):
        return "denies_itself"
    return "nothing_new" if holds(rule.conclusion, net, WORKING, known, 0.0) else None


def _only_itself(operator: Operator) -> Never | None:
    trigger = operator.does
    if trigger is None:
        return None
    acts = operator.chain.tagged("DO")
    return "only_itself" if acts and all(covers(trigger, (act,), act) for act in acts) else None


def covers(pattern: Graphlet, drawn: Iterable[Graphlet], main: Graphlet | None = None) -> bool:
    """Whether the pattern is found in what the graphlets together describe; with `main`, as what that is about."""
    return bool(covering(pattern, drawn, main))


def covering(
    pattern: Graphlet, drawn: Iterable[Graphlet], main: Graphlet | None = None
) -> dict[str, str]:
    """Which name of the graphlets each name of the pattern is; empty where the pattern is not in them."""
    if main is not None and not _same_words(pattern, main):
        return {}
    net, bound = _drawn(drawn)
    start: Binding = {} if main is None else {pattern.main: bound[main.main]}
    names = {node: name for name, node in bound.items()}
    found = next(matches(pattern, net, WORKING, start, 0.0), None)
    return {} if found is None else {name: names[node] for name, node in found.items()}


def _same_words(pattern: Graphlet, other: Graphlet) -> bool:
    """A quick no: the words of the main nodes."""
    wanted, there = pattern.head, other.head
    return wanted is None or there is None or wanted.lex <= there.lex


def _drawn(graphlets: Iterable[Graphlet]) -> tuple[Net, Binding]:
    """The graphlets as nodes of a net of their own; shared names are one node, described wherever they are."""
    terms: dict[str, Term] = {}
    main = ""
    for graphlet in graphlets:
        main = main or graphlet.main
        for term in graphlet:
            terms.setdefault(term.name, term)
    net = Net()
    return net, instantiate(net, Graphlet(tuple(terms.values()), main), {}) if main else {}
