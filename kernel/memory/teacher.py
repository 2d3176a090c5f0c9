"""Who "my" is in a lesson: the teacher, whoever speaks when it applies (ours)."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeVar

from kernel.memory.lesson import Content, Operator, Rule
from kernel.memory.notation import mapped
from kernel.net.graphlet import Graphlet

C = TypeVar("C", bound=Content)


def in_own_name(content: C, teacher: str) -> C:
    """The lesson with its teacher's name for "me" in whatever it is matched with: "never touch my sneakers".

    What is done is done for whoever gives the order, so "me" stays in procedures and in what is to be done. So it does
    where nobody knows who teaches.
    """
    if not teacher or isinstance(content, Graphlet):
        return content
    if isinstance(content, Rule):
        named: C = mapped(content, lambda g: _named(g, teacher))
        return named
    if isinstance(content, Operator) and content.trigger.tag in ("NOTE", "ANTE", "POST", "ALLOW"):
        trigger = content.trigger.graphlet
        return replace(
            content,
            trigger=replace(content.trigger, graphlet=trigger and _named(trigger, teacher)),
            enablement=tuple(_named(g, teacher) for g in content.enablement),
            unless=tuple(_named(g, teacher) for g in content.unless),
        )
    return content


def _named(graphlet: Graphlet, teacher: str) -> Graphlet:
    return Graphlet(
        tuple(
            replace(term, lex=term.lex - {"me"} | {teacher}) if "me" in term.lex else term
            for term in graphlet
        ),
        graphlet.main,
    )
