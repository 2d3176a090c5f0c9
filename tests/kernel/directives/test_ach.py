"""ACH: already so, or operators in turn until it is, even in the middle of one."""

from collections.abc import Callable
from typing import Any

import pytest

from kernel.action.call import MoveGrip, MoveLift, Rotate, Travel
from kernel.memory.lesson import Lesson
from kernel.net.node import REMEMBERED

MakeLesson = Callable[..., Lesson]

GRIPPER = "FIND[ obj-2; ako-3 -lex- gripper; -ako-> obj-2 ]"
CLOSED = f"{GRIPPER}; ACH[ hq-1 -lex- closed; -hq-> obj-2 ]"
NEAR = "ACH[ hq-1 -lex- close; -hq-> obj-2 ]"
FORWARD = "DO[ act-11 -lex- drive; dir-12 -lex- forward; -dir-> act-11 ]"
TURN = "DO[ act-13 -lex- turn; dir-14 -lex- left; -dir-> act-13 ]"
RAISE = "DO[ act-15 -lex- raise ]"
TO_CLOSE = """
    trig: ACH[ hq-1 -lex- closed; -hq-> obj-2; ako-3 -lex- gripper; -ako-> obj-2 ]
    pref: 1.0
    ---
    DO[ act-4 -lex- close; -obj-> obj-2 ]
"""


def to_get_near(*steps: str, pref: float = 1.0) -> str:
    return f"trig: ACH[ hq-1 -lex- close; -hq-> obj-2 ]; pref: {pref}; ---; " + "; ".join(steps)


def test_already_so_nothing_is_done(robot: Any) -> None:
    robot.teach(to_get_near(FORWARD))
    robot.feel(range_m=0.1)
    assert robot.do(f"{NEAR}; {RAISE}") == [MoveLift(0.5)]


def test_an_operator_brings_it_about_and_the_chain_goes_on(robot: Any) -> None:
    robot.teach(TO_CLOSE)
    moved = robot.do(f"{CLOSED}; {RAISE}")
    assert moved == [MoveGrip(0.0, must_hold=False), MoveLift(0.5)]
    assert robot.do(CLOSED) == []
    assert robot.reasons == []


def test_what_is_wanted_is_not_taken_for_so(robot: Any) -> None:
    robot.teach("if: hq-1 -lex- close; -hq-> obj-2; then: hq-3 -lex- red; -hq-> obj-2; belief: 1.0")
    robot.teach(to_get_near("DO[ act-6 -lex- wait ]"))
    robot.command(NEAR)
    robot.pass_time(0.5)
    assert robot.out.busy
    assert not robot.believes("hq-1 -lex- close; -hq-> obj-2", REMEMBERED)
    assert not robot.believes("hq-1 -lex- red; -hq-> obj-2", REMEMBERED)
    robot.settle()
    assert not robot.believes("hq-1 -lex- close; -hq-> obj-2", 9)


def test_it_ends_in_the_middle_of_an_operator(robot: Any) -> None:
    robot.teach(to_get_near(FORWARD, FORWARD.replace("11", "21"), TURN))
    robot.command(f"{NEAR}; {RAISE}")
    robot.pass_time(0.5)
    robot.feel(range_m=0.1)
    robot.tick()
    assert [bid.command for bid in robot.out.bids] == [MoveLift(0.5)]
    robot.settle()
    assert robot.reasons == []


@pytest.mark.parametrize("first", ["DO[ act-21 -lex- grab ]", "DO[ act-21 -lex- raise ]"])
def test_one_that_fails_or_succeeds_in_vain_is_followed_by_the_next(
    make_robot: Any, lesson: MakeLesson, first: str
) -> None:
    """Whichever is tried first: over all seeds both orders occur."""
    orders = set()
    for seed in range(8):
        robot = make_robot([lesson(to_get_near(first)), lesson(to_get_near(TURN))], seed)
        robot.body.within_reach = False
        robot.do(f"{NEAR}; {FORWARD}")
        orders.add(tuple(type(command).__name__ for command in robot.moved))
        assert len(robot.moved) == 2
        assert len(robot.reasons) == 1
    assert len(orders) == 2


def test_nobody_taught_how(robot: Any) -> None:
    assert robot.do(f"{NEAR}; {FORWARD}") == []
    assert robot.reasons == ["not_achieved"]


def test_a_punt_ends_the_trying(make_robot: Any, lesson: MakeLesson) -> None:
    lessons = [lesson(to_get_near("PUNT[ ]", pref=1.2)), lesson(to_get_near(TURN, pref=0.1))]
    for seed in range(20):
        robot = make_robot(lessons, seed)
        if robot.do(NEAR) == []:
            assert robot.reasons == ["not_achieved"]
            return
    raise AssertionError("the operator that punts was never tried first")


def test_its_acts_are_vetoed_like_others(robot: Any) -> None:
    robot.teach(TO_CLOSE)
    robot.teach("trig: ANTE[ act-1 -lex- close ]; pref: 1.0; ---; PUNT[ ]", kind="prohibition")
    assert robot.do(CLOSED) == []


def test_it_is_stopped_like_everything(robot: Any) -> None:
    robot.teach(to_get_near(FORWARD, TURN))
    robot.teach(to_get_near(TURN))
    robot.command(NEAR)
    robot.pass_time(0.3)
    robot.stop()
    robot.pass_time(5)
    assert len(robot.moved) == 1


def test_advice_on_how_does_not_apply_to_its_own_carrying_out(robot: Any) -> None:
    robot.teach(to_get_near("ACH[ hq-31 -lex- close; -hq-> obj-32 ]"))
    assert robot.do(NEAR) == []
    assert robot.reasons == ["not_achieved"]


def test_it_may_be_about_something_not_being_so(robot: Any) -> None:
    nothing = "ACH[ hq-1 -lex- close; -neg- yes; -hq-> obj-2 ]"
    assert robot.do(nothing) == []
    robot.teach(to_get_near(FORWARD).replace("close;", "close; -neg- yes;"))
    robot.feel(range_m=0.1)
    robot.command(nothing)
    robot.pass_time(0.2)
    assert [bid.command for bid in robot.out.bids] == [Travel(0.2, 1.0)]
    robot.feel(range_m=None)
    robot.settle()
    assert robot.reasons == []


def test_before_something_else_is_done(robot: Any) -> None:
    robot.teach(TO_CLOSE)
    robot.teach(f"trig: ANTE[ act-21 -lex- raise ]; pref: 1.0; ---; {CLOSED}")
    assert [type(c) for c in robot.do(RAISE)] == [MoveGrip, MoveLift]
    assert [type(c) for c in robot.do(TURN)] == [Rotate]
