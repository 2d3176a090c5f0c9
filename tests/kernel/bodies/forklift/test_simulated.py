"""Editing the world as dialogue files do, and the line to the robot."""

import pytest

from firmware_proto.frame import FrameReader, encode_message
from firmware_proto.messages import Drive, Grip, Heartbeat, Hello, State
from kernel.bodies.forklift.faults import Faults
from kernel.bodies.forklift.scene import Scene
from kernel.bodies.forklift.simulated import Side, SimulatedForklift


def turned(robot: SimulatedForklift, seconds: float = 1.0) -> SimulatedForklift:
    """After driving an arc."""
    robot.write(encode_message(Hello(1), 5, 1) + encode_message(Heartbeat(0), 5, 0))
    robot.advance(0.02)
    not_after = (robot.device._mcu_ms() + 200) & 0xFFFF
    robot.write(encode_message(Drive(200, 500, round(seconds * 1000), not_after), 5, 2))
    for _ in range(round(seconds / 0.1) + 3):
        robot.write(encode_message(Heartbeat(0), 5, 0))
        robot.advance(0.1)
    return robot


def test_a_thing_is_placed_ahead_of_the_gripper_wherever_the_robot_is() -> None:
    robot = turned(SimulatedForklift())
    assert abs(robot.world.truth().heading_rad) > 0.5
    robot.world.place("wall", 4)
    assert robot.world.truth().range_cm == pytest.approx(4, abs=0.01)


@pytest.mark.parametrize(
    ("side", "x", "y"),
    [("ahead", 18.5, 0), ("left", 0, 17.5), ("right", 0, -17.5), ("behind", -18.5, 0)],
)
def test_distances_are_from_the_outline_to_the_nearest_face(side: Side, x: int, y: int) -> None:
    robot = SimulatedForklift()
    robot.world.place("block", 10, side)
    (thing,) = robot.world.things
    assert (thing.x_cm, thing.y_cm) == pytest.approx((x, y))


def test_a_new_line_for_the_same_noun_moves_it_and_another_colour_is_another() -> None:
    world = SimulatedForklift().world
    world.place("block", 10, colour="red")
    world.place("block", 20)
    assert [(t.colour, t.x_cm) for t in world.things] == [("red", 28.5)]
    world.place("block", 30, colour="blue")
    assert {t.colour for t in world.things} == {"red", "blue"}
    world.place("block", 12, "left", colour="red")
    assert len(world.things) == 2


def test_nothing_within_takes_what_is_near_but_not_what_is_held() -> None:
    robot = SimulatedForklift()
    robot.world.place("wall", 4)
    robot.world.place("box", 60)
    robot.world.place("cup", 30, "behind")
    robot.world.nothing_within(40)
    assert [t.noun for t in robot.world.things] == ["box"]
    robot.world.clear()
    assert robot.world.things == ()


def test_a_low_block_between_the_fingers_is_not_in_the_beam() -> None:
    robot = SimulatedForklift()
    robot.world.between_fingers("block", low=True)
    assert robot.world.truth().range_cm is None


@pytest.mark.parametrize("noun", ["block", "pill", "cup", "sneaker", "gadget"])
def test_what_is_put_between_the_fingers_can_be_gripped(noun: str) -> None:
    robot = SimulatedForklift()
    robot.world.between_fingers(noun, colour="red", name="Bert", low=True)
    robot.write(encode_message(Hello(1), 5, 1) + encode_message(Heartbeat(0), 5, 0))
    robot.advance(0.02)
    not_after = (robot.device._mcu_ms() + 200) & 0xFFFF
    robot.write(encode_message(Grip(0, 4000, not_after), 5, 2))
    robot.advance(0.29)
    for _ in range(5):
        robot.write(encode_message(Heartbeat(0), 5, 0))
        robot.advance(0.1)
    held = robot.world.truth().holding
    assert held is not None
    assert (held.noun, held.colour, held.name) == (noun, "red", "Bert")
    robot.world.nothing_within(40)
    assert robot.world.truth().holding == held


def test_what_follows_stays_ahead() -> None:
    robot = SimulatedForklift()
    robot.world.place("wall", 4, following=True)
    turned(robot)
    assert robot.world.truth().range_cm == pytest.approx(4, abs=0.2)
    assert len(robot.world.things) == 1


def test_time_comes_in_steps_of_5_ms_and_none_is_lost() -> None:
    robot = SimulatedForklift()
    for _ in range(300):
        robot.advance(1 / 300)
    assert robot.now_s == pytest.approx(1.0, abs=0.006)


def test_a_robot_replays_bit_for_bit() -> None:
    def run(seed: int) -> tuple[bytes, object]:
        robot = SimulatedForklift(Scene(), seed, Faults(drop=0.1, flip=0.05, split=0.5))
        robot.world.place("block", 8)
        turned(robot)
        return robot.read(), robot.world.truth()

    assert run(1) == run(1)
    assert run(1)[0] != run(2)[0]


def test_a_disconnect_silences_both_directions_and_the_lease_ends() -> None:
    robot = turned(SimulatedForklift(faults=Faults(disconnect=1.0)), 2.0)
    for _ in range(10):
        robot.advance(0.1)
        if robot._dead_until_s > robot.now_s:
            break
    robot.read()
    robot.write(encode_message(Heartbeat(0), 5, 0))
    robot.advance(0.4)
    assert robot.read() == b""
    assert robot.device.state is State.IDLE


def test_a_cut_line_loses_what_is_under_way() -> None:
    robot = SimulatedForklift()
    robot.write(encode_message(Hello(1), 5, 1))
    robot.cut()
    robot.advance(0.1)
    assert robot.device.state is State.BOOT


def test_telemetry_comes_out_as_frames() -> None:
    robot = turned(SimulatedForklift())
    frames = FrameReader().feed(robot.read())
    assert {f.number for f in frames} == {0x80, 0x81, 0x82, 0x90, 0x91}
