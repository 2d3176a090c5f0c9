"""Conclusions that are used stay with what used them, and two used steps become a rule."""

from collections.abc import Callable
from typing import Any

import pytest

from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Question
from kernel.memory.notation import canonical
from kernel.memory.promotion import Promotions
from kernel.memory.reply import LessonTaken
from kernel.net.node import BAND_1, WORKING, Node
from tests.kernel.memory.test_halo_incremental import parsed

Make = Callable[..., Any]
GIRL = ("ako-1 -lex- girl; -ako-> obj-2", "obj-2 -lex- mary")
NO_GRABBING = """
trig: ANTE[ act-1 -lex- grab; -obj-> obj-2; ako-3 -lex- person; -ako-> obj-2 ]; pref: 1.0
---
PUNT[ ]
"""
GRAB = "FIND[ obj-1 -lex- mary ]; DO[ act-2 -lex- grab; -obj-> obj-1 ]"


def kind(word: str) -> str:
    return f"ako-1 -lex- {word}; -ako-> obj-2; obj-2 -lex- mary"


def rule(word: str, then: str, extra: str = "", belief: float = 1.0) -> str:
    return (
        f"if: ako-1 -lex- {word}; -ako-> obj-2; {extra}"
        f"then: ako-3 -lex- {then}; -ako-> obj-2; belief: {belief}"
    )


@pytest.fixture
def vetoed(robot: Any) -> Any:
    """A robot that has just not grabbed Mary, because a girl is a person."""
    robot.teach(NO_GRABBING)
    robot.rule = robot.teach(rule("girl", "person", "unless: hq-9 -lex- wooden; -hq-> obj-2; "))
    robot.tell(*GIRL)
    assert robot.do(GRAB) == []
    assert "prohibited" not in robot.reasons
    robot.mind.memory.refresh()
    return robot


def person(robot: Any) -> Node:
    (node,) = (n for n in robot.mind.memory.net.with_word("person") if n.rule)
    return node


def test_an_operator_selected_through_it_promotes_it_with_a_record(vetoed: Any) -> None:
    assert person(vetoed).level == WORKING
    assert vetoed.mind.memory.halo.nodes == []
    (promoted,) = vetoed.records("promoted")
    assert (promoted.data["text"], promoted.data["rule"]) == ("person", vetoed.rule.ident)
    (concluded,) = vetoed.records("concluded")
    assert concluded.data["because"] == ("girl",)


def test_it_goes_when_the_focus_that_used_it_has_faded(vetoed: Any) -> None:
    node = person(vetoed)
    vetoed.pass_time(40)
    assert node not in vetoed.mind.memory.net
    vetoed.tell("hq-1 -lex- tall; -hq-> obj-2", "obj-2 -lex- mary")
    assert vetoed.believes(kind("person"))  # the halo concludes it again
    assert person(vetoed).level == BAND_1


def test_it_stays_while_another_focus_uses_it(vetoed: Any) -> None:
    node = person(vetoed)
    vetoed.pass_time(20)
    vetoed.do(GRAB)
    vetoed.pass_time(20)
    assert node in vetoed.mind.memory.net
    vetoed.pass_time(20)
    assert node not in vetoed.mind.memory.net


@pytest.mark.parametrize(
    "fact",
    [
        "ako-1 -lex- girl; -neg- yes; -ako-> obj-2",
        "ako-1 -lex- person; -neg- yes; -ako-> obj-2",
        "hq-1 -lex- wooden; -hq-> obj-2",
    ],
    ids=["reason", "contrary", "exception"],
)
def test_it_goes_at_once_when_a_person_takes_its_ground_away(vetoed: Any, fact: str) -> None:
    vetoed.tell(fact, "obj-2 -lex- mary")
    assert not vetoed.believes(kind("person"))
    assert not [n for n in vetoed.mind.memory.net.with_word("person") if n.rule]
    assert len(vetoed.do(GRAB)) == 1


def test_it_goes_at_once_when_its_rule_is_retired(vetoed: Any) -> None:
    vetoed.mind.memory.rules.remove(vetoed.rule)
    assert not vetoed.believes(kind("person"))


def test_it_is_believed_as_its_rule_is(vetoed: Any) -> None:
    vetoed.mind.memory.rules.believe(vetoed.rule, 0.3)
    vetoed.mind.memory.refresh()
    assert person(vetoed).belief == pytest.approx(0.3)


def test_being_in_working_memory_it_carries_two_steps_more(vetoed: Any) -> None:
    vetoed.teach(rule("person", "animal"))
    vetoed.teach(rule("animal", "thing"))
    assert vetoed.believes(kind("thing"))


def test_reasons_go_with_what_rests_on_them(robot: Any) -> None:
    robot.teach(NO_GRABBING)
    robot.teach(rule("girl", "child"))
    robot.teach(rule("child", "person"))
    robot.tell(*GIRL)
    robot.do(GRAB)
    memory = robot.mind.memory
    levels = {w: [n.level for n in memory.net.with_word(w) if n.rule] for w in ("child", "person")}
    assert levels == {"child": [WORKING], "person": [WORKING]}
    robot.tell("ako-1 -lex- girl; -neg- yes; -ako-> obj-2", "obj-2 -lex- mary")
    assert not robot.believes(kind("child"))
    assert not robot.believes(kind("person"))


def test_two_used_steps_are_kept_as_a_rule_of_its_own_without_a_word(robot: Any) -> None:
    robot.teach(NO_GRABBING)
    first, second = (
        robot.teach(rule("girl", "child", belief=0.8)),
        robot.teach(rule("child", "person", belief=0.9)),
    )
    robot.tell(*GIRL)
    before = len(robot.replies)
    robot.do(GRAB)
    robot.do(GRAB)
    (made,) = (lesson for lesson in robot.mind.policy if lesson.origins)
    assert made.content == canonical(parsed(rule("girl", "person", belief=0.72)))
    assert (made.origins, made.words, made.teacher) == ((first.ident, second.ident), "", "")
    assert not any(isinstance(reply, LessonTaken) for reply in robot.replies[before:])
    assert [r.data["ident"] for r in robot.records("lesson")][-1] == made.ident
    assert [x for x in robot.mind.policy if first.ident in x.origins] == [made]


def test_what_was_forgotten_is_not_made_again(robot: Any) -> None:
    robot.teach(NO_GRABBING)
    robot.teach(rule("girl", "child"))
    robot.teach(rule("child", "person"))
    robot.tell(*GIRL)
    robot.do(GRAB)
    (made,) = (lesson for lesson in robot.mind.policy if lesson.origins)
    robot.mind.memory.rules.remove(made)
    robot.pass_time(40)
    robot.do(GRAB)
    assert [lesson for lesson in robot.mind.policy if lesson.origins] == [made]


def test_no_chunk_where_the_rule_is_known_already(robot: Any) -> None:
    robot.teach(NO_GRABBING)
    robot.teach(rule("girl", "child"))
    robot.teach(rule("child", "person"))
    robot.teach(rule("girl", "person", belief=0.3))
    robot.tell(*GIRL)
    robot.do(GRAB)
    assert not [lesson for lesson in robot.mind.policy if lesson.origins]


def test_an_alias_that_an_operator_was_found_by_is_promoted_for_as_long(robot: Any) -> None:
    taught = robot.teach("if: act-1 -lex- twirl; then: act-1 -lex- turn; belief: 1.0")
    robot.do("DO[ act-1 -lex- twirl; dir-2 -lex- left; -dir-> act-1 ]")
    memory = robot.mind.memory
    (act,) = (n for n in memory.net.with_word("twirl") if n.kind == "act")
    memory.refresh()
    assert act.known_as("turn", WORKING)
    assert reasons(memory.promotions, act, "turn") == [(taught.ident, (act,))]
    robot.pass_time(40)
    memory.refresh()
    assert not memory.net.has_word("twirl")
    assert len(memory.promotions) == 0


def test_an_answer_promotes_what_it_rests_on(robot: Any) -> None:
    robot.teach(rule("girl", "person"))
    robot.tell(*GIRL)
    robot.hear(Question("yesno", parsed(kind("person"))), "is mary a person")
    robot.settle()
    assert person(robot).level == WORKING
    assert robot.records("promoted")


def test_a_check_and_a_look_up_promote_too(robot: Any) -> None:
    robot.teach(rule("girl", "person"))
    robot.tell(*GIRL)
    robot.do("FIND[ obj-1 -lex- mary ]; CHK[ ako-2 -lex- person; -ako-> obj-1 ]")
    assert len(robot.records("promoted")) == 1
    robot.pass_time(40)
    robot.tell("hq-1 -lex- tall; -hq-> obj-2", "obj-2 -lex- mary")
    robot.do(
        "FIND[ obj-1; ako-2 -lex- person; -ako-> obj-1 ]; DO[ act-2 -lex- grab; -obj-> obj-1 ]"
    )
    assert len(robot.records("promoted")) == 2


def test_the_reasons_of_two_steps_are_told_last_first(robot: Any) -> None:
    first, second = robot.teach(rule("girl", "child")), robot.teach(rule("child", "person"))
    robot.tell(*GIRL)
    robot.mind.memory.refresh()
    found = reasons(robot.mind.memory.promotions, person_in_halo(robot))
    assert [rule for rule, _ in found] == [second.ident, first.ident]
    assert [sorted(n.lex) for _, premises in found for n in premises] == [["child"], ["girl"]]


def reasons(
    promotions: Promotions, node: Node, word: str = ""
) -> list[tuple[int, tuple[Node, ...]]]:
    """The rules behind a conclusion and what each rests on; the last step first, two steps deep."""
    last = [step for step in (promotions.step((node, word)),) if step is not None]
    before = [b for step in last for b in promotions.steps_before(step)]
    return [(step.instance.rule.lesson.ident, step.instance.premises) for step in (*last, *before)]


def person_in_halo(robot: Any) -> Node:
    (node,) = (n for n in robot.mind.memory.halo.nodes if "person" in n.lex)
    return node


def test_what_was_told_has_no_reasons(robot: Any) -> None:
    robot.tell(*GIRL)
    (node,) = robot.mind.memory.net.with_word("girl")
    assert reasons(robot.mind.memory.promotions, node) == []


def test_lesson_origins_default_to_none() -> None:
    assert Lesson(1, "rule", parsed(rule("a", "b"))).origins == ()


@pytest.mark.parametrize(
    "word", ["dangerous", "purple"]
)  # one has a contrary that nobody mentioned
def test_what_was_promoted_is_not_concluded_beside_itself(robot: Any, word: str) -> None:
    robot.teach(
        f"if: hq-1 -lex- heavy; -hq-> obj-2; then: hq-3 -lex- {word}; -hq-> obj-2; belief: 1.0"
    )
    robot.tell("hq-1 -lex- heavy; -hq-> obj-2", "obj-2; ako-3 -lex- crate; -ako-> obj-2")
    about = parsed(f"hq-1 -lex- {word}; -hq-> obj-2; ako-3 -lex- crate; -ako-> obj-2")
    for _ in range(2):
        robot.hear(Question("yesno", about))
        robot.settle()
    memory = robot.mind.memory
    memory.refresh()
    assert [node.level for node in memory.net.with_word(word)] == [WORKING]
