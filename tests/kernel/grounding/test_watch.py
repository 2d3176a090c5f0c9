"""The senses: each border is one event, however the reading trembles at it."""

from collections.abc import Sequence
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kernel.action.call import BodyState
from kernel.action.sensing import Edge
from kernel.grounding.watch import Parts, Watch


def edges(readings: Sequence[float | None]) -> list[str]:
    watch = Watch()
    return [mark(edge) for r in readings for edge in watch.update(BodyState(range_m=r))]


def mark(edge: Edge) -> str:
    return edge.key if edge.fact else f"-{edge.key}"


@pytest.mark.parametrize(
    ("readings", "seen"),
    [
        ([None, None], []),
        ([0.2, 0.2], []),
        ([0.14], ["close"]),
        ([0.15], []),
        ([0.04], ["close", "very close"]),
        ([0.05, 0.049], ["close", "very close"]),
        ([0.14, 0.16, 0.14, 0.169], ["close"]),
        ([0.14, 0.171, 0.16, 0.14], ["close", "-close", "close"]),
        ([0.04, 0.055, 0.049], ["close", "very close"]),
        ([0.04, 0.061, 0.04], ["close", "very close", "-very close", "very close"]),
        ([0.04, None], ["close", "very close", "-close", "-very close"]),
        ([0.35, 0.29, 0.31], ["far"]),
        ([0.35, 0.27, 0.29], ["far", "-far"]),
        ([0.35, None], ["far", "-far"]),
    ],
)
def test_nearness(readings: list[float | None], seen: list[str]) -> None:
    assert edges(readings) == seen


@given(st.lists(st.none() | st.floats(0, 0.4), max_size=30))
def test_every_fact_begins_and_ends_in_turn(readings: list[float | None]) -> None:
    seen = edges([*readings, None])
    for key in ("close", "very close", "far"):
        own = [mark for mark in seen if mark.lstrip("-") == key]
        assert own == [key, f"-{key}"] * (len(own) // 2)


def test_while_the_link_is_down_nothing_is_known_to_change() -> None:
    watch = Watch()
    watch.update(BodyState(range_m=0.04))
    assert watch.update(BodyState(range_m=None, connected=False)) == []
    assert watch.update(BodyState(range_m=0.04)) == []


def test_holding_letting_go_and_dropping() -> None:
    watch = Watch()
    states = [(True, 0.0), (False, 1.0), (True, 0.0), (False, 0.0)]
    seen = [
        mark(e)
        for holding, grip in states
        for e in watch.update(BodyState(holding=holding, grip=grip))
    ]
    assert seen == ["hold", "-hold", "hold", "-hold", "drop"]


def test_a_low_battery_is_one_event() -> None:
    watch = Watch()
    volts = [None, 7.2, 6.59, 6.7, 6.59, 6.95, 6.5]
    seen = [mark(edge) for v in volts for edge in watch.update(BodyState(battery_v=v))]
    assert seen == ["low", "-low", "low"]


def test_being_stuck_is_an_event_and_not_held() -> None:
    (edge,) = Watch().update(BodyState(failed={7: "stuck"}))
    assert edge.key == "stuck"
    assert edge.fleeting


SAY = "DO[ act-7 -lex- say; -obj-> txt-8; txt-8 -str- {} ]"


@pytest.mark.parametrize(
    ("condition", "changes"),
    [
        ("hq-1 -lex- close; -hq-> obj-2", {"range_m": 0.1}),
        ("hq-1 -lex- close; -hq-> obj-2; deg-3 -lex- very; -deg-> hq-1", {"range_m": 0.04}),
        ("hq-1 -lex- far; -hq-> obj-2", {"range_m": 0.35}),
        ("hq-1 -lex- stuck; -hq-> obj-2; obj-2 -lex- you", {"failed": {99: "stuck"}}),
        ("hq-1 -lex- low; -hq-> obj-2; ako-3 -lex- battery; -ako-> obj-2", {"battery_v": 6.0}),
        ("act-1 -lex- hold; -agt-> obj-2; -obj-> obj-3; obj-2 -lex- you", {"holding": True}),
    ],
)
def test_what_is_sensed_can_be_reacted_to_once(
    robot: Any, condition: str, changes: dict[str, Any]
) -> None:
    robot.teach(f"trig: NOTE[ {condition} ]; pref: 1.0; ---; {SAY.format('oh')}")
    assert robot.said == []
    robot.feel(**changes)
    robot.pass_time(2)
    assert robot.said == ["oh"]


def test_close_is_not_very_close(robot: Any) -> None:
    robot.teach(
        "trig: NOTE[ hq-1 -lex- close; -hq-> obj-2; deg-3 -lex- very; -deg-> hq-1 ];"
        f"pref: 1.0; ---; {SAY.format('oh')}"
    )
    robot.feel(range_m=0.10)
    robot.pass_time(1)
    assert robot.said == []
    robot.feel(range_m=0.04)
    robot.pass_time(1)
    assert robot.said == ["oh"]


def test_what_is_sensed_is_so_for_as_long_as_it_is_sensed(robot: Any) -> None:
    close = "hq-1 -lex- close; -hq-> obj-2"
    robot.feel(range_m=0.1)
    robot.pass_time(60)
    assert robot.believes(close)
    robot.feel(range_m=None)
    robot.tick()
    assert not robot.believes(close)


def test_grabbing_what_is_close_grabs_it(robot: Any) -> None:
    robot.teach(
        "trig: NOTE[ hq-1 -lex- close; -hq-> obj-2 ]; pref: 1.0; ---; DO[ act-3 -lex- grab; -obj-> obj-2 ]"
    )
    robot.feel(range_m=0.1)
    robot.settle()
    assert robot.body.state.holding


# -- the state of lift and gripper ---------------------------------------------------------


def part_edges(**readings: Sequence[object]) -> list[str]:
    parts = Parts()
    states = [
        BodyState(**dict(zip(readings, values, strict=True)))
        for values in zip(*readings.values(), strict=True)
    ]
    parts.update(BodyState(lift=0.5, grip=0.5))
    return [mark(edge) for state in states for edge in parts.update(state)]


@pytest.mark.parametrize(
    ("grip", "seen"),
    [
        ([0.5, 0.03, 0.01], ["gripper closed"]),
        ([0.01, 0.05, 0.01], ["gripper closed"]),
        ([0.01, 0.07, 0.01], ["gripper closed", "-gripper closed", "gripper closed"]),
        ([0.99, 0.95, 0.5], ["gripper open", "-gripper open"]),
        ([0.97], []),
    ],
)
def test_the_gripper_is_open_or_closed_at_its_ends(grip: list[float], seen: list[str]) -> None:
    assert part_edges(grip=grip, lift=[0.5] * len(grip)) == seen


def test_the_lift_is_up_or_down_at_its_ends() -> None:
    lift = [0.0, 0.05, 0.5, 0.99, 0.95, 0.8]
    seen = ["lift down", "-lift down", "lift up", "-lift up"]
    assert part_edges(lift=lift, grip=[0.5] * len(lift)) == seen


def test_a_gripper_that_holds_something_is_closed_and_not_empty() -> None:
    assert part_edges(grip=[0.4, 0.4], lift=[0.5, 0.5], holding=[True, False]) == [
        "-gripper empty",
        "gripper closed",
        "-gripper closed",
        "gripper empty",
    ]


def test_what_is_so_at_the_first_look_is_held_and_no_news(robot: Any) -> None:
    robot.teach("trig: NOTE[ hq-1 -lex- open; -hq-> obj-2 ]; pref: 1.0; ---; "
                "DO[ act-3 -lex- raise ]")  # fmt: skip
    assert robot.believes("hq-1 -lex- open; -hq-> obj-2; ako-3 -lex- gripper; -ako-> obj-2")
    assert robot.believes("hq-1 -lex- down; -hq-> obj-2; ako-3 -lex- lift; -ako-> obj-2")
    robot.pass_time(1)
    assert robot.moved == []
    robot.feel(grip=0.5)
    robot.tick()
    assert not robot.believes("hq-1 -lex- open; -hq-> obj-2")
    robot.feel(grip=1.0)
    robot.tick()
    assert len(robot.moved) == 1
