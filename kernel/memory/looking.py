"""What a look found, as facts."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Final

from kernel.action.call import Sighting
from kernel.net.graphlet import Graphlet, Term

CLOSE_M: Final = 0.15  # mind.md: from the gripper's front, as the standing senses have it
ASIDE_RAD: Final = math.radians(10)  # ours: nearer to straight ahead is "in front of"


def seen(sighting: Sighting) -> Iterator[Graphlet]:
    """Facts that hold where the robot has looked.

    What is straight ahead now the standing senses report, and keep up to date; a look adds what they cannot: that there
    is nothing, and what is to the side.
    """
    distance_m, bearing_rad = sighting.distance_m, sighting.bearing_rad
    if distance_m is None or (distance_m >= CLOSE_M and not sighting.swept):
        thing = Term("obj-2")
        near = Term("hq-1", frozenset({"close"}), negated=True, links=(("hq", "obj-2"),))
        yield Graphlet((near, thing), "hq-1")
        return
    if abs(bearing_rad) < ASIDE_RAD:
        return
    side = "left" if bearing_rad > 0 else "right"
    place = Term("loc-1", frozenset({side}), links=(("loc", "obj-2"),))
    terms = [place]
    if distance_m < CLOSE_M:
        terms.append(Term("hq-3", frozenset({"close"}), links=(("hq", "obj-2"),)))
    yield Graphlet((*terms, Term("obj-2")), "loc-1")
