"""What happened, as values: one definition, read by the command line, the demonstration, the rehearsal and the log.

Names and fields are those of `rehearse --json`. `t` is the cycle's time, s. The last three classes are for programs
of this project only and are left out there.
"""

from __future__ import annotations

import re
from dataclasses import asdict, dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Event:
    """Something happened at time t, s."""

    t: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Heard(Event):
    """An utterance arrived. confidence is 1 for typed text."""

    text: str
    speaker: str = ""
    confidence: float = 1.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Understood(Event):
    """It parses. kind: as in language.md; readback: its meaning in English."""

    text: str
    readback: str
    kind: str


@dataclass(frozen=True, slots=True, kw_only=True)
class NotUnderstood(Event):
    """It does not parse, or was not heard well enough; nothing moves. reason: for a person."""

    text: str
    reason: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Acknowledged(Event):
    """A lesson, fact, name or greeting was taken. text: what is shown."""

    text: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Question(Event):
    """The robot asks."""

    text: str


@dataclass(frozen=True, slots=True, kw_only=True)
class SayStarted(Event):
    """The voice begins. told: what it says was told before, as a reply or as what was not understood."""

    text: str
    told: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class SayEnded(Event):
    """The voice is done; cut: stop ended it early."""

    text: str
    cut: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Lesson(Event):
    """A lesson is durable and in force."""

    ident: int
    kind: str
    words: str
    readback: str
    teacher: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Retracted(Event):
    """A lesson is no longer in force."""

    ident: int
    words: str


@dataclass(frozen=True, slots=True, kw_only=True)
class ActionStarted(Event):
    """A grounding function was called. text: the act; words: what with; ticket: names it until its end."""

    function: str
    text: str = ""
    words: tuple[str, ...] = ()
    utterance: str = ""
    ticket: int = 0


@dataclass(frozen=True, slots=True, kw_only=True)
class ActionEnded(Event):
    """It ended. verdict: succeeded, failed, stopped ..."""

    function: str
    verdict: str
    text: str = ""
    utterance: str = ""
    ticket: int = 0


@dataclass(frozen=True, slots=True, kw_only=True)
class ResourceLost(Event):
    """An action lost wheels, lift, grip or voice to another."""

    function: str = ""
    resource: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Prohibited(Event):
    """An act was vetoed. by: the words of the lesson; text: the act."""

    by: str
    text: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Stopped(Event):
    """STOP went to the wire. source: typed, heard, spotted, control, crash ...; epoch: the link's count of stops."""

    source: str
    epoch: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Pose(Event):
    """Where the body reckons it is. x ahead at the start, y to the left, heading counterclockwise."""

    x_cm: float
    y_cm: float
    heading_deg: float
    lift_permille: int
    grip_permille: int
    holding: bool
    range_cm: float | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Link(Event):
    """The link to the body came up or went down."""

    up: bool
    detail: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Error(Event):
    """A part failed; the rest goes on. part: mind, hearing, link, store, voice ..."""

    part: str
    text: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Replied(Event):
    """What the mind told a person. kind: class of the reply; ok: False where an act failed or was refused."""

    kind: str
    shown: str
    spoken: str
    ok: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class Ended(Event):
    """A focus ended: what a command came to."""

    text: str
    verdict: str
    utterance: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Noted(Event):
    """Any other record of the mind's trace, for the log."""

    what: str
    text: str
    utterance: str = ""


INTERNAL = (Replied, Ended, Noted)


def name(event: Event) -> str:
    """The event's name: "say_started".

    >>> name(SayStarted(t=0.0, text="hi"))
    'say_started'
    """
    return re.sub(r"(?<!^)(?=[A-Z])", "_", type(event).__name__).lower()


def as_dict(event: Event) -> dict[str, object]:
    """For JSON: t rounded to ms, event, then the fields."""
    fields = asdict(event)
    return {"t": round(fields.pop("t"), 3), "event": name(event), **fields}
