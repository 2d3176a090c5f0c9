"""STOP: what matches ends, the rest goes on."""

from typing import Any

import pytest

from kernel.action.call import MoveLift, Rotate, Travel
from kernel.memory.meaning import Control
from kernel.memory.notation import read
from kernel.memory.reply import Halted

METER = "DO[ act-11 -lex- drive; amt-12 -lex- meter; -str- 1; -amt-> act-11 ]"
SPIN = "DO[ act-13 -lex- turn; dir-14 -lex- left; -dir-> act-13; amt-15 -lex- degree; -str- 360; -amt-> act-13 ]"
RAISE = "DO[ act-16 -lex- raise; deg-17 -lex- fully; -deg-> act-16 ]"
TURNING = "act-1 -lex- turn"
STOP = f"STOP[ {TURNING} ]"


def about(text: str) -> Any:
    return read(text.replace("; ", "\n"))


def kinds(robot: Any) -> set[str]:
    return {type(bid.command).__name__ for bid in robot.out.bids}


def test_a_step_ends_what_matches_in_other_foci_and_goes_on(robot: Any) -> None:
    robot.command(SPIN)
    robot.command(RAISE)
    robot.pass_time(0.3)
    robot.command(f"{STOP}; {METER}")
    robot.tick()
    assert kinds(robot) == {"Travel", "MoveLift"}
    robot.settle()
    assert robot.moved == [MoveLift(1.0), Rotate(*_spin(robot)), Travel(0.2, 5.0)]
    assert robot.reasons == []


def _spin(robot: Any) -> tuple[float, float]:
    rotate = next(command for command in robot.moved if isinstance(command, Rotate))
    return rotate.rate_rad_s, rotate.seconds


def test_what_runs_beside_it_in_its_play_goes_on_and_nothing_comes_after(robot: Any) -> None:
    robot.command(f"PLAY{{; {SPIN}; {METER}; }}; {RAISE}")
    robot.pass_time(0.3)
    robot.hear(Control("stop", about(TURNING)))
    robot.tick()
    assert kinds(robot) == {"Travel"}
    robot.settle()
    assert robot.body.state.x_m == pytest.approx(1.0)
    assert {type(command) for command in robot.moved} == {Rotate, Travel}
    assert MoveLift(1.0) not in robot.moved
    assert [r for r in robot.replies if isinstance(r, Halted)] == [Halted(True, about(TURNING))]


def test_no_other_operator_is_tried_and_nothing_tidied_up(robot: Any) -> None:
    robot.teach(f"trig: DO[ act-1 -lex- dance ]; pref: 1.0; ---; {SPIN}")
    robot.teach(f"trig: DO[ act-1 -lex- dance ]; pref: 1.0; ---; {SPIN.replace('360', '720')}")
    for verb in ("turn", "dance"):
        robot.teach(f"trig: POST[ act-1 -lex- {verb} ]; pref: 1.0; ---; {METER}")
    robot.command("DO[ act-1 -lex- dance ]; " + RAISE)
    robot.pass_time(0.3)
    robot.hear(Control("stop", about(TURNING)))
    robot.settle()
    assert [type(command) for command in robot.moved] == [Rotate]
    assert robot.reasons == []


def test_what_it_is_a_part_of_can_be_named(robot: Any) -> None:
    robot.teach(f"trig: DO[ act-1 -lex- dance ]; pref: 1.0; ---; {SPIN}; {METER}")
    robot.command("DO[ act-1 -lex- dance ]")
    robot.command(RAISE)
    robot.pass_time(0.3)
    robot.hear(Control("stop", about("act-1 -lex- dance")))
    robot.tick()
    assert kinds(robot) == {"MoveLift"}


def test_a_loop_ends_with_the_act_that_it_repeats(robot: Any) -> None:
    robot.command(f"LOOP{{; {SPIN}; }}")
    robot.pass_time(0.3)
    robot.hear(Control("stop", about(TURNING)))
    robot.tick()
    assert not robot.out.busy
    assert robot.out.bids == ()


def test_it_does_not_end_what_it_is_a_step_of(robot: Any) -> None:
    robot.teach(
        f"trig: DO[ act-1 -lex- dance ]; pref: 1.0; ---; STOP[ act-2 -lex- dance ]; {RAISE}"
    )
    assert robot.do("DO[ act-1 -lex- dance ]") == [MoveLift(1.0)]
    assert robot.body.state.lift == 1.0


def test_what_is_stopped_is_not_tried_on_another_thing(robot: Any) -> None:
    for quality in ("red", "blue"):
        described = f"obj-2; ako-3 -lex- block; -ako-> obj-2; hq-4 -lex- {quality}; -hq-> obj-2"
        robot.tell("hq-1 -lex- heavy; -hq-> obj-2", described)
    robot.command(
        "FIND[ obj-2; ako-3 -lex- block; -ako-> obj-2 ]; DO[ act-1 -lex- grab; -obj-> obj-2 ]"
    )
    robot.pass_time(0.3)
    robot.hear(Control("stop", about("act-1 -lex- grab")))
    robot.settle()
    assert len(robot.moved) == 1


def test_there_being_none_is_no_failure_of_a_step(robot: Any) -> None:
    robot.command(METER)
    robot.tick()
    robot.command(f"{STOP}; {RAISE}")
    robot.tick()
    assert kinds(robot) == {"Travel", "MoveLift"}


def test_a_person_who_names_what_is_not_going_on_stops_all_motion(robot: Any) -> None:
    robot.command(METER)
    robot.pass_time(0.3)
    robot.hear(Control("stop", about("act-1 -lex- boogie")))
    robot.tick()
    assert robot.out.bids == ()
    robot.settle()
    assert len(robot.moved) == 1
    assert Halted(True) in robot.replies


def test_with_nothing_going_on_it_says_so(robot: Any) -> None:
    robot.hear(Control("stop", about(TURNING)))
    robot.settle()
    assert robot.replies == [Halted(False, about(TURNING))]
