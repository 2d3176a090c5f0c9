"""Never mind, go on, and who may have the wheels."""

from typing import Any

import pytest

from kernel.action.call import MoveGrip, MoveLift, Rotate, Travel
from kernel.memory.meaning import Control
from kernel.memory.reply import Dropped, Halted, Resumed

FORWARD = "DO[ act-1 -lex- drive; dir-2 -lex- forward; -dir-> act-1 ]"
METER = "DO[ act-11 -lex- drive; amt-12 -lex- meter; -str- 1; -amt-> act-11 ]"
TURN = "DO[ act-3 -lex- turn; dir-4 -lex- left; -dir-> act-3 ]"
RAISE = "DO[ act-5 -lex- raise ]"
BLOCK = "FIND[ obj-7; ako-8 -lex- block; -ako-> obj-7 ]"
GRAB = "DO[ act-9 -lex- grab; -obj-> obj-7 ]"


def kinds(robot: Any, since: int = 0) -> list[type]:
    return [type(command) for command in robot.moved[since:]]


def say(robot: Any, act: Any) -> None:
    robot.hear(Control(act), act)
    robot.tick()


# -- never mind ----------------------------------------------------------------------------


def test_never_mind_drops_the_newest_request_and_says_which(robot: Any) -> None:
    robot.command(METER, words="drive a meter")
    robot.command(RAISE + "; " + TURN, words="raise the lift then turn left")
    robot.pass_time(0.3)
    say(robot, "cancel")
    assert [bid.command for bid in robot.out.bids] == [Travel(0.2, 5.0)]
    assert robot.replies == [Dropped("raise the lift then turn left")]
    robot.settle()
    assert set(kinds(robot)) == {MoveLift, Travel}
    assert robot.reasons == []


def test_never_mind_again_drops_the_one_before(robot: Any) -> None:
    robot.command(METER, words="drive a meter")
    robot.command(RAISE, words="raise the lift")
    robot.pass_time(0.3)
    say(robot, "cancel")
    say(robot, "cancel")
    say(robot, "cancel")
    assert robot.replies == [Dropped("raise the lift"), Dropped("drive a meter"), Dropped("")]
    assert robot.out.bids == ()


def test_never_mind_leaves_reactions_alone(robot: Any) -> None:
    robot.teach(f"trig: NOTE[ hq-21 -lex- close; -hq-> obj-22 ]; pref: 1.0; ---; {METER}")
    robot.replies.clear()
    robot.feel(range_m=0.1)
    robot.tick()
    say(robot, "cancel")
    assert robot.out.bids
    assert robot.replies == [Dropped("")]


# -- go on ---------------------------------------------------------------------------------


@pytest.mark.parametrize("how", ["stop", "cancel"])
def test_go_on_takes_up_the_play_that_was_broken_off_and_what_comes_after(
    robot: Any, how: str
) -> None:
    robot.command(f"{RAISE}; {METER}; {TURN}", words="raise, drive, turn")
    robot.pass_time(1.5)
    if how == "stop":
        robot.stop()
        robot.tick()
    else:
        say(robot, "cancel")
    robot.pass_time(5)
    assert kinds(robot) == [MoveLift, Travel]
    say(robot, "resume")
    robot.settle()
    assert kinds(robot) == [MoveLift, Travel, Travel, Rotate]
    assert robot.replies[-1] == Resumed("raise, drive, turn")


def test_nothing_goes_on_by_itself(robot: Any) -> None:
    robot.command(METER)
    robot.pass_time(0.3)
    robot.stop()
    robot.tick()
    robot.do(RAISE)
    robot.pass_time(60)
    assert kinds(robot) == [Travel, MoveLift]


def test_there_may_be_nothing_to_go_on_with(robot: Any) -> None:
    robot.do(FORWARD)
    robot.stop()
    robot.tick()
    say(robot, "resume")
    assert robot.replies == [Halted(False), Resumed("")]


def test_it_goes_on_once(robot: Any) -> None:
    robot.command(METER, words="drive")
    robot.pass_time(0.3)
    robot.stop()
    robot.tick()
    say(robot, "resume")
    robot.settle()
    say(robot, "resume")
    assert robot.replies[-2:] == [Resumed("drive"), Resumed("")]


def test_what_goes_on_can_be_stopped_and_gone_on_with_again(robot: Any) -> None:
    robot.command(f"{METER}; {TURN}", words="drive, turn")
    for _ in range(2):
        robot.pass_time(0.3)
        robot.stop()
        robot.tick()
        say(robot, "resume")
    robot.settle()
    assert kinds(robot) == [Travel, Travel, Travel, Rotate]
    assert robot.replies[-1] == Resumed("drive, turn")


def test_of_several_the_newest_goes_on_first(robot: Any) -> None:
    robot.command(METER, words="drive")
    robot.command(RAISE, words="raise")
    robot.pass_time(0.3)
    robot.stop()
    robot.tick()
    say(robot, "resume")
    say(robot, "resume")
    assert robot.replies[-2:] == [Resumed("raise"), Resumed("drive")]
    assert {type(bid.command) for bid in robot.out.bids} == {Travel, MoveLift}


def test_a_later_stop_makes_the_earlier_one_past(robot: Any) -> None:
    for words, what in (("drive", METER), ("turn", TURN)):
        robot.command(what, words=words)
        robot.pass_time(0.3)
        robot.stop()
        robot.tick()
    say(robot, "resume")
    say(robot, "resume")
    assert robot.replies[-2:] == [Resumed("turn"), Resumed("")]


def test_what_it_was_about_is_still_meant(robot: Any) -> None:
    robot.command(f"{BLOCK}; {METER}; {GRAB}", words="fetch")
    robot.pass_time(0.3)
    robot.stop()
    robot.pass_time(5)
    say(robot, "resume")
    robot.settle()
    assert kinds(robot) == [Travel, Travel, MoveGrip]
    assert robot.replies[-1] == Resumed("fetch")


def test_when_that_is_forgotten_it_starts_again_and_says_so(robot: Any) -> None:
    robot.command(f"{BLOCK}; {RAISE}; {METER}; {GRAB}", words="fetch")
    robot.pass_time(1.5)
    robot.stop()
    robot.pass_time(40)
    say(robot, "resume")
    robot.settle()
    assert kinds(robot) == [MoveLift, Travel, MoveLift, Travel, MoveGrip]
    assert robot.replies[-1] == Resumed("fetch", afresh=True)


def test_going_on_is_under_the_vetoes_on_who_says_so(robot: Any) -> None:
    robot.teach("""
        trig: ANTE[ act-1
                    tell-2 -lex- tell
                           -agt-> obj-3
                           -dest-> obj-4
                           -cmd-> act-1
                    obj-3 -lex- rick
                    obj-4 -lex- you ]
        pref: 1.0
        ---
        PUNT[ ]
    """)
    robot.command(f"{METER}; {TURN}")
    robot.pass_time(0.3)
    robot.stop()
    robot.tick()
    robot.i_am("rick")
    say(robot, "resume")
    robot.settle()
    assert kinds(robot) == [Travel]


# -- stop as a step ------------------------------------------------------------------------


def test_stop_in_a_play_ends_the_acts_beside_it_and_the_chain_goes_on(robot: Any) -> None:
    beside = "CHAIN{; DO[ act-6 -lex- wait ]; DO[ act-7 -lex- stop ]; }"
    robot.command(f"PLAY{{; {METER}; {beside}; }}; {TURN}")
    robot.settle()
    assert kinds(robot) == [Travel, Rotate]
    assert robot.now_s < 3
    assert robot.reasons == []


def test_stop_as_a_step_lets_no_other_way_be_tried_elsewhere(robot: Any) -> None:
    for degrees in ("360", "720"):
        robot.teach(
            "trig: DO[ act-1 -lex- dance ]; pref: 1.0; ---; DO[ act-3 -lex- turn; dir-4 -lex- left; "
            f"-dir-> act-3; amt-5 -lex- degree; -str- {degrees}; -amt-> act-3 ]"
        )
    robot.command("DO[ act-1 -lex- dance ]; " + RAISE)
    robot.pass_time(0.3)
    robot.command("DO[ act-7 -lex- stop ]; " + FORWARD)
    robot.settle()
    assert kinds(robot) == [Rotate, Travel]
    assert robot.reasons == []


# -- who has the wheels --------------------------------------------------------------------


def test_taken_over_too_often_the_focus_gives_up_whatever_else_it_could_try(robot: Any) -> None:
    robot.teach(f"trig: NOTE[ hq-21 -lex- close; -hq-> obj-22 ]; pref: 1.0; ---; {TURN}")
    for amount in ("1.5", "1.9"):
        robot.teach(
            f"trig: DO[ act-1 -lex- roam ]; pref: 1.0; ---; {METER.replace('str- 1;', f'str- {amount};')}"
        )
    robot.command("DO[ act-1 -lex- roam ]; " + RAISE)
    for _ in range(3):
        robot.pass_time(0.5)
        robot.feel(range_m=0.1)
        robot.tick()
        robot.feel(range_m=None)
        robot.pass_time(1.2)
    assert robot.reasons == ["resource_lost"]
    assert kinds(robot) == [Travel, Rotate, Rotate, Rotate]
    assert not robot.out.busy
