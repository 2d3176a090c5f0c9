"""Two steps as one rule."""

from __future__ import annotations

import random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kernel.memory.chunking import chunk
from kernel.memory.lesson import Lesson, Rule
from kernel.memory.notation import canonical, write
from kernel.memory.promotion import Step, shared_names
from kernel.memory.working import WorkingMemory
from kernel.net.node import BAND_1, BAND_2, Node
from tests.kernel.memory.test_halo_incremental import FACTS, SHAPES, WORDS, filled, parsed


def rule(text: str) -> Rule:
    content = parsed(text)
    assert isinstance(content, Rule)
    return content


def made(first: str, second: str, **same: str) -> Rule | None:
    names = {a.replace("_", "-"): b.replace("_", "-") for a, b in same.items()}
    return chunk(rule(first), rule(second), names)


GIRL = "if: ako-1 -lex- girl; -ako-> obj-2; then: ako-3 -lex- child; -ako-> obj-2; belief: 0.8"
CHILD = "if: ako-1 -lex- child; -ako-> obj-2; then: ako-3 -lex- person; -ako-> obj-2; belief: 0.5"


def test_the_first_condition_the_second_conclusion_and_the_product_of_beliefs() -> None:
    assert made(GIRL, CHILD, ako_1="ako_3", obj_2="obj_2") == canonical(
        rule(
            "if: ako-1 -lex- girl; -ako-> obj-2; then: ako-3 -lex- person; -ako-> obj-2; belief: 0.4"
        )
    )


def test_what_else_the_second_needs_and_the_exceptions_of_both_stay() -> None:
    first = GIRL.replace("then:", "unless: hq-9 -lex- wooden; -hq-> obj-2; then:")
    second = (
        "if: ako-1 -lex- child; -ako-> obj-2; hq-4 -lex- tall; -hq-> obj-2;"
        "unless: hq-5 -lex- red; -hq-> obj-2; then: ako-3 -lex- star; -ako-> obj-2; belief: 1.0"
    )
    assert made(first, second, ako_1="ako_3", obj_2="obj_2") == canonical(
        rule(
            "if: ako-1 -lex- girl; -ako-> obj-2; hq-4 -lex- tall; -hq-> obj-2;"
            "unless: hq-9 -lex- wooden; -hq-> obj-2; unless: hq-5 -lex- red; -hq-> obj-2;"
            "then: ako-3 -lex- star; -ako-> obj-2; belief: 0.8"
        )
    )


def test_aliases_compose() -> None:
    first = "if: dir-1 -lex- widdershins; then: dir-1 -lex- counterclockwise; belief: 1.0"
    second = "if: dir-1 -lex- counterclockwise; then: dir-1 -lex- left; belief: 1.0"
    assert made(first, second, dir_1="dir_1") == canonical(
        rule("if: dir-1 -lex- widdershins; then: dir-1 -lex- left; belief: 1.0")
    )


def test_an_alias_of_what_was_concluded_becomes_a_conclusion() -> None:
    second = "if: ako-1 -lex- child; then: ako-1 -lex- kid; belief: 1.0"
    assert made(GIRL, second, ako_1="ako_3") == canonical(
        rule("if: ako-1 -lex- girl; -ako-> obj-2; then: ako-3 -lex- kid; -ako-> obj-2; belief: 0.8")
    )


@pytest.mark.parametrize(
    "second",
    [
        "if: ako-1 -lex- child; -ako-> obj-2; unless: deg-4 -lex- very; -deg-> ako-1;"
        "then: ako-3 -lex- person; -ako-> obj-2; belief: 1.0",
        "if: ako-1 -lex- child; -ako-> obj-2; deg-4 -lex- very; -deg-> ako-1;"
        "then: ako-3 -lex- person; -ako-> obj-2; belief: 1.0",
        "if: ako-1 -lex- child; -ako-> obj-2; then: deg-3 -lex- very; -deg-> ako-1; belief: 1.0",
    ],
    ids=["exception", "condition", "conclusion"],
)
def test_what_speaks_of_the_step_itself_is_no_rule(second: str) -> None:
    assert made(GIRL, second, ako_1="ako_3", obj_2="obj_2") is None


def test_a_circle_is_no_rule() -> None:
    first = "if: hq-1 -lex- red; then: hq-1 -lex- crimson; belief: 1.0"
    second = "if: hq-1 -lex- crimson; then: hq-1 -lex- red; belief: 1.0"
    assert made(first, second, hq_1="hq_1") is None


def remembered(chance: random.Random, rules: list[Rule]) -> WorkingMemory:
    """A memory with these rules and facts by chance: equal chances make equal facts."""
    memory = WorkingMemory(list)
    things = [memory.net.new("obj") for _ in range(3)]
    for thing in things:
        memory.net.link(memory.me, "near", thing)
    for _ in range(10):
        fact = parsed(filled(chance.choice(FACTS), tuple(chance.choice(WORDS) for _ in range(3))))
        one, two = chance.sample(things, 2)
        memory.tell(
            fact, {n: t for n, t in (("obj-2", one), ("obj-3", two)) if n in fact.mentioned}
        )
    for number, each in enumerate(rules, 1):
        memory.rules.add(Lesson(number, "rule", each))
    memory.refresh()
    return memory


def text_of(node: Node, word: str) -> Any:
    """What is concluded, whichever rules did."""
    if word:
        return (node.number, word)
    links = sorted((role, 0 if other.rule else other.number) for role, other in node.links)
    return (sorted(node.lex), node.negated, links)


@settings(max_examples=150, deadline=None)
@given(st.integers(0, 2**32))
def test_where_both_conclude_in_two_steps_the_chunk_does_in_one(seed: int) -> None:
    chance = random.Random(seed)
    rules = [
        rule(filled(chance.choice(SHAPES), tuple(chance.choice(WORDS) for _ in range(3))) + "belief: 1.0")
        for _ in range(2)
    ]  # fmt: skip
    memory = remembered(random.Random(seed), rules)
    items = [(n, "") for n in memory.halo.nodes]
    items += [(n, w) for n in memory.net for w in sorted(n.halo_lex)]
    for item in items:
        step = memory.promotions.step(item)
        assert isinstance(step, Step)
        before = memory.promotions.steps_before(step)
        if step.instance.band != BAND_2 or len(before) != 1:
            continue
        (first,) = before
        both = first.instance.rule.rule, step.instance.rule.rule
        consolidated = chunk(*both, shared_names(first, step.instance))
        if consolidated is None:
            continue
        assert consolidated == canonical(consolidated)
        other = remembered(random.Random(seed), [consolidated])
        # What is known already is not concluded again.
        found = {repr(text_of(n, "")) for n in other.net if n.level <= BAND_1}
        found |= {
            repr(text_of(n, w)) for n in other.net for w, at in n.halo_lex.items() if BAND_1 in at
        }
        if item[1] and item[0].rule:  # a further word of a conclusion: a conclusion of that word
            wanted = ([item[1]], item[0].negated, text_of(item[0], "")[2])
            assert repr(wanted) in found, write(consolidated)
        else:
            assert repr(text_of(*item)) in found, write(consolidated)
