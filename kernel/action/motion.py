"""What motions of any body have in common: how fast, and waiting for the far end to report the end."""

from __future__ import annotations

from typing import Final

from kernel.action.call import Act, Bid, Call, Tick
from kernel.action.verdict import Verdict
from kernel.errors import MotionFailedError

SLOW: Final = frozenset(("slowly", "slow", "carefully", "gently", "softly"))
FAST: Final = frozenset(("quickly", "quick", "fast", "rapidly", "hurry"))
SLOWER: Final = 0.5
FASTER: Final = 1.5
VERY: Final = 1.5  # "very" takes the pace that much further


def pace(call: Call) -> float:
    """Factor on the default speed: slowly 0.5, quickly 1.5, with "very" 0.33 and 2.25."""
    factor = 1.0
    for node in call.modifiers("mod"):
        words = node.words()
        strength = VERY if "very" in call.degree(node) else 1.0
        if words & SLOW:
            factor = SLOWER / strength
        elif words & FAST:
            factor = FASTER * strength
    return factor


def motion(bid: Bid, tick: Tick) -> Act:
    """Bid until the body reports the command executed.

    Raises:
        MotionFailedError: the body reports that it cannot be.
    """
    while bid.ticket not in tick.body.done:
        if bid.ticket in tick.body.failed:
            raise MotionFailedError(bid.ticket, tick.body.failed[bid.ticket])
        yield bid
    return Verdict.SUCCEEDED
