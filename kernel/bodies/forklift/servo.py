"""Lift and gripper: one slewed target at a time, ended by telemetry."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from firmware_proto.messages import Flag, Grip, Lift, Message, Result, State, Telem
from firmware_proto.pulses import SLEW_MAX_PERMILLE_S
from firmware_proto.told import Settled
from kernel.action.call import Bid, MoveFailure, MoveGrip, MoveLift
from kernel.bodies.forklift.figures import ADC_MAX, servo_fraction
from kernel.bodies.forklift.wheels import TRIES, Outcome

ARRIVED = 0.003  # of the pulse, of the way
SETTLED = 0.01  # the fingers have stopped moving
GRIPPED = 0.08  # the fingers stand this much wider than they were told: something is between them
CLOSED = (
    0.1  # below this the fork is closed, and what must hold something either does or has missed
)


@dataclass(slots=True)
class _Move:
    """The command that runs now."""

    ticket: int
    command: MoveLift | MoveGrip
    message: Lift | Grip
    acknowledged: bool = False
    halted: int = 0


class Servo:
    """Bids for one servo in, LIFT or GRIP commands out. outcomes as in Wheels."""

    def __init__(self, kind: type[Lift] | type[Grip]) -> None:
        self.outcomes: list[Outcome] = []
        self.at = 0.0 if kind is Lift else 1.0
        self.opening = self.at
        self.holding = False
        self._kind = kind
        self._move: _Move | None = None
        self._tries: tuple[int, int] = (0, 0)

    def want(self, bids: Sequence[Bid]) -> list[Message]:
        """The commands for this tick's bid, if there is one; without one the servo holds where it is."""
        move = self._move
        if not bids:
            self._move = None
            return [] if move is None else [self._command(self.at, move.message.rate_permille_s)]
        command = bids[-1].command
        if not isinstance(command, MoveLift | MoveGrip):
            raise TypeError(f"{type(command).__name__} is no command for a servo")
        if move is not None and (move.ticket, move.command) == (bids[-1].ticket, command):
            return []
        rate = min(max(1, round(command.per_second * 1000)), SLEW_MAX_PERMILLE_S)
        message = self._command(command.target, rate)
        self._move = _Move(bids[-1].ticket, command, message)
        return [message]

    def settled(self, settled: Settled) -> None:
        """The session tells what became of a command."""
        move = self._move
        if move is None or settled.message is not move.message:
            return
        if settled.result == Result.OK:
            move.acknowledged = True
            return
        late = settled.result in (Result.STALE, Result.NO_LEASE)
        ticket, tries = self._tries
        self._tries = (move.ticket, tries + 1 if ticket == move.ticket else 1)
        if late and self._tries[1] < TRIES:
            self._move = None  # not executed; its bid sends it again
        else:
            self._end("link_lost" if late or settled.result is None else "refused")

    def telemetry(self, telem: Telem) -> None:
        """Where the servo is; ends what has arrived."""
        lift = self._kind is Lift
        self.at = servo_fraction(telem.lift_us if lift else telem.grip_us)
        slewing = bool(telem.flags & (Flag.LIFT_SLEWING if lift else Flag.GRIP_SLEWING))
        before, self.opening = self.opening, self.at if lift else telem.grip_adc / ADC_MAX
        wide = self.opening - self.at > GRIPPED
        self.holding = wide and (self.holding or not slewing)
        move = self._move
        if move is None or not move.acknowledged:
            return
        if abs(self.at - move.message.target_permille / 1000) <= ARRIVED:
            if abs(self.opening - before) <= SETTLED:
                grab = (
                    isinstance(move.command, MoveGrip)
                    and move.command.must_hold
                    and self.at < CLOSED
                )
                self._end("missed" if grab and not wide else None)
        elif not slewing:
            # held short of its target; twice, as the first may have been on its way before the command
            move.halted += 1
            if move.halted > 1:
                self._end("stopped" if telem.state == State.ESTOPPED else "link_lost")

    def fail_all(self, why: MoveFailure) -> None:
        """Nothing is left to run."""
        if self._move is not None:
            self._end(why)

    def _command(self, target: float, rate: int) -> Lift | Grip:
        return self._kind(min(max(round(target * 1000), 0), 1000), rate)

    def _end(self, why: MoveFailure | None) -> None:
        if self._move is not None:
            self.outcomes.append((self._move.ticket, why))
            self._move = None
