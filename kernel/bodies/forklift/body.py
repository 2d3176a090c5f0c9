"""The forklift as the mind has it: bids become messages, messages become a BodyState. Telemetry is all it knows."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from firmware_proto.messages import Event, Grip, Lift, Message, State, Telem
from firmware_proto.told import Settled
from kernel.action.call import Bid, BodyState, MoveFailure
from kernel.bodies.forklift import figures
from kernel.bodies.forklift.servo import Servo
from kernel.bodies.forklift.stall import Stall
from kernel.bodies.forklift.wheels import Wheels
from kernel.bodies.registry import Body, body

MOVING = ("wheels", "lift", "grip")
REMEMBERED = 1000  # ended tickets


@body("forklift")
class Forklift(Body):
    """Wheels, lift, gripper, rangefinder, battery.

    An ended ticket stays in done or failed until its bid is gone. It never runs again: a later bid for it only has its
    end told again.
    """

    def __init__(self) -> None:
        self._wheels = Wheels()
        self._lift, self._grip = Servo(Lift), Servo(Grip)
        self._connected = False
        self._last: Telem | None = None
        self._stall = Stall()
        self._x_m = self._y_m = self._heading_rad = 0.0
        self._ended: dict[int, MoveFailure | None] = {}
        self._telling: set[int] = set()
        self._told: frozenset[int] = frozenset()

    def sense(self, messages: Iterable[Message], now_s: float, connected: bool) -> BodyState:
        """The state after these messages."""
        for message in messages:
            match message:
                case Settled():
                    for part in (self._wheels, self._lift, self._grip):
                        part.settled(message)
                case Event():
                    self._wheels.event(message)
                case Telem():
                    self._telemetry(message, now_s)
        self._connected = connected
        if not connected:
            self._fail_all("link_lost")
            self._last = None
        self._collect()
        self._told = frozenset(self._telling)
        return self._state(now_s)

    def act(self, bids: Sequence[Bid], now_s: float) -> list[Message]:
        """The commands for the complete set of this tick's winning bids."""
        bidding = {bid.ticket for bid in bids}
        self._telling -= self._told - bidding
        self._telling |= bidding & self._ended.keys()
        live = [b for b in bids if b.resource in MOVING and b.ticket not in self._ended]
        if not self._connected:
            for bid in live:
                self._end(bid.ticket, "link_lost")
            return []
        messages = self._wheels.want([b for b in live if b.resource == "wheels"], now_s)
        messages += self._lift.want([b for b in live if b.resource == "lift"])
        messages += self._grip.want([b for b in live if b.resource == "grip"])
        return messages

    def halt(self) -> None:
        """The robot was stopped past the mind."""
        self._fail_all("stopped")
        self._collect()

    def _fail_all(self, why: MoveFailure) -> None:
        for part in (self._wheels, self._lift, self._grip):
            part.fail_all(why)

    def _collect(self) -> None:
        for part in (self._wheels, self._lift, self._grip):
            for ticket, why in part.outcomes:
                self._end(ticket, why)
            part.outcomes.clear()

    def _end(self, ticket: int, why: MoveFailure | None) -> None:
        self._ended[ticket] = why
        self._telling.add(ticket)
        while len(self._ended) > REMEMBERED:
            self._telling.discard(forgotten := next(iter(self._ended)))
            del self._ended[forgotten]

    def _telemetry(self, telem: Telem, now_s: float) -> None:
        last = self._last
        if last is not None:
            passed_ms = (telem.mcu_ms - last.mcu_ms) & 0xFFFFFFFF
            if passed_ms == 0 or passed_ms >= 0x80000000:
                return  # a repeat, or overtaken by a newer one
            self._reckon(last, telem, passed_ms / 1000)
        self._last = telem
        self._wheels.telemetry(telem, now_s)
        self._lift.telemetry(telem)
        self._grip.telemetry(telem)

    def _reckon(self, before: Telem, after: Telem, seconds: float) -> None:
        """Follow the wheels from one telemetry to the next; where they changed in between, half way at each."""
        speed = figures.wheel_speed_m_s
        left = (speed(before.left_us) + speed(after.left_us)) / 2 * seconds
        right = (speed(before.right_us) + speed(after.right_us)) / 2 * seconds
        turn = (right - left) / figures.TRACK_M
        middle = self._heading_rad + turn / 2
        self._x_m += (left + right) / 2 * math.cos(middle)
        self._y_m += (left + right) / 2 * math.sin(middle)
        self._heading_rad += turn
        if self._stall.update((left + right) / 2, turn, figures.range_m(after.range_adc)):
            self._wheels.stall()

    def _state(self, now_s: float) -> BodyState:
        last = self._last
        return BodyState(
            at_s=now_s,
            connected=self._connected,
            x_m=self._x_m,
            y_m=self._y_m,
            heading_rad=self._heading_rad,
            range_m=None if last is None else figures.range_m(last.range_adc),
            lift=self._lift.at,
            grip=self._grip.opening,
            holding=self._grip.holding,
            moving=last is not None and last.state == State.DRIVING,
            estopped=last is not None and last.state == State.ESTOPPED,
            battery_v=None
            if last is None
            else last.battery_adc / figures.ADC_MAX * figures.BATTERY_FULL_SCALE_V,
            done=frozenset(t for t in self._telling if self._ended[t] is None),
            failed={t: why for t in sorted(self._telling) if (why := self._ended[t]) is not None},
        )
