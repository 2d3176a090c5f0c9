"""The link in virtual time: a session and a simulated forklift, no port and no waiting. For rehearsals and tests."""

from __future__ import annotations

import random
from collections.abc import Iterable

from firmware_proto.messages import Message
from firmware_proto.session import Session
from firmware_proto.told import SessionState
from kernel.bodies.forklift import scene as scenes
from kernel.bodies.forklift.faults import Faults
from kernel.bodies.forklift.scene import Scene
from kernel.bodies.forklift.simulated import SimulatedForklift
from kernel.bodies.forklift.twin import STEP_S

AGAIN_S = 0.5


class VirtualLink:
    """The same calls as daemon.link.service.Link, but time passes only in advance().

    Attributes:
        simulated: the robot at the other end.
        sent: every byte string written to it, with its time, for tests.
    """

    def __init__(
        self, scene: Scene | str | None = None, seed: int = 0, faults: Faults | None = None
    ) -> None:
        scene = scenes.read(scene) if isinstance(scene, str) else scene
        self.simulated = SimulatedForklift(scene, seed, faults)
        self.sent: list[tuple[float, bytes]] = []
        self._chance = random.Random(seed)
        self._epoch = 0
        self._received: list[Message] = []
        self._is_cut = False
        self._again_s = 0.0
        self._session = self._open()

    @property
    def now_s(self) -> float:
        """Virtual time, s."""
        return self.simulated.now_s

    @property
    def connected(self) -> bool:
        """The far end may be commanded."""
        return self._session.ready

    @property
    def state(self) -> SessionState:
        """Where the present attempt stands."""
        return self._session.state

    @property
    def detail(self) -> str:
        """The state in words for a log."""
        return str(self._session.refusal or self._session.state.value)

    @property
    def stop_epoch(self) -> int:
        """How many stops there were."""
        return self._session.stop_epoch

    def send(self, messages: Iterable[Message], epoch: int) -> None:
        """Send commands that were computed under this epoch."""
        for message in messages:
            self._session.send(message, epoch, self.now_s)
        self._flush()

    def stop(self, latch: bool = False) -> int:
        """STOP, past every queue. The new epoch."""
        epoch = self._session.stop(self.now_s, latch)
        self._flush()
        return epoch

    def beat(self) -> None:
        """The control loop is alive."""
        self._session.beat(self.now_s)
        self._flush()

    def received(self) -> list[Message]:
        """What has come since the last call, oldest first."""
        received, self._received = self._received, []
        return received

    def cut(self) -> None:
        """Pull the cable."""
        self._is_cut = True
        self.simulated.cut()

    def restore(self) -> None:
        """Plug it in again."""
        self._is_cut = False

    def connect(self, limit_s: float = 5.0) -> bool:
        """Let time pass until the link is up, at most limit_s. Whether it is."""
        until_s = self.now_s + limit_s
        while not self.connected and self.now_s < until_s:
            self.advance(STEP_S)
        return self.connected

    def advance(self, dt_s: float) -> None:
        """Let time pass, in steps of 5 ms."""
        for _ in range(max(1, round(dt_s / STEP_S))):
            self.simulated.advance(STEP_S)
            data = self.simulated.read()
            if not self._is_cut:
                self._received += self._session.receive(data, self.now_s)
            self._flush()
            if self._session.state is SessionState.LOST:
                self._reopen()

    def _flush(self) -> None:
        data = self._session.poll(self.now_s)
        if data:
            self.sent.append((self.now_s, data))
            if not self._is_cut:
                self.simulated.write(data)

    def _reopen(self) -> None:
        """Another attempt, some time after the last one ended."""
        self._received += self._session.receive(b"", self.now_s)
        if self._again_s == 0.0:
            self._again_s = self.now_s + AGAIN_S
        elif self.now_s >= self._again_s:
            self._again_s = 0.0
            self._epoch = self._session.stop_epoch
            self._session = self._open()

    def _open(self) -> Session:
        number, seq = self._chance.randrange(1, 256), self._chance.randrange(256)
        return Session(number, seq, self.now_s, self._epoch)
