"""Loops: number, until, while, for each; watched, smooth, bounded."""

import math
from typing import Any

import pytest

from kernel.action.call import MoveGrip, MoveLift, Rotate, Travel

FORWARD = "DO[ act-1 -lex- drive; dir-2 -lex- forward; -dir-> act-1 ]"
BACK = "DO[ act-11 -lex- drive; dir-12 -lex- backward; -dir-> act-11 ]"
TURN = "DO[ act-3 -lex- turn; dir-4 -lex- left; -dir-> act-3 ]"
RAISE = "DO[ act-5 -lex- raise ]"
SAY = "DO[ act-8 -lex- say; -obj-> txt-9; txt-9 -str- {} ]"
VERY_CLOSE = "hq-21 -lex- close; -hq-> obj-22; deg-23 -lex- very; -deg-> hq-21"
GREEN = "hq-21 -lex- green; -hq-> obj-22; ako-23 -lex- light; -ako-> obj-22"
LIGHT = "obj-2; ako-3 -lex- light; -ako-> obj-2"
DANCE = f"trig: DO[ act-31 -lex- dance ]; pref: 1.0; ---; {FORWARD}; {TURN}"
BACK_OFF = f"trig: NOTE[ {VERY_CLOSE} ]; pref: 1.0; ---; {BACK}"


def loop(body: str, *head: str) -> str:
    return "LOOP{; " + "; ".join((*head, body)) + "; }"


def green(robot: Any, polarity: str = "") -> None:
    robot.tell(f"hq-1 -lex- green; {polarity} -hq-> obj-2", LIGHT)


# -- a number ------------------------------------------------------------------------------


def test_so_many_times_one_after_another(robot: Any) -> None:
    moved = robot.do(loop(f"{FORWARD}; {TURN}", "times: 3") + f"; {RAISE}")
    assert [type(command) for command in moved] == [Travel, Rotate] * 3 + [MoveLift]
    assert robot.body.state.x_m == pytest.approx(0.6)
    assert robot.now_s == pytest.approx(7.0, abs=0.3)


def test_no_times_is_done_at_once(robot: Any) -> None:
    assert robot.do(loop(FORWARD, "times: 0") + f"; {RAISE}") == [MoveLift(0.5)]


def test_a_round_that_fails_fails_the_loop_and_the_chain(robot: Any) -> None:
    robot.body.within_reach = False
    moved = robot.do(loop(f"{FORWARD}; DO[ act-9 -lex- grab ]", "times: 3") + f"; {RAISE}")
    assert moved == [Travel(0.2, 1.0), MoveGrip(0.0)]
    assert robot.reasons == ["nothing_gripped"]


def test_loops_within_loops(robot: Any) -> None:
    robot.do(loop(f"{RAISE}; {loop(TURN, 'times: 2')}", "times: 2"))
    assert [type(command) for command in robot.moved] == [MoveLift, Rotate, Rotate] * 2


def test_a_step_of_a_procedure_may_be_a_loop(robot: Any) -> None:
    robot.teach(f"trig: DO[ act-31 -lex- patrol ]; pref: 1.0; ---; {loop(TURN, 'times: 2')}")
    assert len(robot.do("DO[ act-31 -lex- patrol ]")) == 2


# -- until ---------------------------------------------------------------------------------


def test_driving_until_is_one_motion_and_ends_in_the_tick_the_condition_comes_true(
    robot: Any,
) -> None:
    robot.command(loop(FORWARD, f"until: {VERY_CLOSE}") + f"; {RAISE}")
    robot.pass_time(25.0)
    assert robot.moved == [Travel(0.2, None)]
    assert robot.out.bids
    robot.feel(range_m=0.04)
    robot.tick()
    assert [bid.command for bid in robot.out.bids] == [MoveLift(0.5)]
    robot.settle()
    assert robot.reasons == []


def test_true_at_the_start_nothing_moves(robot: Any) -> None:
    robot.feel(range_m=0.04)
    assert robot.do(loop(FORWARD, f"until: {VERY_CLOSE}")) == []
    assert robot.reasons == []


def test_what_was_told_ends_it_too(robot: Any) -> None:
    robot.command(loop(TURN, f"until: {GREEN}"))
    robot.pass_time(5)
    green(robot)
    assert robot.moved == [Rotate(pytest.approx(math.pi / 2), None)]
    assert not robot.out.busy


def test_what_was_told_long_ago_counts(robot: Any) -> None:
    green(robot)
    robot.pass_time(60)
    assert robot.do(loop(TURN, f"until: {GREEN}")) == []


@pytest.mark.parametrize(
    "later",
    [
        "ACH[ hq-1 -lex- green; -hq-> obj-2 ]",
        "FIND[ obj-40; ako-41 -lex- light; -ako-> obj-40; hq-42 -lex- green; -hq-> obj-40 ]; "
        "DO[ act-31 -lex- grab; -obj-> obj-40 ]",
    ],
)
def test_what_is_only_spoken_of_is_not_so(robot: Any, later: str) -> None:
    robot.command(f"{loop(TURN, f'until: {GREEN}')}; {later}")
    robot.pass_time(2)
    assert robot.out.busy
    assert len(robot.moved) == 1


def test_an_amount_is_kept_and_repeated(robot: Any) -> None:
    amount = "DO[ act-1 -lex- drive; amt-2 -lex- meter; -str- 0.1; -amt-> act-1 ]"
    robot.command(loop(amount, f"until: {VERY_CLOSE}"))
    robot.pass_time(1.2)
    assert robot.moved == [Travel(0.2, 0.5)] * 3


def test_the_steps_of_a_taught_verb_keep_their_lengths_and_it_is_broken_off_in_the_middle(
    robot: Any,
) -> None:
    robot.teach(DANCE)
    robot.command(loop("DO[ act-31 -lex- dance ]", f"until: {VERY_CLOSE}"))
    robot.pass_time(4.5)
    assert robot.moved == [Travel(0.2, 1.0), Rotate(pytest.approx(math.pi / 2), 1.0)] * 2 + [
        Travel(0.2, 1.0)
    ]
    robot.feel(range_m=0.04)
    robot.tick()
    assert robot.out.bids == ()
    assert not robot.out.busy
    assert robot.reasons == []


def test_two_actions_are_repeated_and_not_stretched(robot: Any) -> None:
    robot.command(loop(f"{FORWARD}; {TURN}", f"until: {VERY_CLOSE}"))
    robot.pass_time(2.5)
    assert robot.moved[0] == Travel(0.2, 1.0)
    assert len(robot.moved) == 3


def test_an_alias_of_drive_is_driven_without_end_too(robot: Any) -> None:
    robot.teach("if: act-1 -lex- trundle; then: act-1 -lex- drive; belief: 1.0")
    robot.command(loop("DO[ act-1 -lex- trundle ]", f"until: {VERY_CLOSE}"))
    robot.pass_time(3)
    assert robot.moved == [Travel(0.2, None)]


def test_nothing_is_close_holds_while_nothing_is_known_to_be(robot: Any) -> None:
    robot.feel(range_m=0.1)
    nothing = "hq-21 -lex- close; -neg- yes; -hq-> obj-22"
    robot.command(loop(BACK, f"until: {nothing}"))
    robot.pass_time(3)
    assert robot.moved == [Travel(-0.2, None)]
    robot.feel(range_m=0.3)
    robot.tick()
    assert not robot.out.busy


# -- while ---------------------------------------------------------------------------------


@pytest.mark.parametrize("ending", ["denied", "forgotten"])
def test_while_ends_when_it_is_not_so(robot: Any, ending: str) -> None:
    robot.feel(range_m=0.1)
    close = "hq-21 -lex- close; -hq-> obj-22"
    condition = close if ending == "forgotten" else GREEN
    green(robot)
    robot.command(loop(TURN, f"while: {condition}"))
    robot.pass_time(7)
    assert len(robot.moved) == 1
    assert robot.out.busy
    if ending == "forgotten":
        robot.feel(range_m=None)
        robot.tick()
    else:
        green(robot, "-neg- yes;")
    assert not robot.out.busy
    assert robot.out.bids == ()


def test_while_an_unknown_condition_does_nothing(robot: Any) -> None:
    assert robot.do(loop(TURN, f"while: {GREEN}")) == []
    assert robot.reasons == []


# -- without end ---------------------------------------------------------------------------


def test_it_goes_on_until_it_is_stopped_and_a_stop_ends_it_at_once(robot: Any) -> None:
    robot.command(loop(TURN))
    robot.pass_time(40)
    assert len(robot.moved) == 1
    robot.stop()
    robot.tick()
    assert robot.out.bids == ()
    robot.pass_time(5)
    assert len(robot.moved) == 1


@pytest.mark.parametrize("head", [(), ("times: 1000",), (f"while: {GREEN}",)])
def test_rounds_that_take_no_time_are_bounded_and_it_is_said(robot: Any, head: Any) -> None:
    green(robot)
    robot.teach("trig: DO[ act-31 -lex- idle ]; pref: 1.0; ---; DO[ act-32 -lex- doze ]")
    robot.teach(f"trig: DO[ act-31 -lex- doze ]; pref: 1.0; ---; {loop(RAISE, 'times: 0')}")
    robot.command(loop("DO[ act-31 -lex- idle ]", *head))
    robot.tick()
    assert robot.reasons == ["runaway"]
    assert len(robot.records("chosen")) < 1000


def test_a_loop_that_takes_time_may_go_round_more_often(robot: Any) -> None:
    robot.command(loop(f"DO[ act-6 -lex- wait ]; {FORWARD}", "times: 120"))
    robot.settle(300)
    assert robot.reasons == []
    assert len(robot.moved) == 120


def test_going_round_for_an_hour_takes_no_memory(robot: Any) -> None:
    robot.teach(DANCE)
    robot.teach(f"trig: ANTE[ act-31 -lex- turn ]; pref: 1.0; ---; {SAY.format('left')}")
    robot.command(loop("DO[ act-31 -lex- dance ]"))
    sizes = []
    for _ in range(4):
        for _ in range(100):
            robot.tick(0.5)
        sizes.append(len(robot.mind.memory.net))
    assert max(sizes) - min(sizes) < 20
    assert len(robot.moved) > 80


# -- for each ------------------------------------------------------------------------------

GRAB = "DO[ act-1 -lex- grab; -obj-> obj-2 ]; DO[ act-3 -lex- release; -obj-> obj-2 ]"
BLOCKS = "each: obj-2; ako-3 -lex- block; -ako-> obj-2; hq-4 -lex- {}; -hq-> obj-2"


def grabbed(robot: Any) -> list[str]:
    return [r.data["text"] for r in robot.records("action_started") if r.data["text"][:4] == "grab"]


def block(robot: Any, *qualities: str) -> None:
    described = "; ".join(
        f"hq-{7 + n} -lex- {quality}; -hq-> obj-2" for n, quality in enumerate(qualities)
    )
    robot.tell(
        "hq-1 -lex- heavy; -hq-> obj-2",
        f"obj-2; ako-3 -lex- block; -ako-> obj-2; {described}",
    )


def test_for_each_known_thing_of_the_description_newest_first(robot: Any) -> None:
    block(robot, "red", "small")
    block(robot, "blue", "round")
    block(robot, "red", "flat")
    robot.do(loop(GRAB, BLOCKS.format("red")))
    assert len(grabbed(robot)) == 2
    assert "flat" in grabbed(robot)[0]
    assert "small" in grabbed(robot)[1]


def test_for_so_many_of_them_at_most(robot: Any) -> None:
    for shape in ("small", "round", "flat"):
        block(robot, "red", shape)
    robot.do(loop(GRAB, f"times: 2; {BLOCKS.format('red')}"))
    assert [text.split()[3] for text in grabbed(robot)] == ["flat", "round"]


def test_the_list_is_taken_when_it_begins(robot: Any) -> None:
    block(robot, "red", "small")
    robot.command(loop(GRAB, BLOCKS.format("red")))
    robot.tick()
    block(robot, "red", "flat")
    robot.settle()
    assert len(grabbed(robot)) == 1


def test_for_none_known_it_fails(robot: Any) -> None:
    block(robot, "red", "small")
    assert robot.do(loop(GRAB, BLOCKS.format("blue"))) == []
    assert robot.reasons == ["nothing_found"]


# -- others ask for the wheels -------------------------------------------------------------


def test_a_loop_waits_for_its_wheels_and_goes_on(robot: Any) -> None:
    robot.teach(BACK_OFF)
    robot.command(loop(FORWARD, f"until: {GREEN}"))
    robot.pass_time(1)
    robot.feel(range_m=0.04)
    robot.tick()
    assert [bid.command for bid in robot.out.bids] == [Travel(-0.2, 1.0)]
    robot.feel(range_m=None)
    robot.pass_time(2)
    assert [bid.command for bid in robot.out.bids] == [Travel(0.2, None)]
    assert robot.moved == [Travel(0.2, None), Travel(-0.2, 1.0)]


def test_the_condition_is_watched_while_it_has_no_wheels(robot: Any) -> None:
    robot.command(loop(FORWARD, f"until: {VERY_CLOSE}"))
    robot.pass_time(1)
    robot.command(TURN)
    robot.tick()
    robot.feel(range_m=0.04)
    robot.tick()
    robot.feel(range_m=None)
    robot.settle()
    assert [type(command) for command in robot.moved] == [Travel, Rotate]
