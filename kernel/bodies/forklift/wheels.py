"""The wheels: timed travel and rotation as DRIVE commands, renewed, interrupted, continued and ended.

A DRIVE of up to 2 s is a whole action and its hold the exact time. Longer actions are renewed when 700 ms remain.
The far end decides when a command has ended: MOVE_DONE, or telemetry that shows the wheels at rest.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from firmware_proto.messages import (
    MAX_HOLD_MS,
    Drive,
    Event,
    EventCode,
    Message,
    Result,
    State,
    Telem,
)
from firmware_proto.told import Settled
from kernel.action.call import Bid, MoveFailure, Rotate, Travel
from kernel.bodies.forklift.figures import wheel_permille

MAX_HOLD_S = MAX_HOLD_MS / 1000
RENEW_S = 0.7
LEAST_S = 0.001  # the wire counts in milliseconds
NOTICE_S = 0.25  # telemetry must show a running drive within this time
EARLY_S = (
    0.06  # one telemetry period: rest seen earlier than that before its end is an interruption
)
TRIES = 3
STRAY_REPORTS = 4  # telemetry, 50 ms apart, of wheels that nobody wants: the neutral DRIVE was lost

Outcome = tuple[int, MoveFailure | None]


@dataclass(slots=True, eq=False)
class _Motion:
    """One ticket's travel or rotation and what is left of it, s; infinite until it is stopped."""

    ticket: int
    command: Travel | Rotate
    left_s: float
    tries: int = 0


@dataclass(slots=True, eq=False)
class _Run:
    """The DRIVE that runs now, for one motion or for two that mix into an arc."""

    motions: tuple[_Motion, ...]
    drive: Drive
    sent_s: float
    seq: int | None = None
    seen: bool = False

    @property
    def hold_s(self) -> float:
        return self.drive.hold_ms / 1000

    @property
    def ends_s(self) -> float:
        return self.sent_s + self.hold_s


class Wheels:
    """Wheel bids in, DRIVE commands out. outcomes collects ended tickets: None for done, else why not."""

    def __init__(self) -> None:
        self.outcomes: list[Outcome] = []
        self._motions: dict[int, _Motion] = {}
        self._run: _Run | None = None
        self._done_seq: int | None = None
        self._stray = 0

    def want(self, bids: Sequence[Bid], now_s: float) -> list[Message]:
        """The commands for this tick's complete set of wheel bids."""
        wanted = tuple(self._motion(bid) for bid in bids)
        run = self._run
        if run is not None and set(wanted) == set(run.motions):
            return self._renew(run, now_s)
        if run is not None:
            self._spend(run, now_s)
            self._run = None
        if wanted:
            return [self._start(wanted, now_s)]
        if run is None and self._stray < STRAY_REPORTS:
            return []
        self._stray = 0
        return [Drive(0, 0, 1)]

    def settled(self, settled: Settled) -> None:
        """The session tells what became of a command."""
        run = self._run
        if run is None or settled.message is not run.drive:
            return
        match settled.result:
            case Result.OK:
                run.seq = settled.seq
                run.sent_s += settled.waited_s
                if self._done_seq == run.seq:
                    self._complete(run)
            case Result.STALE | Result.NO_LEASE:  # not executed; worth another try
                self._run = None
                for motion in run.motions:
                    motion.tries += 1
                    if motion.tries >= TRIES:
                        self._end(motion, "link_lost")
            case None:
                self._fail(run, "link_lost")
            case _:
                self._fail(run, "refused")

    def event(self, event: Event) -> None:
        """The far end tells that a hold ran to its end."""
        if event.code != EventCode.MOVE_DONE:
            return
        self._done_seq = event.arg
        if self._run is not None and self._run.seq == event.arg:
            self._complete(self._run)

    def telemetry(self, telem: Telem, now_s: float) -> None:
        """What the wheels do; stands in for events that were lost."""
        run, turning = self._run, telem.state == State.DRIVING
        self._stray = self._stray + 1 if turning and run is None else 0
        if run is None or run.seq is None:
            return
        if turning:
            run.seen = True
        elif telem.state == State.ESTOPPED:
            self._fail(run, "stopped")
        elif now_s > run.ends_s + (EARLY_S if run.seen else NOTICE_S):
            self._complete(run)
        elif now_s < run.ends_s - EARLY_S and (run.seen or now_s > run.sent_s + NOTICE_S):
            self._fail(run, "link_lost" if telem.flags == 0 else "refused")

    def fail_all(self, why: MoveFailure) -> None:
        """Nothing is left to run or to continue."""
        for motion in tuple(self._motions.values()):
            self._end(motion, why)
        self._run = None

    def stall(self) -> None:
        """They turn and get nowhere: what runs has failed, and they come to rest."""
        if self._run is not None:
            self._fail(self._run, "stuck")
            self._stray = STRAY_REPORTS

    # ---- one run --------------------------------------------------------------------------------------------

    def _motion(self, bid: Bid) -> _Motion:
        """The ticket's motion; a changed command under the same ticket starts over."""
        command = bid.command
        if not isinstance(command, Travel | Rotate):
            raise TypeError(f"{type(command).__name__} is no command for wheels")
        motion = self._motions.get(bid.ticket)
        if motion is None or motion.command != command:
            seconds = math.inf if command.seconds is None else max(command.seconds, LEAST_S)
            motion = self._motions[bid.ticket] = _Motion(bid.ticket, command, seconds)
        return motion

    def _start(self, motions: tuple[_Motion, ...], now_s: float) -> Drive:
        speed_m_s = sum(m.command.speed_m_s for m in motions if isinstance(m.command, Travel))
        rate_rad_s = sum(m.command.rate_rad_s for m in motions if isinstance(m.command, Rotate))
        hold_s = min(MAX_HOLD_S, *(motion.left_s for motion in motions))
        drive = Drive(*wheel_permille(speed_m_s, rate_rad_s), max(1, round(hold_s * 1000)))
        self._run = _Run(motions, drive, now_s)
        self._done_seq = None
        return drive

    def _renew(self, run: _Run, now_s: float) -> list[Message]:
        goes_on = min(motion.left_s for motion in run.motions) > run.hold_s + LEAST_S / 2
        if not goes_on or now_s < run.ends_s - RENEW_S:
            return []
        self._spend(run, now_s)
        return [self._start(run.motions, now_s)]

    def _spend(self, run: _Run, now_s: float) -> None:
        ran_s = min(max(0.0, now_s - run.sent_s), run.hold_s)
        for motion in run.motions:
            motion.left_s = max(motion.left_s - ran_s, LEAST_S)

    def _complete(self, run: _Run) -> None:
        """Its hold ran to the end: the motions it was the rest of are done, others go on at the next tick."""
        self._run = None
        for motion in run.motions:
            motion.left_s -= run.hold_s
            if motion.left_s < LEAST_S:
                self._end(motion, None)

    def _fail(self, run: _Run, why: MoveFailure) -> None:
        self._run = None
        for motion in run.motions:
            self._end(motion, why)

    def _end(self, motion: _Motion, why: MoveFailure | None) -> None:
        if self._motions.pop(motion.ticket, None) is not None:
            self.outcomes.append((motion.ticket, why))
