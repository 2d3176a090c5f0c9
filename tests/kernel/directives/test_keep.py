"""KEEP: watches, achieves again, ends with its play."""

from typing import Any

from kernel.action.call import MoveGrip, Travel

GRIPPER = "FIND[ obj-2; ako-3 -lex- gripper; -ako-> obj-2 ]"
KEEP = "KEEP[ hq-1 -lex- closed; -hq-> obj-2 ]"
METER = "DO[ act-11 -lex- drive; amt-12 -lex- meter; -str- 1; -amt-> act-11 ]"
OPEN = f"{GRIPPER}; DO[ act-4 -lex- open; -obj-> obj-2 ]"
TO_CLOSE = """
    trig: ACH[ hq-1 -lex- closed; -hq-> obj-2; ako-3 -lex- gripper; -ako-> obj-2 ]
    pref: 1.0
    ---
    DO[ act-4 -lex- close; -obj-> obj-2 ]
"""
CLOSING = MoveGrip(0.0, must_hold=False)
OPENING = MoveGrip(1.0, must_hold=False)


def test_it_is_achieved_again_each_time_it_ceases(robot: Any) -> None:
    robot.teach(TO_CLOSE)
    robot.command(f"{GRIPPER}; {KEEP}")
    robot.pass_time(3)
    assert robot.moved == [CLOSING]
    assert robot.out.busy
    for count in (2, 3):
        robot.command(OPEN)
        robot.pass_time(4)
        assert robot.moved == [CLOSING, *[OPENING, CLOSING] * (count - 1)]
    assert robot.body.state.grip == 0.0
    assert robot.reasons == []


def test_beside_something_it_ends_with_it(robot: Any) -> None:
    robot.teach(TO_CLOSE)
    robot.command(f"{GRIPPER}; PLAY{{; {METER}; WITH; {KEEP}; }}")
    robot.tick()
    assert {type(bid.command) for bid in robot.out.bids} == {Travel, MoveGrip}
    robot.settle()
    assert robot.now_s < 6
    robot.do(OPEN)
    robot.pass_time(3)
    assert robot.moved == [Travel(0.2, 5.0), CLOSING, OPENING]


def test_what_cannot_be_achieved_is_said_once_and_tried_again(robot: Any) -> None:
    robot.command(f"{GRIPPER}; {KEEP}")
    robot.pass_time(5)
    assert robot.reasons == ["not_achieved"]
    assert robot.out.busy
    robot.command(OPEN)
    robot.pass_time(1)
    robot.feel(grip=0.0)
    robot.pass_time(2)
    assert robot.reasons == ["not_achieved"]
    assert robot.out.busy


def test_it_harms_nothing_beside_it(robot: Any) -> None:
    robot.do(f"{GRIPPER}; PLAY{{; {METER}; WITH; {KEEP}; }}; DO[ act-5 -lex- raise ]")
    assert len(robot.moved) == 2
    assert robot.reasons == ["not_achieved"]


def test_a_stop_ends_it(robot: Any) -> None:
    robot.teach(TO_CLOSE)
    robot.command(f"{GRIPPER}; {KEEP}")
    robot.pass_time(0.3)
    robot.stop()
    robot.tick()
    assert robot.out.bids == ()
    robot.do(OPEN)
    robot.pass_time(5)
    assert robot.moved == [CLOSING, OPENING]


def test_trying_for_an_hour_takes_no_memory(robot: Any) -> None:
    robot.teach(TO_CLOSE.replace("act-4 -lex- close", "act-4 -lex- dance"))
    robot.command(f"{GRIPPER}; {KEEP}")
    sizes = []
    for _ in range(4):
        for _ in range(100):
            robot.tick(1.1)
        sizes.append(len(robot.mind.memory.net))
    assert len(set(sizes[1:])) == 1
