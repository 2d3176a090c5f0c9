"""The wheels: drive and turn.

Defaults and limits are those of mind.md's grounding table: 20 cm at 20 cm/s, 90 degrees at 90 degrees/s.
"""

from __future__ import annotations

import math
from typing import Final

from kernel.action.call import (
    Act,
    Bid,
    Call,
    Halt,
    Rotate,
    Tick,
    Travel,
    counted,
    grounding_function,
)
from kernel.action.motion import motion, pace
from kernel.action.verdict import Verdict
from kernel.errors import LimitError, NotGroundedError

SPEED_M_S: Final = 0.20
STEP_M: Final = 0.20
FARTHEST_M: Final = 2.0
RATE_RAD_S: Final = math.radians(90)
TURN_RAD: Final = math.radians(90)
WIDEST_RAD: Final = math.radians(720)
LITTLE: Final = 0.5  # "a little" is half the default
SLOP: Final = 1e-6

METERS: Final = {
    "meter": 1.0,
    "centimeter": 0.01,
    "millimeter": 0.001,
    "inch": 0.0254,
    "foot": 0.3048,
    "yard": 0.9144,
}
AHEAD: Final = {"forward": 1.0, "ahead": 1.0, "straight": 1.0, "backward": -1.0, "back": -1.0}
ROUND: Final = {"left": 1.0, "counterclockwise": 1.0, "right": -1.0, "clockwise": -1.0}


@grounding_function("base_drive", verbs=("drive", "move", "go", "step", "roll"))
def base_drive(call: Call, tick: Tick) -> Act:
    """Drive straight until the distance or time is run; endlessly, where no amount was said, if the call is so.

    Reads direction, pace and amount from any word under the action node, so "drive forward slowly" needs no operator
    of its own. When it ends the wheels stop, because nobody bids for them.

    Raises:
        NotGroundedError: the words name no direction this base knows, or a place it cannot find.
        LimitError: farther than 2 m, all times together.
    """
    _no_destination(call)
    sign = _direction(call, AHEAD, default=1.0)
    speed = SPEED_M_S * pace(call)
    distance = STEP_M * (LITTLE if _a_little(call) else 1.0)
    amount = call.amount()
    if amount is not None:
        number, unit = amount
        if unit == "second":
            distance = number * speed
        elif unit in METERS:
            distance = number * METERS[unit]
        else:
            raise NotGroundedError(call.verb, unit)
    elif call.endless and not _a_little(call):
        return (yield from motion(Bid("wheels", Travel(sign * speed, None), call.ticket), tick))
    if distance * counted(call.act) > FARTHEST_M + SLOP:
        raise LimitError(call.verb, "2 meters")
    if distance <= 0:
        return Verdict.SUCCEEDED
    command = Travel(sign * speed, distance / speed)
    return (yield from motion(Bid("wheels", command, call.ticket), tick))


@grounding_function("base_turn", verbs=("turn", "rotate", "spin"))
def base_turn(call: Call, tick: Tick) -> Act:
    """Turn in place by an angle; endlessly, where no amount was said, if the call is so.

    Raises:
        NotGroundedError: the words name no direction this base knows.
        LimitError: more than 720 degrees, all times together.
    """
    _no_destination(call)
    words = _known_words(call, {*ROUND, "around"})
    around = "around" in words
    sign = next((ROUND[word] for word in sorted(words) if word in ROUND), None)
    if sign is None:
        if not around and call.verb != "spin":
            raise NotGroundedError(call.verb, "direction")
        sign = 1.0
    rate = RATE_RAD_S * pace(call)
    whole = around or call.verb == "spin"
    angle = TURN_RAD * (2.0 if whole else 1.0) * (LITTLE if _a_little(call) else 1.0)
    amount = call.amount()
    if amount is not None:
        number, unit = amount
        if unit == "second":
            angle = number * rate
        elif unit == "degree":
            angle = math.radians(number)
        else:
            raise NotGroundedError(call.verb, unit)
    elif call.endless and not _a_little(call):
        return (yield from motion(Bid("wheels", Rotate(sign * rate, None), call.ticket), tick))
    if angle * counted(call.act) > WIDEST_RAD + SLOP:
        raise LimitError(call.verb, "720 degrees")
    if angle <= 0:
        return Verdict.SUCCEEDED
    command = Rotate(sign * rate, angle / rate)
    return (yield from motion(Bid("wheels", command, call.ticket), tick))


@grounding_function("base_stop", verbs=("stop", "halt"))
def base_stop(call: Call, tick: Tick) -> Act:
    """End the motion of all other activities, as a step: the chain it stands in goes on (mind.md)."""
    yield Bid("wheels", Halt(), call.ticket)
    return Verdict.SUCCEEDED


def _no_destination(call: Call) -> None:
    if call.argument("dest") is not None:
        raise NotGroundedError(call.verb, "way there")


def _known_words(call: Call, known: set[str]) -> frozenset[str]:
    words = call.words("dir")
    for node in call.modifiers("dir"):
        if not known & node.words():
            raise NotGroundedError(call.verb, min(node.lex, default="direction"))
    return words


def _direction(call: Call, meaning: dict[str, float], default: float) -> float:
    words = _known_words(call, set(meaning))
    return next((meaning[word] for word in sorted(words) if word in meaning), default)


def _a_little(call: Call) -> bool:
    nodes = (call.act, *call.modifiers("dir"), *call.modifiers("amt"))
    return any("little" in call.degree(node) for node in nodes)
