"""WAIT: until it is so."""

from typing import Any

from kernel.action.call import MoveLift

WAIT = "WAIT[ hq-1 -lex- green; -hq-> obj-2; ako-3 -lex- light; -ako-> obj-2 ]"
RAISE = "DO[ act-5 -lex- raise ]"
GREEN = ("hq-1 -lex- green; -hq-> obj-2", "obj-2; ako-3 -lex- light; -ako-> obj-2")


def test_it_goes_on_in_the_tick_it_becomes_so(robot: Any) -> None:
    robot.command(f"{WAIT}; {RAISE}")
    robot.pass_time(700)
    assert robot.moved == []
    assert robot.out.busy
    robot.tell(*GREEN)
    assert robot.moved == [MoveLift(0.5)]


def test_so_already_it_does_not_wait(robot: Any) -> None:
    robot.tell(*GREEN)
    robot.command(f"{WAIT}; {RAISE}")
    robot.tick()
    assert robot.moved == [MoveLift(0.5)]


def test_it_waits_for_what_is_not_so(robot: Any) -> None:
    robot.feel(range_m=0.1)
    robot.command(f"WAIT[ hq-1 -lex- close; -neg- yes; -hq-> obj-2 ]; {RAISE}")
    robot.pass_time(3)
    assert robot.moved == []
    robot.feel(range_m=0.4)
    robot.tick()
    assert robot.moved == [MoveLift(0.5)]


def test_a_stop_ends_the_waiting(robot: Any) -> None:
    robot.command(f"{WAIT}; {RAISE}")
    robot.tick()
    robot.stop()
    robot.tick()
    robot.tell(*GREEN)
    assert robot.moved == []
