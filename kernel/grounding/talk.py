"""The voice."""

from __future__ import annotations

from typing import Final

from kernel.action.call import Act, Bid, Call, Speak, Tick, grounding_function
from kernel.action.verdict import Verdict
from kernel.errors import LimitError, NotGroundedError

LONGEST: Final = 200  # characters


@grounding_function("say", verbs=("say", "tell", "ask"))
def say(call: Call, tick: Tick) -> Act:
    """Say the quoted text, and wait until it has been heard out.

    Raises:
        NotGroundedError: nothing is quoted.
        LimitError: more than 200 characters.
    """
    quoted = call.argument("obj")
    if quoted is None or not quoted.literal:
        raise NotGroundedError(call.verb, "words")
    if len(quoted.literal) > LONGEST:
        raise LimitError(call.verb, f"{LONGEST} characters")
    bid = Bid("voice", Speak(quoted.literal), call.ticket)
    while call.ticket not in tick.spoken:
        yield bid
    return Verdict.SUCCEEDED
