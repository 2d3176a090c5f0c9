"""What a look found."""

from __future__ import annotations

from grammars.replies import Said, both, renders
from kernel.memory.reply import Saw

AHEAD_DEG = 10.0  # nearer to straight ahead is ahead


@renders(Saw)
def saw(reply: Saw) -> Said:
    """ "Something is 12 centimeters ahead." "Something is 20 centimeters away, 40 degrees to the left." """
    if reply.distance_m is None:
        return both("there is nothing near me" if reply.swept else "there is nothing ahead of me")
    far = f"something is {max(1, round(reply.distance_m * 100))} centimeter"
    far += "" if far.endswith(" 1 centimeter") else "s"
    if abs(reply.bearing_deg) < AHEAD_DEG:
        return both(f"{far} ahead")
    side = "left" if reply.bearing_deg > 0 else "right"
    return both(f"{far} away, {abs(reply.bearing_deg):.0f} degrees to the {side}")
