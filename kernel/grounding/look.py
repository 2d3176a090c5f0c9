"""Finding things by looking: this body has no camera, and says so."""

from __future__ import annotations

from kernel.action.call import Act, Call, Tick, grounding_function
from kernel.action.verdict import Verdict
from kernel.errors import NoSenseError


@grounding_function("see", verbs=("find", "look for", "search for", "watch"))
def see(call: Call, tick: Tick) -> Act:
    """Look for a thing.

    Raises:
        NoSenseError: always on a body without a camera.
    """
    raise NoSenseError(call.verb)
    yield None
    return Verdict.FAILED
