"""FIND: which thing is meant, and another one where that fails."""

from typing import Any

from kernel.action.call import MoveGrip, Travel

BLOCK = "FIND[ obj-2 -ref- the; ako-3 -lex- block; -ako-> obj-2 ]"
IT = "FIND[ obj-2 -ref- it ]"
TAKE = "; DO[ act-1 -lex- take; -obj-> obj-2 ]"


def blocks(robot: Any, *names: str) -> None:
    for name in names:
        robot.tell("ako-1 -lex- block; -ako-> obj-2", f"obj-2 -lex- {name}")


def can_take(robot: Any, name: str) -> None:
    robot.teach(
        f"trig: DO[ act-1 -lex- take; -obj-> obj-2; obj-2 -lex- {name} ]; pref: 1.0; ---;"
        f"DO[ act-3 -lex- say; -obj-> txt-4; txt-4 -str- {name} ]"
    )


def test_the_newest_is_meant(robot: Any) -> None:
    blocks(robot, "one", "two")
    for name in ("one", "two"):
        can_take(robot, name)
    robot.do(BLOCK + TAKE)
    assert robot.said == ["two"]


def test_the_one_mentioned_last_is_the_newest(robot: Any) -> None:
    blocks(robot, "one", "two")
    for name in ("one", "two"):
        can_take(robot, name)
    robot.tell("hq-1 -lex- red; -hq-> obj-2", "obj-2 -lex- one")
    robot.do(BLOCK + TAKE)
    robot.do(IT + TAKE)
    assert robot.said == ["one", "one"]


def test_a_failure_later_in_the_chain_comes_back_for_another(robot: Any) -> None:
    blocks(robot, "one", "two", "three")
    can_take(robot, "one")
    robot.do(BLOCK + TAKE)
    assert robot.said == ["one"]


def test_it_comes_back_past_steps_that_succeeded(robot: Any) -> None:
    blocks(robot, "one", "two")
    can_take(robot, "one")
    robot.do(BLOCK + "; DO[ act-5 -lex- drive ]" + TAKE)
    assert robot.said == ["one"]
    assert robot.moved == [Travel(0.2, 1.0)] * 2


def test_the_nearest_look_up_is_the_first_to_be_reconsidered(robot: Any) -> None:
    blocks(robot, "one", "two")
    for name in ("alice", "bob"):
        robot.tell("ako-1 -lex- friend; -ako-> obj-2", f"obj-2 -lex- {name}")
    robot.teach(
        "trig: DO[ act-1 -lex- give; -obj-> obj-2; -dest-> obj-3; obj-2 -lex- one; obj-3 -lex- alice ];"
        "pref: 1.0; ---; DO[ act-4 -lex- say; -obj-> txt-5; txt-5 -str- here ]"
    )
    robot.do(
        BLOCK
        + "; FIND[ obj-4; ako-5 -lex- friend; -ako-> obj-4 ]; DO[ act-1 -lex- give; -obj-> obj-2; -dest-> obj-4 ]"
    )
    assert robot.said == ["here"]


def test_none_left_fails_and_the_reason_is_the_first(robot: Any) -> None:
    blocks(robot, "one", "two")
    robot.do(BLOCK + TAKE)
    assert robot.reasons == ["no_way"]


def test_something_to_grab_may_be_assumed(robot: Any) -> None:
    assert robot.do(BLOCK + "; DO[ act-1 -lex- grab; -obj-> obj-2 ]") == [MoveGrip(0.0)]
    assert robot.believes("ako-1 -lex- block; -ako-> obj-2")


def test_what_was_assumed_is_the_same_thing_next_time(robot: Any) -> None:
    robot.do(BLOCK + "; DO[ act-1 -lex- grab; -obj-> obj-2 ]")
    robot.do(IT + "; DO[ act-1 -lex- release; -obj-> obj-2 ]")
    assert robot.moved == [MoveGrip(0.0), MoveGrip(1.0, must_hold=False)]


def test_a_place_to_go_to_has_to_be_known(robot: Any) -> None:
    robot.do(
        "FIND[ obj-2 -ref- the; ako-3 -lex- kitchen; -ako-> obj-2 ]; DO[ act-1 -lex- go; -dest-> obj-2 ]"
    )
    assert robot.moved == []
    (failed,) = robot.replies
    assert (failed.reason, failed.detail) == ("nothing_found", "kitchen")


def test_it_is_nothing_where_nothing_was_mentioned(robot: Any) -> None:
    robot.do(IT + "; DO[ act-1 -lex- grab; -obj-> obj-2 ]")
    assert robot.moved == []
    assert robot.reasons == ["nothing_found"]


def test_somebody_spoken_to_may_be_assumed(robot: Any) -> None:
    robot.do(
        "FIND[ obj-2 -lex- mary ]; DO[ act-1 -lex- say; -obj-> txt-3; -dest-> obj-2; txt-3 -str- hello ]"
    )
    assert robot.said == ["hello"]


def test_you_are_never_it(robot: Any) -> None:
    robot.do(IT + "; DO[ act-1 -lex- grab; -obj-> obj-2 ]", speaker="Rick")
    assert robot.moved == []


def test_inside_a_play_the_newest_is_taken(robot: Any) -> None:
    blocks(robot, "one", "two")
    robot.do(f"PLAY{{; {BLOCK}; DO[ act-5 -lex- drive ]; }}")
    assert robot.moved == [Travel(0.2, 1.0)]
