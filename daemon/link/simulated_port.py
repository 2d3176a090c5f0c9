"""The simulated forklift on a PTY, in real time: whoever opens the path cannot tell it from a serial device."""

from __future__ import annotations

import os
import threading
import time
import tty
from contextlib import suppress

from kernel.bodies.forklift.faults import Faults
from kernel.bodies.forklift.scene import Scene
from kernel.bodies.forklift.simulated import SimulatedForklift
from kernel.bodies.forklift.twin import STEP_S

CHUNK = 4096
BEHIND_S = 0.5  # more behind than that, the machine was asleep: the lost time is skipped, not rushed through


class SimulatedPort:
    """Serves one robot from its making to close(), in a thread of its own.

    The pace comes from absolute deadlines, so that late wake-ups do not add up.

    Attributes:
        robot: the robot; every public call of it may be made from any thread.
    """

    def __init__(
        self, scene: Scene | None = None, seed: int = 0, faults: Faults | None = None
    ) -> None:
        self._lock = threading.RLock()
        self.robot = SimulatedForklift(scene, seed, faults, self._lock)
        self._master: int | None = None
        self._slave: int | None = None
        self._path: str | None = None
        self._closing = threading.Event()
        self.restore()
        self._thread = threading.Thread(target=self._serve, name="simulated-robot", daemon=True)
        self._thread.start()

    @property
    def path(self) -> str | None:
        """The device to open; None while the cable is cut."""
        return self._path

    def cut(self) -> None:
        """Pull the cable: the PTY is gone, the robot is not."""
        with self._lock:
            master, slave = self._master, self._slave
            self._master = self._slave = self._path = None
            self.robot.cut()
        for descriptor in (master, slave):
            if descriptor is not None:
                os.close(descriptor)

    def restore(self) -> None:
        """Plug it in again, at a new path."""
        with self._lock:
            if self._master is not None:
                return
            # this end keeps the far side open as well, so that its user may come and go without a hang-up
            self._master, self._slave = os.openpty()
            tty.setraw(self._slave)
            os.set_blocking(self._master, False)
            self._path = os.ttyname(self._slave)

    def close(self) -> None:
        """End the robot and the PTY."""
        self._closing.set()
        self._thread.join(1.0)
        self.cut()

    def _serve(self) -> None:
        due_s = time.monotonic()
        while not self._closing.is_set():
            due_s += STEP_S
            with self._lock:
                self._exchange()
            late_s = time.monotonic() - due_s
            if late_s > BEHIND_S:
                due_s += late_s
            elif late_s < 0:
                self._closing.wait(-late_s)

    def _exchange(self) -> None:
        """One step of the robot, and the bytes of both directions."""
        if self._master is not None:
            with suppress(BlockingIOError):
                self.robot.write(os.read(self._master, CHUNK))
        self.robot.advance(STEP_S)
        data = self.robot.read()
        if data and self._master is not None:
            with suppress(BlockingIOError):  # nobody reads: like a serial line, it is lost
                os.write(self._master, data)
