"""What do you know about X; what did you learn today."""

import pytest

from kernel.memory.explanation import Knowledge, Lessons
from kernel.memory.settings import Settings
from tests.kernel.answering.conftest import DANCE, NEVER_GRAB, Questioned

BLOCK = "obj-2 -ref- the; ako-3 -lex- block; -ako-> obj-2"
RED_BLOCK = f"{BLOCK}; hq-4 -lex- red; -hq-> obj-2"
HEAVY = "hq-1 -lex- heavy; -hq-> obj-2"


def known(robot: Questioned, about: str) -> Knowledge:
    reply = robot.asked("what", about, "know_about")
    assert isinstance(reply, Knowledge)
    return reply


def learned(robot: Questioned) -> list[str]:
    reply = robot.asked("what", "act-1 -lex- learn", "learned")
    assert isinstance(reply, Lessons)
    return [lesson.words for lesson in reply.lessons]


def test_what_was_told_of_a_thing_and_nothing_that_the_question_says_itself(
    robot: Questioned,
) -> None:
    robot.told("janey", "the red block is heavy", HEAVY, RED_BLOCK)
    found = known(robot, RED_BLOCK)
    assert [fact.term(fact.main).lex for fact in found.facts] == [{"heavy"}]
    assert found.inferred == ()


def test_another_thing_of_the_kind_is_another(robot: Questioned) -> None:
    robot.told("janey", "the red block is heavy", HEAVY, RED_BLOCK)
    assert known(robot, RED_BLOCK.replace("red", "blue")).facts == ()
    assert known(robot, "obj-1 -lex- mary").facts == ()


def test_of_two_that_fit_the_last_one_is_meant_and_of_the_kind_neither(robot: Questioned) -> None:
    robot.told("janey", "the red block is heavy", HEAVY, RED_BLOCK)
    blue = RED_BLOCK.replace("red", "blue")
    robot.told("janey", "the blue block is light", HEAVY.replace("heavy", "light"), blue)
    the_block = known(robot, BLOCK).facts
    assert {"blue", "light"} == {word for fact in the_block for word in fact.term(fact.main).lex}
    assert known(robot, BLOCK.replace("obj-2 -ref- the", "obj-2")).facts == ()


def test_what_follows_is_kept_apart(robot: Questioned) -> None:
    robot.rule("janey", "girl", "person")
    robot.told_kind("rick", "mary", "girl")
    found = known(robot, "obj-1 -lex- mary")
    assert [fact.term(fact.main).lex for fact in found.facts] == [{"girl"}]
    assert [fact.term(fact.main).lex for fact in found.inferred] == [{"person"}]


def test_lessons_that_speak_of_it(robot: Questioned) -> None:
    robot.taught("freddy", "never grab a person", NEVER_GRAB, "prohibition")
    robot.taught("freddy", "to dance ...", DANCE)
    persons = "obj-2 -ref- any; ako-1 -lex- person; -ako-> obj-2"
    assert [lesson.words for lesson in known(robot, persons).lessons] == ["never grab a person"]
    assert known(robot, persons.replace("person", "dog")).lessons == ()


def test_lessons_of_today_newest_first(robot: Questioned) -> None:
    assert learned(robot) == []
    robot.taught("freddy", "yesterday's", DANCE)
    robot.wall_s += 86_400
    assert learned(robot) == []
    robot.taught("freddy", "never grab a person", NEVER_GRAB, "prohibition")
    robot.told_kind("rick", "mary", "girl")
    assert learned(robot) == ["mary is a girl", "never grab a person"]


@pytest.mark.parametrize(
    ("from_midnight_s", "offset_h", "same_day"),
    [(-120, 0, False), (-120, 5, True), (60, 0, True), (60, -5, True), (5 * 3600 - 900, -5, False)],
)
def test_the_day_is_that_of_the_clock_on_the_wall(
    from_midnight_s: float, offset_h: float, same_day: bool
) -> None:
    robot = Questioned(settings=Settings(utc_offset_s=offset_h * 3600))
    robot.wall_s = 86_400 * 20_000 + from_midnight_s - 60
    robot.taught("freddy", "to dance ...", DANCE)
    robot.wall_s += 3600
    assert bool(learned(robot)) is same_day
