"""The halo: two steps of conclusions, never more, and never against what was told."""

from collections.abc import Callable
from typing import Any

import pytest

from kernel.memory.lesson import Lesson
from kernel.net.node import BAND_1, BAND_2, WORKING

MakeLesson = Callable[..., Lesson]
GIRL = ("ako-1 -lex- girl; -ako-> obj-2", "obj-2 -lex- mary")


def kind(word: str) -> str:
    return f"ako-1 -lex- {word}; -ako-> obj-2; obj-2 -lex- mary"


def rule(word: str, then: str, belief: float = 1.0, extra: str = "") -> str:
    return (
        f"if: ako-1 -lex- {word}; -ako-> obj-2; {extra}"
        f"then: ako-3 -lex- {then}; -ako-> obj-2; belief: {belief}"
    )


def test_two_bands_and_nothing_deeper(robot: Any) -> None:
    for word, then in (("girl", "child"), ("child", "person"), ("person", "animal")):
        robot.teach(rule(word, then))
    robot.tell(*GIRL)
    levels = {word: [robot.believes(kind(word), depth) for depth in (WORKING, BAND_1, BAND_2)]
              for word in ("girl", "child", "person", "animal")}  # fmt: skip
    assert levels == {
        "girl": [True, True, True],
        "child": [False, True, True],
        "person": [False, False, True],
        "animal": [False, False, False],
    }


def test_the_order_of_teaching_does_not_let_one_band_feed_itself(robot: Any) -> None:
    for word, then in (("person", "animal"), ("child", "person"), ("girl", "child")):
        robot.teach(rule(word, then))
    robot.tell(*GIRL)
    assert robot.believes(kind("person"))
    assert not robot.believes(kind("animal"))


def test_what_was_told_beats_what_is_concluded_at_once_and_later(robot: Any) -> None:
    robot.teach(rule("girl", "person"))
    robot.tell(*GIRL)
    assert robot.believes(kind("person"))
    robot.tell("ako-1 -lex- person; -neg- yes; -ako-> obj-2", "obj-2 -lex- mary")
    assert not robot.believes(kind("person"))
    assert robot.believes(kind("person").replace("person", "person; -neg- yes"))
    robot.pass_time(60)
    robot.tell("hq-1 -lex- tall; -hq-> obj-2", "obj-2 -lex- mary")
    assert not robot.believes(kind("person"))


def test_a_conclusion_goes_when_its_reason_is_taken_back(robot: Any) -> None:
    robot.teach(rule("girl", "person"))
    robot.tell(*GIRL)
    robot.tell("ako-1 -lex- girl; -neg- yes; -ako-> obj-2", "obj-2 -lex- mary")
    assert not robot.believes(kind("girl"))
    assert not robot.believes(kind("person"))


def test_an_exception_holds_the_conclusion_back(robot: Any) -> None:
    extra = "unless: hq-4 -lex- wooden; -hq-> obj-2; "
    robot.teach(rule("girl", "person", extra=extra))
    robot.tell(*GIRL)
    assert robot.believes(kind("person"))
    robot.tell("hq-1 -lex- wooden; -hq-> obj-2", "obj-2 -lex- mary")
    assert not robot.believes(kind("person"))


def test_belief_is_the_rules_times_the_weakest_premises(robot: Any) -> None:
    robot.teach(rule("girl", "child", belief=0.8))
    robot.teach(rule("child", "person", belief=0.9))
    robot.tell("ako-1 -lex- girl; -bel- 0.9; -ako-> obj-2", "obj-2 -lex- mary")
    beliefs = {min(node.lex): node.belief for node in robot.mind.memory.halo.nodes}
    assert beliefs == {"child": pytest.approx(0.72), "person": pytest.approx(0.648)}


def test_a_conclusion_knows_its_rule_and_its_reasons(robot: Any) -> None:
    taught = robot.teach(rule("girl", "person"))
    robot.tell(*GIRL)
    (concluded,) = robot.mind.memory.halo.nodes
    assert concluded.rule == taught.ident
    assert {min(node.lex) for node in concluded.reasons} == {"girl"}


def test_what_is_known_already_is_not_concluded_again(robot: Any) -> None:
    robot.teach(rule("girl", "person"))
    robot.teach(rule("child", "person"))
    robot.tell(*GIRL)
    robot.tell("ako-1 -lex- child; -ako-> obj-2", "obj-2 -lex- mary")
    assert len(robot.mind.memory.halo.nodes) == 1
    robot.tell("ako-1 -lex- person; -ako-> obj-2", "obj-2 -lex- mary")
    robot.mind.memory.refresh()
    assert robot.mind.memory.halo.nodes == []


def test_an_alias_adds_a_word_for_as_long_as_it_is_in_mind(robot: Any) -> None:
    robot.teach("if: act-1 -lex- twirl; then: act-1 -lex- rotate; belief: 1.0")
    memory = robot.mind.memory
    robot.command("DO[ act-1 -lex- twirl; dir-2 -lex- left; -dir-> act-1 ]")
    robot.tick()
    (act,) = (node for node in memory.net.with_word("twirl") if node.kind == "act")
    assert act.words() == {"twirl", "rotate"}
    assert act.lex == {"twirl"}
    robot.pass_time(60)
    assert not memory.net.has_word("rotate")


def test_joins_need_every_condition_on_the_same_thing(robot: Any) -> None:
    robot.teach(
        "if: ako-1 -lex- girl; -ako-> obj-2; hq-3 -lex- tall; -hq-> obj-2;"
        "then: ako-4 -lex- star; -ako-> obj-2; belief: 1.0"
    )
    robot.tell(*GIRL)
    robot.tell("hq-1 -lex- tall; -hq-> obj-2", "obj-2 -lex- rick")
    assert not robot.believes("ako-1 -lex- star")
    robot.tell("hq-1 -lex- tall; -hq-> obj-2", "obj-2 -lex- mary")
    assert robot.believes(kind("star"))
    assert not robot.believes(kind("star").replace("mary", "rick"))


def test_an_exception_that_is_itself_concluded_holds_the_second_step_back(robot: Any) -> None:
    extra = "unless: hq-4 -lex- wooden; -hq-> obj-2; "
    robot.teach(rule("girl", "child"))
    robot.teach(rule("child", "person", extra=extra))
    robot.teach(
        "if: hq-1 -lex- stiff; -hq-> obj-2; then: hq-3 -lex- wooden; -hq-> obj-2; belief: 1.0"
    )
    robot.tell(*GIRL)
    assert robot.believes(kind("person"))
    robot.tell("hq-1 -lex- stiff; -hq-> obj-2", "obj-2 -lex- mary")
    assert not robot.believes(kind("person"))
    robot.tell("hq-1 -lex- stiff; -neg- yes; -hq-> obj-2", "obj-2 -lex- mary")
    assert robot.believes(kind("person"))


def test_of_several_rules_the_one_that_is_believed_most_counts(robot: Any) -> None:
    robot.teach(rule("girl", "person", belief=0.6))
    sure = robot.teach(rule("child", "person", belief=0.9))
    robot.tell(*GIRL)
    robot.tell("ako-1 -lex- child; -ako-> obj-2", "obj-2 -lex- mary")
    memory = robot.mind.memory
    memory.refresh()
    (node,) = memory.halo.nodes
    assert (node.belief, node.rule) == (0.9, sure.ident)
    memory.rules.believe(sure, 0.4)
    memory.refresh()
    assert node.belief == pytest.approx(0.6)


def test_an_alias_counts_no_further_than_it_is_believed(robot: Any) -> None:
    robot.teach("if: hq-1 -lex- crimson; then: hq-1 -lex- red; belief: 0.3")
    robot.tell("hq-1 -lex- crimson; -hq-> obj-2", "obj-2 -lex- mary")
    assert not robot.believes("hq-1 -lex- red; -hq-> obj-2; obj-2 -lex- mary")


def test_what_was_told_beats_an_alias_too(robot: Any) -> None:
    red = "hq-1 -lex- red; -hq-> obj-2; obj-2 -lex- mary"
    robot.teach("if: hq-1 -lex- crimson; then: hq-1 -lex- red; belief: 1.0")
    robot.tell("hq-1 -lex- crimson; -hq-> obj-2", "obj-2 -lex- mary")
    assert robot.believes(red)
    robot.tell("hq-1 -lex- red; -neg- yes; -hq-> obj-2", "obj-2 -lex- mary")
    assert not robot.believes(red)


def test_a_second_step_goes_with_the_alias_it_rests_on(robot: Any) -> None:
    alias = robot.teach("if: hq-1 -lex- crimson; then: hq-1 -lex- red; belief: 1.0")
    robot.teach(
        "if: hq-1 -lex- red; -hq-> obj-2; then: ako-3 -lex- danger; -ako-> obj-2; belief: 1.0"
    )
    robot.tell("hq-1 -lex- crimson; -hq-> obj-2", "obj-2 -lex- mary")
    assert robot.believes(kind("danger"))
    robot.mind.memory.rules.believe(alias, 0.3)
    assert not robot.believes(kind("danger"))
    robot.mind.memory.rules.remove(alias)
    robot.mind.memory.refresh()
    assert not robot.mind.memory.halo.nodes
