"""What the halo must hold, worked out by brute force from what the rules mean."""

from __future__ import annotations

import copy
from typing import Any

from kernel.memory.halo import PREMISE_THRESHOLD
from kernel.memory.instance import Plan
from kernel.memory.rules import RuleInForce
from kernel.memory.working import WorkingMemory
from kernel.net.match import holds, matches
from kernel.net.node import BAND_1, BAND_2, WORKING, Net, Node, instantiate


def rank(node: Node, made: dict[Node, Any]) -> Any:
    """A name of the node that is the same in every derivation."""
    return made.get(node, node.number)


def seen(memory: WorkingMemory, exactly: bool = False) -> set[Any]:
    """The halo as it is: conclusions and concluded words. exactly: with the rule and reasons of each."""
    halo = memory.halo
    made: dict[Node, Any] = {}
    for band in (BAND_1, BAND_2):
        for node in halo.nodes:
            conclusion = halo.conclusion(node)
            assert conclusion is not None
            if conclusion.band == band:
                known = tuple(rank(n, made) for n in conclusion.key[2:])
                made[node] = (band, conclusion.key[1], known, conclusion.made[node])
    found = set()
    for node, name in made.items():
        why = (node.rule, frozenset(rank(n, made) for n in node.reasons)) if exactly else ()
        found.add((name, round(node.belief, 9), why))
        assert node.level == name[0]
    for node in memory.net:
        for word, levels in node.halo_lex.items():
            found |= {(rank(node, made), word, at, round(b, 9)) for at, b in levels.items()}
    return found


def derived(original: WorkingMemory) -> set[Any]:
    """The halo as it should be."""
    memory = copy.deepcopy(original)
    net = memory.net
    rules: list[RuleInForce] = list(memory.rules._by_lesson.values())
    for node in [n for n in net if n.level in (BAND_1, BAND_2)]:
        net.drop(node)
    for node in net:
        for word, levels in list(node.halo_lex.items()):
            for level in [at for at in levels if at != WORKING]:
                net.lift(node, word, level)
    made: dict[Node, Any] = {}
    beliefs: dict[Node, float] = {}
    for band in (BAND_1, BAND_2):
        _derive(net, rules, band, made, beliefs)
    found: set[Any] = {(name, round(beliefs[node], 9), ()) for node, name in made.items()}
    for node in net:
        for word, levels in node.halo_lex.items():
            found |= {(rank(node, made), word, at, round(b, 9)) for at, b in levels.items()}
    return found


def _derive(
    net: Net, rules: list[RuleInForce], band: int, made: dict[Node, Any], beliefs: dict[Node, float]
) -> None:
    depth = band - 1
    best: dict[Any, tuple[float, RuleInForce, Plan, dict[str, Node]]] = {}
    for rule in rules:
        plan = Plan.of(rule.rule)
        for binding in matches(rule.rule.condition, net, depth, None, PREMISE_THRESHOLD):
            if any(
                holds(g, net, depth, {n: binding[n] for n in g.mentioned if n in binding},
                      PREMISE_THRESHOLD)
                for g in rule.rule.unless
            ):  # fmt: skip
                continue
            least = 1.0
            for term in rule.rule.condition.terms:
                least = min(least, binding[term.name].belief)
                for word in term.lex - binding[term.name].lex:
                    levels = binding[term.name].halo_lex[word]
                    near = min(at for at, b in levels.items() if b >= PREMISE_THRESHOLD)
                    least = min(least, levels[near])
            belief = rule.strength * least
            if plan.alias:
                keys: list[Any] = [(w, binding[rule.rule.conclusion.main]) for w in plan.alias]
            else:
                keys = [(plan.shape, *(binding[n] for n in plan.known))]
            for key in keys:
                if key not in best or best[key][0] < belief:
                    best[key] = belief, rule, plan, binding
    settled = [
        (key, *entry) for key, entry in best.items() if not _suppressed(net, depth, key, *entry)
    ]
    for key, belief, rule, plan, binding in settled:
        if plan.alias:
            net.overlay(key[1], key[0], band, belief)
            continue
        known = {name: binding[name] for name in plan.known}
        for name, node in instantiate(net, rule.rule.conclusion, known).items():
            if name not in known:
                node.level, node.belief, node.rule = band, belief, rule.lesson.ident
                of = tuple(rank(n, made) for n in key[1:])
                made[node] = (band, plan.shape, of, plan.canon[name])
                beliefs[node] = belief


def _suppressed(
    net: Net, depth: int, key: Any, belief: float, rule: RuleInForce, plan: Plan,
    binding: dict[str, Node],
) -> bool:  # fmt: skip
    if plan.alias:
        word, node = key
        otherwise = any(
            word in n.lex and n.negated != node.negated and not n.rule and n.level == WORKING
            and node.links and set(node.links) <= set(n.links)
            for n in net
        )  # fmt: skip
        return otherwise or node.known_as(word, depth, belief)
    known = {name: binding[name] for name in plan.known}
    conclusion = rule.rule.conclusion
    denials = matches(conclusion.denied(), net, WORKING, known, 0.0)
    if any(not denial[conclusion.main].rule for denial in denials):
        return True
    return holds(conclusion, net, depth, known, belief)
