"""What a session tells whoever holds it: where it stands, and what became of each command."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from firmware_proto.layout import Message
from firmware_proto.messages import Result


class SessionState(Enum):
    """Where a session stands."""

    OPENING = "HELLO has been sent and not been answered yet"
    READY = "the far end answered and may be driven"
    DEGRADED = "no PONG for 300 ms; the far end's lease has ended by now"
    LOST = "no answer for 1 s; this session is over"
    REFUSED = "the far end speaks another protocol or definition; this session is over"


@dataclass(frozen=True, slots=True)
class Settled(Message):
    """What became of a command, told by the session; never on the wire.

    Attributes:
        message: the very object that was handed to send().
        seq: its sequence number, which MOVE_DONE names; None if it was never sent.
        result: the far end's answer; None if there is none (dropped by a stop, refused as older than one, out of
            retries, or the link is down).
        waited_s: from send() until the answered copy left.
    """

    message: Message
    seq: int | None
    result: Result | None
    waited_s: float
