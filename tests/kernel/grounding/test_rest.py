"""Doing nothing for a while."""

from typing import Any

import pytest

REST = "DO[ act-1 -lex- {}; amt-2 -lex- {}; -str- {}; -amt-> act-1 ]"


@pytest.mark.parametrize(
    ("command", "seconds"),
    [
        ("DO[ act-1 -lex- wait ]", 1.0),
        ("DO[ act-1 -lex- pause ]", 1.0),
        (REST.format("wait", "second", "2.5"), 2.5),
        (REST.format("wait", "minute", "0.1"), 6.0),
        (REST.format("wait", "second", "0"), 0.0),
    ],
)
def test_it_lasts_as_long_as_was_said(robot: Any, command: str, seconds: float) -> None:
    robot.do(command)
    assert robot.now_s == pytest.approx(seconds, abs=0.11)
    assert robot.reasons == []


def test_ten_minutes_and_no_longer(robot: Any) -> None:
    robot.do(REST.format("wait", "minute", "11"))
    (failed,) = robot.replies
    assert (failed.reason, failed.detail) == ("too_much", "10 minutes")


def test_a_unit_that_is_no_time(robot: Any) -> None:
    robot.do(REST.format("wait", "meter", "1"))
    assert robot.reasons == ["not_grounded"]


def test_it_uses_no_resource(robot: Any) -> None:
    robot.command("DO[ act-1 -lex- wait ]")
    assert robot.tick().bids == ()
