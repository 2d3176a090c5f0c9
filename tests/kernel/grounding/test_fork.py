"""Lift and gripper."""

from typing import Any

import pytest

from kernel.action.call import MoveGrip, MoveLift


@pytest.mark.parametrize(
    ("verb", "more", "at", "target"),
    [
        ("raise", "", 0.0, 0.5),
        ("raise", "", 0.8, 1.0),
        ("lower", "", 1.0, 0.5),
        ("lower", "", 0.2, 0.0),
        ("lift", "", 0.0, 0.5),
        ("raise", "; deg-2 -lex- fully; -deg-> act-1", 0.2, 1.0),
        ("lower", "; deg-2 -lex- fully; -deg-> act-1", 0.9, 0.0),
        ("raise", "; deg-2 -lex- little; -deg-> act-1", 0.0, 0.25),
        ("raise", "; amt-2 -lex- centimeter; -str- 3; -amt-> act-1", 0.0, 0.3),
    ],
)
def test_the_lift_goes_where_the_words_say_and_no_farther(
    robot: Any, verb: str, more: str, at: float, target: float
) -> None:
    robot.feel(lift=at)
    (moved,) = robot.do(f"DO[ act-1 -lex- {verb}{more} ]")
    assert isinstance(moved, MoveLift)
    assert moved.target == pytest.approx(target)
    assert robot.body.state.lift == pytest.approx(target)


def test_slowly_is_half_as_fast(robot: Any) -> None:
    (moved,) = robot.do("DO[ act-1 -lex- raise; mod-2 -lex- slowly; -mod-> act-1 ]")
    assert moved == MoveLift(0.5, per_second=0.25)


def test_an_amount_that_is_no_length_is_refused(robot: Any) -> None:
    assert robot.do("DO[ act-1 -lex- raise; amt-2 -lex- degree; -str- 3; -amt-> act-1 ]") == []
    assert robot.reasons == ["not_grounded"]


@pytest.mark.parametrize("verb", ["grab", "grip", "close"])
def test_closing_has_to_catch_something(robot: Any, verb: str) -> None:
    assert robot.do(f"DO[ act-1 -lex- {verb} ]") == [MoveGrip(0.0)]
    assert robot.body.state.holding
    assert robot.reasons == []


def test_catching_nothing_is_a_failure_and_told(robot: Any) -> None:
    robot.body.within_reach = False
    robot.do("DO[ act-1 -lex- grab ]")
    assert robot.reasons == ["nothing_gripped"]


def test_closing_the_gripper_itself_catches_nothing_and_need_not(robot: Any) -> None:
    robot.body.within_reach = False
    robot.do(
        "FIND[ obj-2 -ref- the; ako-3 -lex- gripper; -ako-> obj-2 ]; DO[ act-1 -lex- close; -obj-> obj-2 ]"
    )
    assert robot.moved == [MoveGrip(0.0, must_hold=False)]
    assert robot.reasons == []


@pytest.mark.parametrize("verb", ["release", "open", "let go"])
def test_opening(robot: Any, verb: str) -> None:
    robot.do("DO[ act-1 -lex- grab ]")
    assert robot.do(f"DO[ act-1 -lex- {verb} ]") == [MoveGrip(1.0, must_hold=False)]
    assert not robot.body.state.holding
