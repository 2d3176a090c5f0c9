"""Chunking: two steps of inference that were used become one rule.

Source: Connell 2019, section 3 ("a consolidated rule can be formed"); how names meet is ours.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from kernel.memory.lesson import Rule, graphlets
from kernel.memory.notation import canonical
from kernel.net.graphlet import Graphlet, Term


def chunk(first: Rule, second: Rule, same: Mapping[str, str]) -> Rule | None:
    """The rule that concludes in one step what `second` concludes from what `first` concluded.

    Args:
        first: the rule of the first step.
        second: the rule of the second step.
        same: names in the condition of `second` to the names in `first` that stand for the same node.

    Returns:
        Canonical: the condition of `first` with what else `second` needs, the conclusion of `second`, exceptions of
        both, belief the product. It concludes wherever both rules do in two steps and the names of the two that are not
        in `same` stand for different things. None where that is no rule: something else than the first conclusion
        itself speaks of what the first rule made, the two do not fit each other, or the chunk would conclude its own
        condition.
    """
    names = _names_for(first, second, same)
    needed, concluded = second.condition.renamed(names), second.conclusion.renamed(names)
    exceptions = (*first.unless, *(g.renamed(names) for g in second.unless))
    made = first.conclusion.mentioned - first.condition.mentioned
    terms = {t.name: t for t in first.condition.terms}
    for term in needed.terms:
        if term.name in made:
            if not _provides(first.conclusion, term):
                return None
            continue
        if any(to in made for _, to in term.links):
            return None
        merged = _merged(terms.get(term.name), _without_given(first, term))
        if merged is None:
            return None
        terms[term.name] = merged
    conclusion = _conclusion(first, concluded, made)
    if conclusion is None or any(g.mentioned & made for g in exceptions):
        return None
    condition = Graphlet(tuple(terms.values()), first.condition.main)
    if not conclusion.names.isdisjoint(condition.names) and _says_nothing(condition, conclusion):
        return None
    belief = round(first.belief * second.belief, 6)  # as far as notation tells them apart
    rule = Rule(condition, conclusion, tuple(dict.fromkeys(exceptions)), belief)
    return canonical(rule)


def _names_for(first: Rule, second: Rule, same: Mapping[str, str]) -> dict[str, str]:
    """New names for those of the second rule: shared ones as in the first, the others unlike any there."""
    taken = {name for g in graphlets(first) for name in g.mentioned}
    highest = max((int(name.rpartition("-")[2] or 0) for name in taken), default=0)
    names: dict[str, str] = dict(same)
    for graphlet in graphlets(second):
        for name in sorted(graphlet.mentioned):
            if name not in names:
                highest += 1
                names[name] = f"{name.rpartition('-')[0]}-{highest}"
    return names


def _provides(conclusion: Graphlet, wanted: Term) -> bool:
    """Whether the conclusion makes a node that fits this term."""
    return any(
        term.name == wanted.name
        and wanted.lex <= term.lex
        and wanted.negated == term.negated
        and wanted.literal in (None, term.literal)
        and set(wanted.links) <= set(term.links)
        for term in conclusion.terms
    )


def _without_given(first: Rule, term: Term) -> Term:
    """The term without the words that the first rule, an alias, adds to it."""
    if term.name != first.conclusion.main or term.name not in first.condition.mentioned:
        return term
    added = first.conclusion.head.lex if first.conclusion.head is not None else frozenset()
    return replace(term, lex=term.lex - added)


def _merged(there: Term | None, more: Term) -> Term | None:
    """One term that asks for what both ask for, or None."""
    if there is None:
        return more
    literals = {there.literal, more.literal} - {None}
    if there.negated != more.negated or len(literals) > 1:
        return None
    links = tuple(sorted({*there.links, *more.links}))
    return replace(there, lex=there.lex | more.lex, links=links, literal=next(iter(literals), None))


def _conclusion(first: Rule, concluded: Graphlet, made: frozenset[str]) -> Graphlet | None:
    """The second conclusion, of what is there without the first; a further word of its node is a node of its own."""
    if not concluded.mentioned & made:
        return concluded
    if concluded.main not in made or (concluded.mentioned - {concluded.main}) & made:
        return None
    (word,) = (t for t in concluded.terms if t.name == concluded.main)
    (node,) = (t for t in first.conclusion.terms if t.name == concluded.main)
    if any(to in made for _, to in node.links):
        return None
    rest = tuple(t for t in concluded.terms if t.name != concluded.main)
    return Graphlet((replace(node, lex=word.lex), *rest), concluded.main)


def _says_nothing(condition: Graphlet, conclusion: Graphlet) -> bool:
    """An alias to a word that its condition asks for."""
    asked = {t.name: t.lex for t in condition.terms}
    return all(t.lex <= asked.get(t.name, frozenset()) for t in conclusion.terms)
