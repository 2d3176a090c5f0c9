"""Adverbs of an act are inherited by the steps it expands to (mind.md): "dance slowly" makes every step slow."""

from __future__ import annotations

from collections.abc import Iterable

from kernel.net.node import Net, Node


def left_over(act: Node | None, taken: Iterable[Node]) -> tuple[Node, ...]:
    """The manners of an act that the trigger of the operator chosen did not ask for.

    "To dance slowly sway" says itself what slowly means, so it takes the word up.
    """
    used = set(taken)
    return tuple(mod for mod in act.modifiers("mod") if mod not in used) if act else ()


def inherit(net: Net, act: Node, manners: Iterable[Node]) -> list[Node]:
    """Give an act these manners with their degrees, unless it has one of its own; the nodes made."""
    if any(True for _ in act.modifiers("mod")):
        return []
    made = []
    for manner in manners:
        mod = net.new("mod", *sorted(manner.lex), mod=act)
        mod.negated, mod.belief = manner.negated, manner.belief
        made.append(mod)
        made += [net.new("deg", *sorted(d.lex), deg=mod) for d in manner.modifiers("deg")]
    return made
