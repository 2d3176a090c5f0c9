"""A conclusion is used: it is promoted, and two steps that led to it become one rule."""

from __future__ import annotations

from collections.abc import Iterable

from kernel.commons import Commons
from kernel.memory.attention import Focus
from kernel.memory.change import Change
from kernel.memory.chunking import chunk
from kernel.memory.lesson import Lesson, Rule
from kernel.memory.promotion import Step, items_used, shared_names
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding


def use(commons: Commons, focus: Focus, patterns: Iterable[Graphlet], binding: Binding) -> None:
    """What the focus does rests on these patterns under this binding: conclusions among that are promoted."""
    memory = commons.memory
    items = items_used(patterns, binding)
    if not items:
        return
    steps = [step for step in map(memory.promotions.step, items) if step is not None]
    rules = [rule for step in steps for rule in _consolidated(commons, step)]
    for step in memory.promote(items, focus.nodes):
        lesson = step.instance.rule.lesson
        said = {"text": _text(step), "by": lesson.words or str(lesson.ident)}
        because = tuple(" ".join(sorted(n.lex)) for n in step.instance.premises if n.lex)
        commons.record("concluded", focus, rule=lesson.ident, because=because, **said)
        commons.record("promoted", focus, rule=lesson.ident, **said)
    for rule, origins in rules:
        _learn(commons, focus, rule, origins)


def _text(step: Step) -> str:
    node, word = step.item
    return word or " ".join(sorted(node.lex))


def _consolidated(commons: Commons, step: Step) -> list[tuple[Rule, tuple[int, ...]]]:
    """The one-step rule for a conclusion that took two, with the numbers of the rules it is made from."""
    if step.item in commons.memory.promotions:
        return []
    before = commons.memory.promotions.steps_before(step)
    if len(before) != 1:
        return []  # ours: a conclusion of several conclusions stays as it is
    (first,), second = before, step.instance
    rule = chunk(first.instance.rule.rule, second.rule.rule, shared_names(first, second))
    origins = (first.instance.rule.lesson.ident, second.rule.lesson.ident)
    return [(rule, origins)] if rule is not None else []


def _learn(commons: Commons, focus: Focus, rule: Rule, origins: tuple[int, ...]) -> None:
    """Keep a rule that the robot made itself, unless an equal one is in force or was forgotten."""
    waiting = any(
        lesson.content == rule for _, kept in commons.pending.values() for lesson in kept.learned
    )
    if not waiting and commons.memory.rules.is_new(rule):
        own = Lesson(0, "rule", rule, at_s=focus.at_s, origins=origins)
        commons.keep(focus, Change(at_s=own.at_s, learned=(own,), own=True))
