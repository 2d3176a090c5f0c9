"""Who taught you, who told you, when, how do you know."""

import pytest

from kernel.memory.explanation import Taught
from kernel.memory.meaning import Ask
from tests.kernel.answering.conftest import DANCE, LEFT, NEVER_GRAB, Questioned

MARY_IS_A = "ako-1 -lex- {}; -ako-> obj-2; obj-2 -lex- mary"
HEAVY = "hq-1 -lex- heavy; -hq-> obj-2"
THE_BLOCK = "obj-2 -ref- the; ako-3 -lex- block; -ako-> obj-2"


def who(robot: Questioned, about: str, ask: Ask = "who") -> Taught:
    reply = robot.asked(ask, about, "taught")
    assert isinstance(reply, Taught)
    return reply


@pytest.mark.parametrize("ask", ["who", "when"])
def test_a_procedure(robot: Questioned, ask: Ask) -> None:
    robot.taught("freddy", "to dance drive forward then turn left", DANCE)
    robot.taught("mary", "never grab a person", NEVER_GRAB, "prohibition")
    (lesson,) = who(robot, "act-1 -lex- dance", ask).lessons
    assert lesson.teacher == "freddy"
    assert lesson.at_s == pytest.approx(robot.wall_s - 120)


def test_a_prohibition(robot: Questioned) -> None:
    robot.taught("freddy", "never grab a person", NEVER_GRAB, "prohibition")
    assert [x.teacher for x in who(robot, "act-1 -lex- grab; -neg- yes").lessons] == ["freddy"]


def test_what_it_was_born_with_and_who_ordered_it(robot: Questioned) -> None:
    assert who(robot, "act-1 -lex- turn").born
    robot.ordered("mary", "turn left", LEFT)
    told = who(robot, "act-1 -lex- turn").told
    assert told is not None
    assert (told.teacher, told.words) == ("mary", "turn left")


def test_nobody(robot: Questioned) -> None:
    reply = who(robot, "act-1 -lex- salute")
    assert (reply.lessons, reply.told, reply.born) == ((), None, False)


def test_a_fact_of_the_session(robot: Questioned) -> None:
    robot.told("janey", "the block is heavy", HEAVY, THE_BLOCK)
    told = who(robot, f"{HEAVY}; {THE_BLOCK}").told
    assert told is not None
    assert (told.teacher, told.words) == ("janey", "the block is heavy")


def test_a_fact_told_again_was_told_by_the_last_one(robot: Questioned) -> None:
    robot.told("janey", "the block is heavy", HEAVY, THE_BLOCK)
    robot.told("rick", "the block is heavy", HEAVY, THE_BLOCK)
    told = who(robot, f"{HEAVY}; {THE_BLOCK}").told
    assert told is not None
    assert told.teacher == "rick"


def test_a_lasting_fact_also_after_a_restart(robot: Questioned) -> None:
    robot.told_kind("rick", "mary", "girl")
    later = Questioned(robot.mind.policy)
    for mind in (robot, later):
        (lesson,) = who(mind, MARY_IS_A.format("girl")).lessons
        assert (lesson.teacher, lesson.words) == ("rick", "mary is a girl")


def test_an_inference_names_its_rules_and_what_it_started_from(robot: Questioned) -> None:
    robot.rule("janey", "girl", "child")
    robot.rule("freddy", "child", "person")
    robot.told_kind("rick", "mary", "girl")
    reply = who(robot, MARY_IS_A.format("person"))
    assert [step.lesson.teacher for step in reply.steps] == ["janey", "freddy"]
    assert reply.steps[0].told
    assert reply.told is None


def test_a_rule(robot: Questioned) -> None:
    robot.rule("janey", "girl", "person")
    about = "ako-1 -lex- person; -ako-> obj-2; ako-3 -lex- girl; -ako-> obj-2"
    assert [lesson.teacher for lesson in who(robot, about).lessons] == ["janey"]


def test_what_the_senses_say(robot: Questioned) -> None:
    robot.feel(range_m=0.1)
    robot.tick()
    assert who(robot, "hq-1 -lex- close; -hq-> obj-2").noticed


def test_that_is_the_newest_thing_learned_or_told(robot: Questioned) -> None:
    that = "act-1 -ref- that"
    nothing = who(robot, that)
    assert (nothing.lessons, nothing.told) == ((), None)
    robot.taught("freddy", "never grab a person", NEVER_GRAB, "prohibition")
    assert [lesson.teacher for lesson in who(robot, that).lessons] == ["freddy"]
    robot.told("janey", "the block is heavy", HEAVY, THE_BLOCK)
    told = who(robot, that).told
    assert told is not None
    assert told.teacher == "janey"


def test_who_told_something_about_a_thing(robot: Questioned) -> None:
    about = "obj-2 -ref- the; ako-3 -lex- block; -ako-> obj-2"
    robot.told("janey", "the block is heavy", HEAVY, THE_BLOCK)
    told = who(robot, about).told
    assert told is not None
    assert told.teacher == "janey"
    robot.told_kind("rick", "mary", "girl")
    told = who(robot, "obj-2 -lex- mary").told
    assert told is not None
    assert told.words == "mary is a girl"
