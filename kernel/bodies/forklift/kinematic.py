"""A forklift without wire and physics: it does what it is bid, for as long as it is bid, and reports it.

For imagining, and for runs so long that the twin would be too dear. It has no friction, no inertia and no noise.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from kernel.action.call import Bid, BodyState, MoveFailure, MoveGrip, MoveLift, Rotate, Travel
from kernel.bodies.forklift.figures import REACH_CM

REACH_M: Final = REACH_CM / 100  # of the rangefinder
LOST_RAD: Final = math.radians(20)  # turned so far, what was ahead is not ahead any more
SLOP_S: Final = 1e-9
WAITING: Final = 64  # bids whose time is remembered


class Kinematic:
    """The body, and as much of the world as it needs.

    Attributes:
        state: its own report; may be replaced between two steps.
        within_reach: something stands between the fingers, so that grabbing succeeds.
    """

    def __init__(self, state: BodyState | None = None, within_reach: bool = True) -> None:
        self.state = state or BodyState()
        self.within_reach = within_reach
        self._run_s: dict[int, float] = {}
        self._ended: dict[int, MoveFailure | None] = {}
        self._turned_rad = 0.0

    def act(self, bids: Sequence[Bid], dt_s: float) -> None:
        """Do what is bid for dt_s seconds. The time of what is not bid stands still: it may be bid again later."""
        bidding = {bid.ticket for bid in bids}
        self._ended = {t: why for t, why in self._ended.items() if t in bidding}
        while len(self._run_s) > WAITING:
            del self._run_s[next(iter(self._run_s))]
        for bid in bids:
            if bid.ticket not in self._ended:
                self._run(bid, dt_s)
        self.state = replace(
            self.state,
            at_s=self.state.at_s + dt_s,
            done=frozenset(t for t, why in self._ended.items() if why is None),
            failed={t: why for t, why in self._ended.items() if why is not None},
            moving=any(b.resource == "wheels" and b.ticket not in self._ended for b in bids),
        )

    def _run(self, bid: Bid, dt_s: float) -> None:
        """One bid for so long, or for what is left of it."""
        if not self.state.connected:
            self._ended[bid.ticket] = "link_lost"
            return
        before_s = self._run_s.get(bid.ticket, 0.0)
        match bid.command:
            case Travel(speed, seconds):
                dt_s = min(dt_s, math.inf if seconds is None else seconds - before_s)
                self._travel(speed * dt_s)
                over = seconds is not None and before_s + dt_s >= seconds - SLOP_S
            case Rotate(rate, seconds):
                dt_s = min(dt_s, math.inf if seconds is None else seconds - before_s)
                self._turn(rate * dt_s)
                over = seconds is not None and before_s + dt_s >= seconds - SLOP_S
            case MoveLift(target, rate):
                lift = _toward(self.state.lift, target, rate * dt_s)
                self.state = replace(self.state, lift=lift)
                over = abs(lift - target) < SLOP_S
            case MoveGrip(target, rate):
                grip = _toward(self.state.grip, target, rate * dt_s)
                self.state = replace(self.state, grip=grip)
                over = abs(grip - target) < SLOP_S
            case _:
                raise TypeError(bid)
        self._run_s[bid.ticket] = before_s + dt_s
        if over:
            self._ended[bid.ticket] = None
            if isinstance(bid.command, MoveGrip):
                self._gripped(bid.ticket, bid.command)

    def _travel(self, distance_m: float) -> None:
        heading, ahead = self.state.heading_rad, self.state.range_m
        if ahead is not None:
            ahead = max(0.0, ahead - distance_m)
        self.state = replace(
            self.state,
            x_m=self.state.x_m + distance_m * math.cos(heading),
            y_m=self.state.y_m + distance_m * math.sin(heading),
            range_m=None if ahead is None or ahead > REACH_M else ahead,
        )

    def _turn(self, angle_rad: float) -> None:
        self._turned_rad += angle_rad
        gone = abs(self._turned_rad) > LOST_RAD
        self.state = replace(
            self.state,
            heading_rad=self.state.heading_rad + angle_rad,
            range_m=None if gone else self.state.range_m,
        )
        if gone:
            self._turned_rad = 0.0

    def _gripped(self, ticket: int, command: MoveGrip) -> None:
        caught = command.target < 0.5 and self.within_reach and command.must_hold
        self.state = replace(self.state, holding=caught)
        if command.must_hold and not caught:
            self._ended[ticket] = "missed"


def _toward(value: float, target: float, by: float) -> float:
    """The value moved toward the target by so much at most."""
    return min(value + by, target) if value < target else max(value - by, target)
