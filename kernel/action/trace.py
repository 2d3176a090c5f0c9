"""The trace: one typed record for every decision. The log, the view, "why" and the tests read the same records."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

What = Literal[
    "focus",  # a focus was posted: data text
    "directive",  # one was posted: data tag, text, depth (operators it is done within)
    "directive_ended",  # the same, and verdict; of a look-up, each time it is gone back to: found, words of the thing
    "considered",  # operators that matched and their weights; data depth
    "chosen",  # the operator chosen; data depth
    "action_started",  # a grounding function was called: data function, words, text
    "action_ended",  # data function, verdict
    "resource_lost",
    "prohibited",  # data by (words of the lesson), text of the act
    "permitted",
    "verdict",  # a focus ended: data verdict, text
    "lesson",
    "retracted",  # data ident
    "adapted",  # a strength moved: data ident of the lesson, to
    "fact",
    "sensed",
    "concluded",
    "promoted",
    "assumed",  # a thing was taken to exist; data text
    "asked",  # which thing is meant; data text
    "answered",
    "yielded",  # more steps than a tick may take: the focus goes on in the next; data steps
    "stopped",
    "halted",  # one act was stopped while others go on: data text
    "identity",
    "error",
]


@dataclass(frozen=True, slots=True)
class Record:
    """Attributes:
    at_s: monotonic time, s.
    what: the kind of decision.
    focus: number of the focus it belongs to, 0 for none.
    utterance: the words it descends from, "" for the robot's own.
    data: details, plain values only.
    """

    at_s: float
    what: What
    focus: int = 0
    utterance: str = ""
    data: Mapping[str, object] = field(default_factory=dict)
