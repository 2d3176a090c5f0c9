"""The fork: lift and gripper."""

from __future__ import annotations

from typing import Final

from kernel.action.call import Act, Bid, Call, MoveGrip, MoveLift, Tick, grounding_function
from kernel.action.motion import motion, pace
from kernel.errors import NotGroundedError

STEP: Final = 0.5  # one step of the lift, of its whole travel
TRAVEL_M: Final = 0.10
UP: Final = frozenset(("raise", "lift", "higher", "up"))
CLOSING: Final = frozenset(("grab", "grip", "close", "grasp"))
METERS: Final = {"meter": 1.0, "centimeter": 0.01, "millimeter": 0.001, "inch": 0.0254}


@grounding_function("fork_lift", verbs=("raise", "lower", "lift"))
def fork_lift(call: Call, tick: Tick) -> Act:
    """Move the lift up or down by one step, by an amount, or all the way.

    Raises:
        NotGroundedError: the amount is in a unit that is no length.
    """
    sign = 1.0 if UP & call.act.words() else -1.0
    step = STEP
    nodes = (call.act, *call.modifiers("dir"), *call.modifiers("mod"))
    degrees = {word for node in nodes for word in call.degree(node)} | call.words("mod")
    if "fully" in degrees:
        step = 1.0
    elif "little" in degrees:
        step = STEP / 2
    amount = call.amount()
    if amount is not None:
        number, unit = amount
        if unit not in METERS:
            raise NotGroundedError(call.verb, unit)
        step = number * METERS[unit] / TRAVEL_M
    target = min(1.0, max(0.0, tick.body.lift + sign * step))
    command = MoveLift(target, per_second=0.5 * pace(call))
    return (yield from motion(Bid("lift", command, call.ticket), tick))


@grounding_function(
    "fork_grip", verbs=("grab", "grip", "grasp", "close", "release", "open", "let go", "drop")
)
def fork_grip(call: Call, tick: Tick) -> Act:
    """Close or open the gripper; "grab" fails when nothing was gripped, "close the gripper" does not.

    Raises:
        MotionFailedError: "missed" when nothing is between the fingers.
    """
    closing = bool(CLOSING & call.act.words())
    thing = call.argument("obj")
    own_part = thing is not None and any(
        "you" in owner.lex for own in thing.modifiers("own") for owner in own.to("of")
    )
    target = 0.0 if closing else 1.0
    command = MoveGrip(target, must_hold=closing and not own_part)
    return (yield from motion(Bid("grip", command, call.ticket), tick))
