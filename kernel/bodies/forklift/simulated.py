"""The simulated forklift whole: the far end's protocol, the physics, and the line to it, in virtual time.

No port and no clock: the caller writes bytes, lets time pass and reads bytes. daemon.link.simulated_port serves it
in real time; daemon.link.virtual runs it as fast as it goes.
"""

from __future__ import annotations

import math
import random
from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace
from typing import Literal

from firmware_proto.device import Device
from kernel.bodies.forklift import figures
from kernel.bodies.forklift.faults import Faults, Line
from kernel.bodies.forklift.scene import Scene, Thing, Truth, usual
from kernel.bodies.forklift.twin import STEP_S, Twin

Side = Literal["ahead", "left", "right", "behind"]
BEARING_RAD = {"ahead": 0.0, "left": math.pi / 2, "right": -math.pi / 2, "behind": math.pi}
OUTLINE_CM = {
    "ahead": figures.FRONT_CM,
    "left": figures.SIDE_CM,
    "right": figures.SIDE_CM,
    "behind": -figures.BACK_CM,
}
CLEAR_CM = 0.1  # between a thing in the fork and the chassis
OUTAGE_S = 2.0
SENSOR_STEPS = 4  # the rangefinder of the kind we model measures every 20 ms or so

Lock = AbstractContextManager[object]


class World:
    """What a judge may do to the world and see of it; distances in cm from the robot's outline (ahead: the gripper)."""

    def __init__(self, twin: Twin, lock: Lock) -> None:
        self._twin, self._lock = twin, lock

    @property
    def things(self) -> tuple[Thing, ...]:
        """Everything there is, where it is now."""
        with self._lock:
            return self._twin.things

    def truth(self) -> Truth:
        """Where the robot really is, what it really holds. For judging and drawing only."""
        with self._lock:
            return self._twin.truth()

    def place(
        self,
        noun: str,
        cm: float,
        side: Side = "ahead",
        *,
        colour: str | None = None,
        name: str | None = None,
        low: bool = False,
        following: bool = False,
    ) -> None:
        """Put a thing so far from the robot, facing it, or move the one that this describes already."""
        with self._lock:
            thing = self._described(noun, colour, name, low)
            bearing = BEARING_RAD[side]
            away_cm = OUTLINE_CM[side] + cm + thing.along_cm / 2
            self._put(
                thing, away_cm * math.cos(bearing), away_cm * math.sin(bearing), bearing, following
            )

    def between_fingers(
        self, noun: str, *, colour: str | None = None, name: str | None = None, low: bool = False
    ) -> None:
        """Put a thing, or move it, to where the gripper closes on it."""
        with self._lock:
            thing = self._described(noun, colour, name, low)
            lengthwise = thing.across_cm > thing.along_cm  # the narrow side goes between them
            length_cm = max(thing.along_cm, thing.across_cm)
            centre_cm = max(figures.PADS_CM, figures.SENSOR_CM + CLEAR_CM + length_cm / 2)
            self._put(thing, centre_cm, 0.0, math.pi / 2 if lengthwise else 0.0, False)

    def nothing_within(self, cm: float = 40.0) -> None:
        """Take away everything nearer than this that the gripper does not hold."""
        with self._lock:
            for number in reversed(range(len(self._twin.things))):
                if not self._twin.is_held(number) and self._twin.clearance_cm(number) <= cm:
                    self._twin.take(number)

    def clear(self) -> None:
        """Take away everything, from the gripper too."""
        with self._lock:
            for number in reversed(range(len(self._twin.things))):
                self._twin.take(number)

    def _described(self, noun: str, colour: str | None, name: str | None, low: bool) -> Thing:
        """The newest thing this may mean, taken out of the world, or a new one."""
        wanted = usual(noun, colour, name, low)
        things = self._twin.things
        for number in reversed(range(len(things))):
            if things[number].could_be(wanted):
                old = self._twin.take(number)
                return replace(old, colour=colour or old.colour, name=name or old.name, low=low)
        return wanted

    def _put(self, thing: Thing, x_cm: float, y_cm: float, turned: float, follows: bool) -> None:
        x, y = self._twin.to_world(x_cm, y_cm)
        heading = self._twin.truth().heading_rad
        self._twin.put(replace(thing, x_cm=x, y_cm=y, turned_rad=heading + turned), follows)


class SimulatedForklift:
    """Bytes in, bytes out, and a world around it. Deterministic for a scene, a seed and the calls.

    Args:
        scene: what stands where.
        seed: of sensor noise, line faults and the boot number.
        faults: of the line, both ways.
        lock: entered by every public call, for who steps it from one thread and edits the world from another.
    """

    def __init__(
        self,
        scene: Scene | None = None,
        seed: int = 0,
        faults: Faults | None = None,
        lock: Lock | None = None,
    ) -> None:
        chance = random.Random(seed)
        self._lock = lock or nullcontext()
        self._faults = faults or Faults()
        self._chance = random.Random(chance.getrandbits(32))
        self._twin = Twin(scene or Scene(), chance.getrandbits(32))
        self.device = Device(boot_id=chance.getrandbits(16), clock_ms=chance.getrandbits(32))
        self._to_robot = Line(self._faults, self._chance)
        self._to_host = Line(self._faults, self._chance)
        self._steps = 0
        self._owed_s = 0.0
        self._dead_until_s = 0.0
        self.world = World(self._twin, self._lock)
        self._convert()  # the first telemetry is no zeroes: an empty battery, a gripper closed

    def _convert(self) -> None:
        sensors = self._twin.sensors()
        self.device.sense(sensors.range_adc, sensors.grip_adc, sensors.battery_adc)

    @property
    def now_s(self) -> float:
        """Virtual time, s."""
        return self._steps * STEP_S

    def write(self, data: bytes) -> None:
        """Bytes leave the host."""
        with self._lock:
            if self.now_s >= self._dead_until_s:
                self._to_robot.push(data, self.now_s)

    def read(self) -> bytes:
        """Bytes that have arrived at the host since the last call."""
        with self._lock:
            return self._to_host.pop(self.now_s)

    def cut(self) -> None:
        """The line was pulled: what was under way in it never arrives."""
        with self._lock:
            self._to_robot.cut()
            self._to_host.cut()

    def advance(self, dt_s: float) -> None:
        """Let time pass, in whole steps of 5 ms; what is left over is kept for the next call."""
        with self._lock:
            self._owed_s += dt_s
            while self._owed_s >= STEP_S - 1e-9:
                self._owed_s -= STEP_S
                self._step()

    def _step(self) -> None:
        self._steps += 1
        now_s, device = self.now_s, self.device
        device.receive(self._to_robot.pop(now_s), now_s)
        self._twin.advance(device.pulses)
        if self._steps % SENSOR_STEPS == 0:
            self._convert()
        out = device.transmit()
        if out and now_s >= self._dead_until_s:
            self._to_host.push(out, now_s)
        if self._faults.disconnect and self._chance.random() < self._faults.disconnect * STEP_S:
            self._dead_until_s = now_s + OUTAGE_S
            self._to_robot.cut()
            self._to_host.cut()
