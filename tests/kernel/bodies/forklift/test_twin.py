"""The physics alone: pulses in, sensors and truth out."""

import math

import pytest

from firmware_proto.pulses import Pulses
from kernel.bodies.forklift import figures
from kernel.bodies.forklift.scene import Scene, Thing, Truth, usual
from kernel.bodies.forklift.twin import STEP_S, Twin

REST = Pulses(1500, 1500, 1000, 2000)
FORWARD = Pulses(1700, 1700, 1000, 2000)
CLOSE = Pulses(1500, 1500, 1000, 1000)


def go(twin: Twin, pulses: Pulses, seconds: float, rest_s: float = 0.3) -> Truth:
    for _ in range(round(seconds / STEP_S)):
        twin.advance(pulses)
    for _ in range(round(rest_s / STEP_S)):
        twin.advance(
            REST if pulses.grip_us == 2000 else Pulses(1500, 1500, pulses.lift_us, pulses.grip_us)
        )
    return twin.truth()


def read(twin: Twin, pulses: Pulses = REST) -> figures.Sensors:
    twin.advance(pulses)
    return twin.sensors()


def block(x_cm: float, y_cm: float = 0.0, low: bool = False, noun: str = "block") -> Thing:
    thing = usual(noun, low=low)
    return Thing(noun, None, None, low, x_cm, y_cm, 0.0, thing.along_cm, thing.across_cm)


def test_a_second_forwards_is_20_cm() -> None:
    truth = go(Twin(Scene(), 1), FORWARD, 1.0)
    assert (truth.x_cm, truth.y_cm, truth.heading_rad) == pytest.approx((20, 0, 0), abs=0.1)


def test_a_quarter_turn_turns_on_the_spot() -> None:
    left, right = figures.wheel_permille(0, math.pi / 2)
    pulses = Pulses(1500 + left // 2, 1500 + right // 2, 1000, 2000)
    truth = go(Twin(Scene(), 1), pulses, 1.0)
    assert math.degrees(truth.heading_rad) == pytest.approx(90, abs=2)
    assert (truth.x_cm, truth.y_cm) == pytest.approx((0, 0), abs=0.1)


def test_it_starts_where_the_scene_says() -> None:
    truth = go(Twin(Scene(30, -10, math.pi / 2), 1), FORWARD, 1.0)
    assert (truth.x_cm, truth.y_cm) == pytest.approx((30, 10), abs=0.1)


def test_a_wall_holds_it() -> None:
    truth = go(Twin(Scene(things=(block(18, noun="wall"),)), 1), FORWARD, 2.0)
    assert truth.x_cm == pytest.approx(10, abs=0.5)  # the front is 7 cm ahead, the wall 1 cm nearer


def test_a_block_is_pushed_and_stays_where_it_is_left() -> None:
    twin = Twin(Scene(things=(block(12),)), 1)
    go(twin, FORWARD, 1.0)
    (pushed,) = twin.things
    assert pushed.x_cm == pytest.approx(20 + figures.SENSOR_CM + 1.5, abs=0.5)
    go(twin, Pulses(1300, 1300, 1000, 2000), 1.0)
    assert twin.things[0].x_cm == pytest.approx(pushed.x_cm, abs=0.3)


def test_the_gripper_takes_what_is_between_its_fingers() -> None:
    twin = Twin(Scene(things=(block(5, low=True),)), 1)
    truth = go(twin, CLOSE, 1.0)
    assert truth.holding is not None
    assert truth.grip == pytest.approx(3 / figures.FORK_OPENING_CM, abs=0.02)
    go(twin, Pulses(1300, 1300, 1000, 1000), 1.0)
    assert twin.things[0].x_cm == pytest.approx(5 - 20, abs=0.3)
    truth = go(twin, REST, 1.0)
    assert truth.holding is None
    assert truth.grip == 1.0
    go(twin, Pulses(1300, 1300, 1000, 2000), 1.0)
    assert twin.things[0].x_cm == pytest.approx(5 - 20, abs=0.5)


@pytest.mark.parametrize(
    "thing",
    [
        block(9),
        block(5, 5.5),
        block(5, 2.0, noun="pill"),
        block(9, noun="box"),
        block(9, noun="wall"),
    ],
)
def test_the_gripper_misses_what_is_beside_beyond_too_wide_or_fixed(thing: Thing) -> None:
    truth = go(Twin(Scene(things=(thing,)), 1), CLOSE, 1.0)
    assert truth.holding is None
    assert truth.grip == 0.0


@pytest.mark.parametrize("ahead_cm", [0.5, 4, 10, 25, 38])
def test_the_beam_measures_from_the_grippers_front(ahead_cm: float) -> None:
    twin = Twin(Scene(things=(block(7 + ahead_cm + 1, noun="wall"),)), 1)
    readings = [figures.range_m(read(twin).range_adc) or 9 for _ in range(40)]
    assert sum(readings) / 40 * 100 == pytest.approx(ahead_cm, abs=0.5)
    assert twin.truth().range_cm == pytest.approx(ahead_cm, abs=0.01)


@pytest.mark.parametrize(
    "scene", [Scene(), Scene(things=(block(20, low=True),)), Scene(things=(block(20, 4),))]
)
def test_nothing_low_or_aside_is_in_the_beam(scene: Scene) -> None:
    twin = Twin(scene, 1)
    assert {figures.range_m(read(twin).range_adc) for _ in range(40)} == {None}


def test_what_follows_keeps_its_place_and_touches_nothing() -> None:
    twin = Twin(Scene(), 1)
    twin.put(block(7 + 4 + 1, noun="wall"), follows=True)
    truth = go(twin, FORWARD, 1.0)
    assert truth.x_cm == pytest.approx(20, abs=0.1)
    assert truth.range_cm == pytest.approx(4, abs=0.2)


def test_the_same_seed_gives_the_same_world_bit_for_bit() -> None:
    def history(seed: int) -> list[object]:
        twin = Twin(Scene(things=tuple(block(14 + 4 * n, n % 3 - 1) for n in range(8))), seed)
        return [(read(twin, FORWARD), twin.truth(), twin.things) for _ in range(200)]

    assert history(4) == history(4)
    assert history(4) != history(5)


def test_the_battery_falls_and_sags_under_load() -> None:
    twin = Twin(Scene(), 1)
    resting = [read(twin).battery_adc for _ in range(20)]
    driving = [read(twin, FORWARD).battery_adc for _ in range(20)]
    assert max(driving[5:]) < min(resting)
