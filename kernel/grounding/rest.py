"""Doing nothing for a while."""

from __future__ import annotations

from typing import Final

from kernel.action.call import Act, Call, Tick, grounding_function
from kernel.action.verdict import Verdict
from kernel.errors import LimitError, NotGroundedError

DEFAULT_S: Final = 1.0
LONGEST_S: Final = 600.0
SECONDS: Final = {"second": 1.0, "minute": 60.0}


@grounding_function("rest", verbs=("wait", "pause", "rest"))
def rest(call: Call, tick: Tick) -> Act:
    """Wait: 1 s, or the amount of time said, up to 10 minutes.

    Raises:
        NotGroundedError: the amount is no time.
        LimitError: longer than 10 minutes.
    """
    seconds = DEFAULT_S
    amount = call.amount()
    if amount is not None:
        number, unit = amount
        if unit not in SECONDS:
            raise NotGroundedError(call.verb, unit)
        seconds = number * SECONDS[unit]
    if seconds > LONGEST_S:
        raise LimitError(call.verb, "10 minutes")
    until_s = tick.now_s + seconds
    while tick.now_s < until_s:
        yield None
    return Verdict.SUCCEEDED
