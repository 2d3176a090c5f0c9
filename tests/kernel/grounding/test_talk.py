"""The voice."""

from typing import Any

import pytest

SAY = "DO[ act-1 -lex- {}; -obj-> txt-2; txt-2 -str- {} ]"


@pytest.mark.parametrize("verb", ["say", "tell", "ask"])
def test_the_quoted_text_is_said_as_it_stands(robot: Any, verb: str) -> None:
    robot.do(SAY.format(verb, "I'm NOT allowed to"))
    assert robot.said == ["I'm NOT allowed to"]


def test_it_takes_as_long_as_it_is_heard(robot: Any) -> None:
    robot.command(SAY.format("say", "one") + "; DO[ act-3 -lex- drive ]")
    robot.pass_time(0.4)
    assert robot.moved == []
    robot.settle()
    assert len(robot.moved) == 1


def test_two_hundred_characters_are_enough(robot: Any) -> None:
    robot.do(SAY.format("say", "a" * 200))
    robot.do(SAY.format("say", "a" * 201))
    assert robot.said == ["a" * 200]
    (failed,) = robot.replies
    assert (failed.reason, failed.detail) == ("too_much", "200 characters")


def test_nothing_to_say(robot: Any) -> None:
    robot.do("DO[ act-1 -lex- say ]")
    assert robot.reasons == ["not_grounded"]
