"""Adverbs of a command are inherited by the steps it expands to (mind.md)."""

from typing import Any

import pytest

from kernel.action.call import MoveLift, Travel

SLOWLY = "; mod-91 -lex- slowly; -mod-> act-1"
VERY = "; deg-92 -lex- very; -deg-> mod-91"
DANCE = "DO[ act-1 -lex- dance{} ]"
DRIVE = "DO[ act-2 -lex- drive{} ]"


def to(verb: str, *steps: str, tag: str = "DO", more: str = "") -> str:
    return "; ".join((f"trig: {tag}[ act-1 -lex- {verb}{more} ]", "pref: 1.0", "---", *steps))


def speeds(moves: list[Any]) -> list[float]:
    return [move.speed_m_s for move in moves if isinstance(move, Travel)]


@pytest.mark.parametrize(
    ("adverb", "speed"),
    [("", 0.2), (SLOWLY, 0.1), (SLOWLY + VERY, 0.2 / 3), (SLOWLY.replace("slow", "quick"), 0.3)],
)
def test_every_step_has_the_manner_of_the_whole(robot: Any, adverb: str, speed: float) -> None:
    back = "DO[ act-3 -lex- drive; dir-4 -lex- backward; -dir-> act-3 ]"
    robot.teach(to("dance", DRIVE.format(""), back))
    assert speeds(robot.do(DANCE.format(adverb))) == [pytest.approx(speed), pytest.approx(-speed)]


def test_unless_it_says_otherwise(robot: Any) -> None:
    quickly = "; mod-5 -lex- quickly; -mod-> act-2"
    robot.teach(to("dance", DRIVE.format(quickly), DRIVE.replace("act-2", "act-6").format("")))
    assert speeds(robot.do(DANCE.format(SLOWLY))) == [pytest.approx(0.3), pytest.approx(0.1)]


def test_through_any_depth_and_side_by_side(robot: Any) -> None:
    robot.teach(to("dance", "DO[ act-2 -lex- cha-cha ]"))
    robot.teach(to("cha-cha", "DO[ act-2 -lex- step1 ]"))
    robot.teach(to("step1", f"PLAY{{; {DRIVE.format('')}; DO[ act-3 -lex- raise ]; }}"))
    moved = robot.do(DANCE.format(SLOWLY))
    assert speeds(moved) == [pytest.approx(0.1)]
    assert [m.per_second for m in moved if isinstance(m, MoveLift)] == [pytest.approx(0.25)]


def test_an_adverb_that_the_trigger_asks_for_is_taken_up(robot: Any) -> None:
    robot.teach(to("dance", DRIVE.format(""), more="; mod-8 -lex- slowly; -mod-> act-1"))
    assert speeds(robot.do(DANCE.format(SLOWLY))) == [0.2]


def test_not_by_what_is_done_before_and_after_or_in_reaction(robot: Any) -> None:
    robot.teach(to("dance", "NOTE[ hq-5 -lex- merry; -hq-> obj-6 ]", DRIVE.format("")))
    back = "DO[ act-2 -lex- drive; dir-3 -lex- backward; -dir-> act-2 ]"
    robot.teach(to("dance", back, tag="ANTE"))
    robot.teach(to("dance", back, tag="POST"))
    robot.teach(f"trig: NOTE[ hq-5 -lex- merry; -hq-> obj-6 ]; pref: 1.0; ---; {back}")
    assert speeds(robot.do(DANCE.format(SLOWLY))) == [-0.2, -0.2, pytest.approx(0.1), -0.2]


def test_a_direction_is_not_inherited(robot: Any) -> None:
    robot.teach(to("dance", DRIVE.format("")))
    assert speeds(robot.do(DANCE.format("; dir-9 -lex- backward; -dir-> act-1"))) == [0.2]


def test_the_next_dance_is_danced_as_ever(robot: Any) -> None:
    robot.teach(to("dance", DRIVE.format("")))
    robot.do(DANCE.format(SLOWLY))
    assert speeds(robot.do(DANCE.format(""))) == [0.2]


def test_a_prohibition_of_the_manner_is_seen(robot: Any) -> None:
    robot.teach(to("dance", DRIVE.format("")))
    robot.teach(to("drive", "PUNT[ ]", tag="ANTE", more="; mod-8 -lex- slowly; -mod-> act-1"))
    assert robot.do(DANCE.format(SLOWLY)) == []
    assert speeds(robot.do(DANCE.format(""))) == [0.2]
