"""Looking: with the range sensor, straight ahead or to both sides. This body has no camera, and says so."""

from __future__ import annotations

import math
from collections.abc import Generator
from typing import Final

from kernel.action.call import Act, Bid, Call, Rotate, Sighting, Tick, grounding_function
from kernel.action.motion import motion, pace
from kernel.action.verdict import Verdict
from kernel.errors import NoSenseError

SIDE_RAD: Final = math.radians(60)  # mind.md: a sweep of +-60 degrees
RATE_RAD_S: Final = math.radians(60)
WHOLE_TURN: Final = math.tau

Nearest = tuple[float, float]  # distance, m, and heading, rad


@grounding_function("look", verbs=("look", "check"))
def look(call: Call, tick: Tick) -> Act:
    """Take the range straight ahead now, or what is nearest in a sweep, where the words say "around".

    Raises:
        NoSenseError: some thing is to be checked: the range tells nothing about it.
    """
    if call.verb == "check" and call.argument("obj") is not None:
        raise NoSenseError(call.verb)
    if "around" in call.words("dir"):
        return (yield from look_around(call, tick))
    yield Bid("wheels", Sighting(tick.body.range_m), call.ticket)
    return Verdict.SUCCEEDED


@grounding_function("look around", verbs=("look around",))
def look_around(call: Call, tick: Tick) -> Act:
    """Turn 60 degrees left, 60 right of where it stood, and back, and report the nearest thing on the way.

    Raises:
        MotionFailedError: the body cannot turn.
    """
    ahead_rad = tick.body.heading_rad
    nearest: Nearest | None = None
    for angle in (SIDE_RAD, -2 * SIDE_RAD, SIDE_RAD):
        rate = math.copysign(RATE_RAD_S * pace(call), angle)
        turning = motion(Bid("wheels", Rotate(rate, angle / rate), call.fresh()), tick)
        nearest = yield from _watched(turning, tick, nearest)
    if nearest is None:
        yield Bid("wheels", Sighting(None, swept=True), call.ticket)
        return Verdict.SUCCEEDED
    distance_m, heading_rad = nearest
    bearing_rad = (heading_rad - ahead_rad + math.pi) % WHOLE_TURN - math.pi
    yield Bid("wheels", Sighting(distance_m, bearing_rad, swept=True), call.ticket)
    return Verdict.SUCCEEDED


def _watched(
    turning: Act, tick: Tick, nearest: Nearest | None
) -> Generator[Bid | None, None, Nearest | None]:
    """The nearest thing so far, taken at every tick of a motion."""
    while True:
        distance_m = tick.body.range_m
        if distance_m is not None and (nearest is None or distance_m < nearest[0]):
            nearest = distance_m, tick.body.heading_rad
        try:
            bid = next(turning)
        except StopIteration:
            return nearest
        yield bid


@grounding_function("see", verbs=("find", "look for", "search for", "watch"))
def see(call: Call, tick: Tick) -> Act:
    """Look for a thing.

    Raises:
        NoSenseError: always on a body without a camera.
    """
    raise NoSenseError(call.verb)
    yield None
    return Verdict.FAILED
