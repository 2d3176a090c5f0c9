"""The link: one Connection is one attempt over one port; the Link decides when to try again, forever.

However a connection ends, the robot is told to stop, in a time that is bounded because nothing on the way waits.
"""

from __future__ import annotations

import asyncio
import random
import time
from collections.abc import Callable, Iterable
from contextlib import suppress

from daemon.link.port import Address, Port, PortError, SerialAddress, read_address
from daemon.link.serial_port import open_serial
from daemon.link.simulated_port import SimulatedPort
from firmware_proto.errors import WireError
from firmware_proto.messages import Message
from firmware_proto.session import Session
from firmware_proto.told import SessionState, Settled
from kernel.bodies.forklift import scene as scenes
from kernel.bodies.forklift.scene import Scene
from kernel.bodies.forklift.simulated import SimulatedForklift

POLL_S = 0.01
OPEN_S = 20.0  # a Bluetooth page takes up to that
STOP_GRACE_S = 0.15
FIRST_WAIT_S, LONGEST_WAIT_S = 0.25, 10.0
KEPT = 10_000  # messages nobody fetched


class Connection:
    """One attempt: a session over an open port, until it is lost, refused, or the port fails."""

    def __init__(
        self,
        port: Port,
        session: Session,
        clock: Callable[[], float],
        arrived: Callable[[Message], None],
    ) -> None:
        self.session = session
        self._port, self._clock, self._arrived = port, clock, arrived

    async def serve(self) -> str:
        """Exchange bytes until this connection is over; why it is.

        Raises:
            PortError: the port has failed.
        """
        try:
            reading = asyncio.create_task(self._read(), name="link.read")
            try:
                while not self.session.over and not reading.done():
                    self.flush()
                    await asyncio.wait((reading,), timeout=POLL_S)
                if reading.done():
                    raise reading.result()
            finally:
                reading.cancel()
                await asyncio.wait((reading,))
            return str(self.session.refusal or self.session.state.value)
        finally:
            await self._leave()

    def flush(self) -> None:
        """Write what the session has to say now.

        Raises:
            PortError: the port has failed.
        """
        data = self.session.poll(self._clock())
        self._take(b"")
        if data:
            self._port.write(data)

    def stop(self, latch: bool) -> int:
        """STOP onto the wire before anything else, whatever waits there. The new epoch."""
        epoch = self.session.stop(self._clock(), latch)
        self._port.urgent(self.session.poll(self._clock()))
        self._take(b"")
        return epoch

    async def _read(self) -> PortError:
        """Take what comes until the port fails; its failure."""
        try:
            while True:
                self._take(await self._port.read())
                self.flush()
        except PortError as error:
            return error

    def _take(self, data: bytes) -> None:
        for message in self.session.receive(data, self._clock()):
            self._arrived(message)

    async def _leave(self) -> None:
        """Stop the robot, give it a moment to say that it did, close."""
        try:
            self.stop(latch=False)
            with suppress(PortError, TimeoutError):
                async with asyncio.timeout(STOP_GRACE_S):
                    while self.session.ready and self.session.stopping:
                        self.flush()
                        with suppress(TimeoutError):
                            async with asyncio.timeout(POLL_S):
                                self._take(await self._port.read())
        finally:
            self._port.close()


class Link:
    """The robot as the control loop has it. Made by open_link; alive while serve() runs.

    Attributes:
        on_arrival: called whenever there is something to fetch with received(); a loop wakes itself with it.
    """

    def __init__(
        self,
        address: Address,
        scene: Scene | None = None,
        clock: Callable[[], float] = time.monotonic,
        chance: random.Random | None = None,
    ) -> None:
        self.on_arrival: Callable[[], None] = lambda: None
        self._address, self._scene, self._clock = address, scene, clock
        self._chance = chance or random.Random()
        self._connection: Connection | None = None
        self._simulated: SimulatedPort | None = None
        self._received: list[Message] = []
        self._stop_epoch = 0
        self._problem = "not tried yet"

    @property
    def connected(self) -> bool:
        """The far end is there, speaks our definition, and may be commanded."""
        return self._connection is not None and self._connection.session.ready

    @property
    def state(self) -> SessionState | None:
        """Where the present attempt stands; None between attempts."""
        return None if self._connection is None else self._connection.session.state

    @property
    def detail(self) -> str:
        """For a person: how it stands, or why the last attempt ended."""
        return self._problem if self.state is None else self.state.value

    @property
    def stop_epoch(self) -> int:
        """How many stops there were; motion computed under an earlier one is refused."""
        return self._stop_epoch

    @property
    def simulated(self) -> SimulatedForklift | None:
        """The simulated robot, if it is one and is served; its calls may be made from any thread."""
        return None if self._simulated is None else self._simulated.robot

    def received(self) -> list[Message]:
        """What has come since the last call, oldest first."""
        received, self._received = self._received, []
        return received

    def send(self, messages: Iterable[Message], epoch: int) -> None:
        """Send commands that were computed under this epoch. Without a link they fail at once."""
        connection = self._connection
        for message in messages:
            if connection is None:
                self._arrived(Settled(message, None, None, 0.0))
            else:
                connection.session.send(message, epoch, self._clock())
        self._flush()

    def beat(self) -> None:
        """The control loop is alive; call it from there and from nowhere else."""
        if self._connection is not None:
            self._connection.session.beat(self._clock())
            self._flush()

    def stop(self, latch: bool = False) -> int:
        """STOP (with latch: ESTOP) is on the wire when this returns, past every queue. The new epoch."""
        if self._connection is None:
            self._stop_epoch += 1
        else:
            self._stop_epoch = self._connection.stop(latch)
        return self._stop_epoch

    def cut(self) -> None:
        """Pull the simulated robot's cable."""
        if self._simulated is not None:
            self._simulated.cut()

    def restore(self) -> None:
        """Plug the simulated robot's cable in again."""
        if self._simulated is not None:
            self._simulated.restore()

    async def serve(self) -> None:
        """Connect, and connect again, until cancelled."""
        wait_s = FIRST_WAIT_S
        if not isinstance(self._address, SerialAddress):
            address = self._address
            self._simulated = await asyncio.to_thread(
                SimulatedPort, self._scene, address.seed, address.faults
            )
        try:
            while True:
                if await self._attempt():
                    wait_s = FIRST_WAIT_S
                await asyncio.sleep(wait_s * self._chance.uniform(0.75, 1.25))
                wait_s = min(2 * wait_s, LONGEST_WAIT_S)
        finally:
            if self._simulated is not None:
                self._simulated.close()
                self._simulated = None

    async def _attempt(self) -> bool:
        """One connection from its opening to its end. Whether it ever was up."""
        greeted = False
        try:
            async with asyncio.timeout(OPEN_S):
                port = await open_serial(self._device())
            number, seq = self._chance.randrange(1, 256), self._chance.randrange(256)
            session = Session(number, seq, self._clock(), self._stop_epoch)
            self._connection = Connection(port, session, self._clock, self._arrived)
            try:
                self._problem = await self._connection.serve()
            finally:
                greeted = session.hello is not None
        except (PortError, WireError, TimeoutError) as error:
            self._problem = str(error) or "it does not open"
        finally:
            self._connection = None
            self.on_arrival()
        return greeted

    def _device(self) -> SerialAddress:
        if isinstance(self._address, SerialAddress):
            return self._address
        path = None if self._simulated is None else self._simulated.path
        if path is None:
            raise PortError("sim", "the cable is cut")
        return SerialAddress(path)

    def _flush(self) -> None:
        if self._connection is not None:
            with suppress(PortError):  # its reader sees the same failure and ends the connection
                self._connection.flush()

    def _arrived(self, message: Message) -> None:
        if len(self._received) < KEPT:
            self._received.append(message)
        self.on_arrival()


def open_link(address: str, scene: Scene | str | None = None) -> Link:
    """The link to the robot at an address; scene, for a simulated one, is a Scene or its TOML text.

    Raises:
        AddressError: the address means nothing.
        SceneError: the text describes no scene.
    """
    return Link(read_address(address), scenes.read(scene) if isinstance(scene, str) else scene)
