"""The link over a real PTY, in real time."""

import asyncio
import random
from collections.abc import AsyncIterator, Callable

import pytest

from daemon.link import Link, open_link
from daemon.link.port import AddressError, SerialAddress
from daemon.link.simulated_port import SimulatedPort
from firmware_proto.device import Device
from firmware_proto.messages import Drive, State
from firmware_proto.told import Settled
from kernel.action.call import Bid, BodyState, Travel
from kernel.bodies.forklift.body import Forklift
from kernel.bodies.forklift.scene import SceneError
from kernel.bodies.forklift.simulated import SimulatedForklift

TICK_S = 1 / 30


class Loop:
    """A control loop as small as can be: sense, act, beat."""

    def __init__(self, link: Link) -> None:
        self.link = link
        self.body = Forklift()
        self.state = BodyState(connected=False)
        self.bids: list[Bid] = []
        self.done: set[int] = set()
        self.failed: dict[int, str] = {}

    async def until(self, wanted: Callable[[], bool], limit_s: float = 5.0) -> float:
        """Tick until it is true; how long that took."""
        clock = asyncio.get_running_loop().time
        began_s = clock()
        async with asyncio.timeout(limit_s):
            while not wanted():
                self.state = self.body.sense(self.link.received(), clock(), self.link.connected)
                self.done |= self.state.done
                self.failed.update(self.state.failed)
                self.link.send(self.body.act(self.bids, clock()), self.link.stop_epoch)
                self.link.beat()
                await asyncio.sleep(TICK_S)
        return clock() - began_s

    @property
    def robot(self) -> SimulatedForklift:
        assert self.link.simulated is not None
        return self.link.simulated

    @property
    def device_state(self) -> State:
        return self.robot.device.state


async def stopped(serving: asyncio.Task[None]) -> None:
    serving.cancel()
    with pytest.raises(asyncio.CancelledError):
        await serving


@pytest.fixture
async def loop() -> AsyncIterator[Loop]:
    """A connected link to a simulated robot."""
    link = open_link("sim://forklift")
    serving = asyncio.create_task(link.serve())
    loop = Loop(link)
    await loop.until(lambda: loop.state.connected and loop.device_state is State.READY)
    yield loop
    if not serving.done():
        await stopped(serving)


async def test_a_drive_over_a_real_port(loop: Loop) -> None:
    loop.bids = [Bid("wheels", Travel(0.2, 1.0), 1)]
    took_s = await loop.until(lambda: 1 in loop.done)
    assert 1.0 <= took_s < 1.5
    assert loop.robot.world.truth().x_cm == pytest.approx(20, abs=2)


async def test_a_cut_cable_is_told_the_wheels_stop_and_it_comes_back(loop: Loop) -> None:
    loop.bids = [Bid("wheels", Travel(0.2, 2.0), 1)]
    await loop.until(lambda: loop.state.moving)
    loop.link.cut()
    assert await loop.until(lambda: not loop.state.connected) < 1.0
    assert loop.failed == {1: "link_lost"}
    assert await loop.until(lambda: loop.device_state is State.IDLE) < 0.6
    loop.bids = []
    await loop.until(lambda: "cut" in loop.link.detail)
    loop.link.restore()
    await loop.until(lambda: loop.state.connected)
    loop.bids = [Bid("wheels", Travel(0.2, 0.2), 2)]
    await loop.until(lambda: 2 in loop.done)


async def test_stop_is_on_the_wire_when_the_call_returns(loop: Loop) -> None:
    loop.bids = [Bid("wheels", Travel(0.2, 2.0), 1)]
    await loop.until(lambda: loop.state.moving)
    for _ in range(50):
        loop.link.send([Drive(100, 100, 2000)], 0)  # a queue to go past
    assert loop.link.stop() == 1 == loop.link.stop_epoch
    loop.body.halt()
    began_s = asyncio.get_running_loop().time()
    while loop.device_state is State.DRIVING:
        await asyncio.sleep(0.001)
        assert asyncio.get_running_loop().time() - began_s < 0.2
    loop.link.send([Drive(100, 100, 2000)], 0)
    await asyncio.sleep(0.2)
    assert loop.device_state is not State.DRIVING
    dropped = [m for m in loop.link.received() if isinstance(m, Settled)]
    assert len(dropped) >= 50
    assert {m.result for m in dropped[-40:]} == {None}


async def test_a_silent_loop_loses_the_lease(loop: Loop) -> None:
    loop.bids = [Bid("wheels", Travel(0.2, 2.0), 1)]
    await loop.until(lambda: loop.state.moving)
    await asyncio.sleep(0.4)  # the daemon hangs
    assert loop.device_state is State.IDLE
    assert loop.link.connected


async def test_the_way_out_stops_the_robot_and_is_short() -> None:
    robot = SimulatedPort()
    assert robot.path is not None
    link = Link(SerialAddress(robot.path), chance=random.Random(1))
    serving = asyncio.create_task(link.serve())
    loop = Loop(link)
    await loop.until(lambda: loop.state.connected)
    loop.bids = [Bid("wheels", Travel(0.2, 2.0), 1)]
    await loop.until(lambda: loop.state.moving)
    began_s = asyncio.get_running_loop().time()
    await stopped(serving)
    assert asyncio.get_running_loop().time() - began_s < 0.3
    assert robot.robot.device.state is not State.DRIVING  # before the lease could have ended
    assert not link.connected
    robot.close()


async def test_a_port_that_does_not_exist_is_tried_again_and_commands_fail_at_once() -> None:
    link = open_link("serial:/dev/nonsense")
    serving = asyncio.create_task(link.serve())
    loop = Loop(link)
    loop.bids = [Bid("wheels", Travel(0.2, 1.0), 1)]
    await loop.until(lambda: "nonsense" in link.detail and bool(loop.failed))
    assert loop.failed == {1: "link_lost"}
    link.send([Drive(1, 1, 1)], 0)
    assert [m.result for m in link.received() if isinstance(m, Settled)] == [None]
    assert link.stop() == 1
    assert not serving.done()
    assert link.simulated is None
    await stopped(serving)


async def test_another_definition_is_said_and_never_driven() -> None:
    robot = SimulatedPort()
    robot.robot.device = Device(definition=0xBAD)
    assert robot.path is not None
    link = Link(SerialAddress(robot.path))
    serving = asyncio.create_task(link.serve())
    loop = Loop(link)
    await loop.until(lambda: "00000BAD" in link.detail)
    assert not loop.state.connected
    await stopped(serving)
    robot.close()


async def test_arrivals_wake_the_loop(loop: Loop) -> None:
    woken = asyncio.Event()
    loop.link.on_arrival = woken.set
    async with asyncio.timeout(1):
        await woken.wait()


def test_bad_addresses_and_scenes_are_told_before_anything_runs() -> None:
    with pytest.raises(AddressError):
        open_link("tcp://localhost:1")
    with pytest.raises(SceneError):
        open_link("sim://forklift", scene="[[thing]]")
