"""The wheels: what words mean, defaults, limits."""

import math
from typing import Any

import pytest

from kernel.action.call import Rotate, Travel

WORDS = {"dir": "dir-2 -lex- {}; -dir-> act-1", "mod": "mod-3 -lex- {}; -mod-> act-1"}


def act(verb: str, way: str = "", how: str = "", amount: str = "", degree: str = "") -> str:
    """degree: word and role of what it is about, "very mod"."""
    parts = [f"act-1 -lex- {verb}"]
    if way:
        parts.append(f"dir-2 -lex- {way}; -dir-> act-1")
    if how:
        parts.append(f"mod-3 -lex- {how}; -mod-> act-1")
    if amount:
        number, unit = amount.split()
        parts.append(f"amt-4 -lex- {unit}; -str- {number}; -amt-> act-1")
    if degree:
        word, of = degree.split()
        parts.append(f"deg-5 -lex- {word}; -deg-> {of}")
    return "DO[ " + "; ".join(parts) + " ]"


@pytest.mark.parametrize(
    ("command", "speed", "seconds"),
    [
        (act("drive"), 0.2, 1.0),
        (act("move", "forward"), 0.2, 1.0),
        (act("go", "backward"), -0.2, 1.0),
        (act("step", "back"), -0.2, 1.0),
        (act("drive", "ahead"), 0.2, 1.0),
        (act("drive", "forward", "slowly"), 0.1, 2.0),
        (act("drive", "forward", "quickly"), 0.3, 2 / 3),
        (act("drive", "forward", "slowly", degree="very mod-3"), 0.2 / 3, 3.0),
        (act("drive", "forward", "quickly", degree="very mod-3"), 0.45, 4 / 9),
        (act("drive", "forward", degree="little act-1"), 0.2, 0.5),
        (act("drive", "forward", amount="50 centimeter"), 0.2, 2.5),
        (act("drive", "forward", amount="1 meter"), 0.2, 5.0),
        (act("drive", "backward", amount="10 inch"), -0.2, 1.27),
        (act("drive", "forward", amount="2 foot"), 0.2, 3.048),
        (act("drive", "forward", amount="3 second"), 0.2, 3.0),
        (act("drive", "forward", "slowly", amount="3 second"), 0.1, 3.0),
        (act("drive", "forward", amount="2 meter"), 0.2, 10.0),
    ],
)
def test_driving(robot: Any, command: str, speed: float, seconds: float) -> None:
    (moved,) = robot.do(command)
    assert isinstance(moved, Travel)
    assert (moved.speed_m_s, moved.seconds) == (pytest.approx(speed), pytest.approx(seconds))


@pytest.mark.parametrize(
    ("command", "degrees", "seconds"),
    [
        (act("turn", "left"), 90, 1.0),
        (act("rotate", "counterclockwise"), 90, 1.0),
        (act("turn", "right"), -90, 1.0),
        (act("spin", "clockwise"), -180, 2.0),
        (act("spin"), 180, 2.0),
        (act("turn", "around"), 180, 2.0),
        (act("turn", "left", degree="little dir-2"), 45, 0.5),
        (act("turn", "left", amount="45 degree"), 45, 0.5),
        (act("turn", "right", "slowly", amount="90 degree"), -90, 2.0),
        (act("turn", "left", amount="720 degree"), 720, 8.0),
        (act("turn", "left", amount="2 second"), 180, 2.0),
    ],
)
def test_turning(robot: Any, command: str, degrees: float, seconds: float) -> None:
    (moved,) = robot.do(command)
    assert isinstance(moved, Rotate)
    assert moved.seconds == pytest.approx(seconds)
    assert moved.rate_rad_s * moved.seconds == pytest.approx(math.radians(degrees))


@pytest.mark.parametrize(
    ("command", "reason", "detail"),
    [
        (act("drive", "forward", amount="2.01 meter"), "too_much", "2 meters"),
        (act("drive", "forward", amount="11 second"), "too_much", "2 meters"),
        (act("turn", "left", amount="721 degree"), "too_much", "720 degrees"),
        (act("drive", "widdershins"), "not_grounded", "widdershins"),
        (act("drive", "left"), "not_grounded", "left"),
        (act("turn", "up"), "not_grounded", "up"),
        (act("turn"), "not_grounded", "direction"),
        (act("drive", "forward", amount="5 degree"), "not_grounded", "degree"),
        (act("turn", "left", amount="5 meter"), "not_grounded", "meter"),
        (act("drive", "forward", amount="many meter"), "not_grounded", "many"),
        (act("drive", "forward", amount="nan meter"), "not_grounded", "nan"),
        (act("drive", "forward", amount="inf meter"), "not_grounded", "inf"),
    ],
)
def test_what_it_refuses(robot: Any, command: str, reason: str, detail: str) -> None:
    assert robot.do(command) == []
    (failed,) = robot.replies
    assert (failed.reason, failed.detail) == (reason, detail)


@pytest.mark.parametrize(
    "command", [act("drive", amount="0 meter"), act("turn", "left", amount="0 degree")]
)
def test_nothing_to_do_is_done(robot: Any, command: str) -> None:
    assert robot.do(command) == []
    assert robot.reasons == []


def test_a_place_it_cannot_find_its_way_to_is_refused(robot: Any) -> None:
    robot.tell("ako-1 -lex- kitchen; -ako-> obj-2", "obj-2 -lex- kitchen")
    assert robot.do("FIND[ obj-2 -lex- kitchen ]; DO[ act-1 -lex- go; -dest-> obj-2 ]") == []
    assert robot.reasons == ["not_grounded"]


def test_aliases_of_verb_and_direction_are_understood(robot: Any) -> None:
    robot.teach("if: act-1 -lex- twirl; then: act-1 -lex- rotate; belief: 1.0")
    robot.teach("if: dir-1 -lex- widdershins; then: dir-1 -lex- counterclockwise; belief: 1.0")
    (moved,) = robot.do(act("twirl", "widdershins"))
    assert moved == Rotate(pytest.approx(math.pi / 2), pytest.approx(1.0))
