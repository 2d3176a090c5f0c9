"""Looking with the range sensor; for things it would need eyes, and it says so."""

import math
from typing import Any

import pytest

from kernel.action.call import Rotate
from kernel.memory.reply import Saw

CLOSE = "hq-1 -lex- close; -hq-> obj-2"
NOT_CLOSE = "hq-1 -lex- close; -neg- yes; -hq-> obj-2"


@pytest.mark.parametrize("verb", ["find", "look for", "search for"])
def test_it_has_no_way_to_see(robot: Any, verb: str) -> None:
    robot.do(
        f"FIND[ obj-2; ako-3 -lex- box; -ako-> obj-2 ]; DO[ act-1 -lex- {verb}; -obj-> obj-2 ]"
    )
    assert robot.reasons == ["no_sense"]
    assert robot.moved == []


@pytest.mark.parametrize("distance_m", [0.12, 0.03, 0.35, None])
def test_a_look_is_the_range_now_and_moves_nothing(robot: Any, distance_m: float | None) -> None:
    robot.feel(range_m=distance_m)
    assert robot.do("DO[ act-1 -lex- look ]") == []
    assert robot.replies == [Saw(distance_m)]


def test_a_look_that_finds_nothing_answers_a_check(robot: Any) -> None:
    robot.do("DO[ act-1 -lex- look ]")
    assert robot.believes(NOT_CLOSE)
    robot.feel(range_m=0.1)
    robot.settle()
    robot.do(f"CHK[ {CLOSE} ]")
    assert robot.replies[-1].verdict == "yes"


def test_it_fades(robot: Any) -> None:
    robot.do("DO[ act-1 -lex- look ]")
    robot.pass_time(31)
    assert not robot.believes(NOT_CLOSE)


def around(robot: Any, at_deg: float | None, distance_m: float = 0.1) -> list[Any]:
    """Look around with a thing at that bearing (counterclockwise)."""
    body, before = robot.body, len(robot.moves)
    ahead_rad = body.state.heading_rad
    robot.command("DO[ act-1 -lex- look around ]")
    turned: dict[int, float] = {}
    for _ in range(300):
        robot.tick()
        for bid in robot.out.bids:  # heading as it turns, which the bench reports at the end only
            turned[bid.ticket] = turned.get(bid.ticket, 0.0) + bid.command.rate_rad_s / 30
        heading_rad = ahead_rad + sum(turned.values())
        off_deg = None if at_deg is None else abs(math.degrees(heading_rad - ahead_rad) - at_deg)
        near = off_deg is not None and off_deg < 8
        robot.feel(range_m=distance_m if near else None, heading_rad=heading_rad)
        if not robot.out.busy:
            break
    return [command for _, command in robot.moves[before:]]


def test_around_is_sixty_degrees_to_both_sides_and_back(robot: Any) -> None:
    moved = around(robot, None)
    assert all(isinstance(move, Rotate) for move in moved)
    assert [round(math.degrees(m.rate_rad_s * m.seconds)) for m in moved] == [60, -120, 60]
    assert robot.replies == [Saw(None, swept=True)]
    assert robot.believes(NOT_CLOSE)


@pytest.mark.parametrize(("at_deg", "side"), [(40, "left"), (-50, "right"), (0, None)])
def test_it_tells_bearing_and_distance_of_the_nearest(
    robot: Any, at_deg: float, side: str | None
) -> None:
    around(robot, at_deg)
    (saw,) = robot.replies
    assert saw.distance_m == 0.1
    assert saw.bearing_deg == pytest.approx(at_deg, abs=12)
    assert saw.swept
    if side:
        assert robot.believes(f"loc-1 -lex- {side}; -loc-> obj-2; {CLOSE.replace('hq-1', 'hq-3')}")


def test_in_a_procedure_it_says_nothing(robot: Any) -> None:
    robot.teach("trig: DO[ act-1 -lex- patrol ]; pref: 1.0; ---; DO[ act-2 -lex- look ]")
    robot.do("DO[ act-1 -lex- patrol ]")
    assert robot.replies[1:] == []


def test_a_check_that_looks_knows(robot: Any) -> None:
    robot.teach(f"trig: CHK[ {CLOSE} ]; pref: 1.0; ---; DO[ act-3 -lex- look ]")
    for range_m, verdict in ((None, "no"), (0.1, "yes")):
        robot.feel(range_m=range_m)
        robot.settle()
        robot.do(f"CHK[ {CLOSE} ]")
        assert robot.replies[-1].verdict == verdict
        assert not isinstance(robot.replies[-1], Saw)


def test_what_has_no_range_cannot_be_checked_by_looking(robot: Any) -> None:
    robot.do("FIND[ obj-2; ako-3 -lex- oil; -ako-> obj-2 ]; DO[ act-1 -lex- check; -obj-> obj-2 ]")
    assert robot.reasons == ["no_sense"]
