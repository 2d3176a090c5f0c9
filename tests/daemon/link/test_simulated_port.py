"""The simulated robot on its PTY, in real time."""

import os
import time
from collections.abc import Iterator

import pytest

from daemon.link.simulated_port import SimulatedPort
from firmware_proto.frame import FrameReader, encode_message
from firmware_proto.messages import Hello, HelloAck, number_of


@pytest.fixture
def port() -> Iterator[SimulatedPort]:
    port = SimulatedPort()
    yield port
    port.close()


def until(limit_s: float, wanted: object) -> bool:
    """Whether it becomes true in time."""
    assert callable(wanted)
    end_s = time.monotonic() + limit_s
    while time.monotonic() < end_s:
        if wanted():
            return True
        time.sleep(0.002)
    return False


def test_it_keeps_the_pace_of_the_clock(port: SimulatedPort) -> None:
    ratios = []
    for _ in range(3):  # a busy machine may disturb one
        began_s, from_s = time.monotonic(), port.robot.now_s
        assert until(3, lambda from_s=from_s: port.robot.now_s - from_s >= 0.3)
        ratios.append((port.robot.now_s - from_s) / (time.monotonic() - began_s))
    assert min(abs(ratio - 1) for ratio in ratios) < 0.1


def test_whoever_opens_the_path_talks_to_the_robot(port: SimulatedPort) -> None:
    assert port.path is not None
    device = os.open(port.path, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
    reader, found = FrameReader(), []

    def answered() -> bool:
        try:
            found.extend(f.number for f in reader.feed(os.read(device, 4096)))
        except BlockingIOError:
            return False
        return number_of(HelloAck) in found

    os.write(device, encode_message(Hello(1), 3, 3))
    assert until(2, answered)
    os.close(device)


def test_a_cut_hangs_up_and_a_restored_port_serves_the_same_robot(port: SimulatedPort) -> None:
    port.robot.world.place("wall", 4)
    assert port.path is not None
    device = os.open(port.path, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
    port.cut()
    assert port.path is None

    def hung_up() -> bool:
        try:
            return os.read(device, 10) == b""
        except BlockingIOError:
            return False
        except OSError:
            return True

    assert until(2, hung_up)
    os.close(device)
    port.restore()
    assert port.path is not None
    assert [t.noun for t in port.robot.world.things] == ["wall"]


def test_two_robots_do_not_collide(port: SimulatedPort) -> None:
    other = SimulatedPort()
    assert other.path != port.path
    other.close()
    assert other.path is None
