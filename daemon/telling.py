"""From what the mind decided to events: pure translations."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Final

from daemon import events
from grammars.render import render
from grammars.replies import Said
from kernel.action.call import BodyState
from kernel.action.trace import Record
from kernel.memory.policy import Shift
from kernel.memory.reply import (
    Answer,
    AskKeep,
    AskWhich,
    Dropped,
    FactTaken,
    Failed,
    FeedbackTaken,
    Forgotten,
    Greeted,
    Halted,
    KnownAlready,
    LessonDropped,
    LessonTaken,
    Met,
    NothingToDo,
    Refused,
    Reply,
    Resumed,
    Revised,
    TakenBack,
)

ACKNOWLEDGES: Final = (
    LessonTaken,
    FactTaken,
    Met,
    Greeted,
    Halted,
    Dropped,
    Resumed,
    KnownAlready,
    LessonDropped,
    Revised,
    Forgotten,
    TakenBack,
    FeedbackTaken,
)
GOES_WRONG: Final = (Refused, Failed, NothingToDo)


def from_record(record: Record, now_s: float) -> events.Event:
    """The event of one trace record."""
    data = record.data
    text = str(data.get("text", ""))
    match record.what:
        case "action_started":
            words = data.get("words", ())
            return events.ActionStarted(
                t=now_s,
                function=str(data.get("function", "")),
                text=text,
                words=tuple(map(str, words)) if isinstance(words, tuple | list) else (str(words),),
                utterance=record.utterance,
                ticket=_number(data.get("ticket")),
            )
        case "action_ended":
            return events.ActionEnded(
                t=now_s,
                function=str(data.get("function", "")),
                verdict=str(data.get("verdict", "")),
                text=text,
                utterance=record.utterance,
                ticket=_number(data.get("ticket")),
            )
        case "resource_lost":
            return events.ResourceLost(
                t=now_s,
                function=str(data.get("function", "")),
                resource=str(data.get("resource", "")),
            )
        case "prohibited":
            return events.Prohibited(t=now_s, by=str(data.get("by", "")), text=text)
        case "verdict":
            return events.Ended(
                t=now_s,
                text=text,
                verdict=str(data.get("verdict", "")),
                utterance=record.utterance,
            )
        case "error":
            return events.Error(t=now_s, part="mind", text=text)
        case what:
            shown = " ".join(f"{key}={value}" for key, value in data.items())
            return events.Noted(t=now_s, what=what, text=shown, utterance=record.utterance)


def from_shift(shift: Shift, now_s: float) -> Iterator[events.Event]:
    """The events of lessons that came into force and of lessons that went."""
    for lesson in shift.entered:
        yield events.Lesson(
            t=now_s,
            ident=lesson.ident,
            kind=lesson.kind,
            words=lesson.words,
            readback=render(lesson.content, "teacher"),
            teacher=lesson.teacher,
        )
    for lesson in shift.left:
        words = lesson.words or render(lesson.content, "teacher")
        yield events.Retracted(t=now_s, ident=lesson.ident, words=words)


def from_reply(reply: Reply, said: Said, now_s: float) -> Iterator[events.Event]:
    """The events of one reply: an acknowledgement where something was taken, a question where one was put, and always
    the reply itself."""
    if isinstance(reply, ACKNOWLEDGES) and not _in_vain(reply):
        yield events.Acknowledged(t=now_s, text=said.shown)
    if isinstance(reply, AskKeep | AskWhich):
        yield events.Question(t=now_s, text=said.shown)
    yield events.Replied(
        t=now_s,
        kind=type(reply).__name__,
        shown=said.shown,
        spoken=said.spoken,
        ok=not isinstance(reply, GOES_WRONG) and not _unanswered(reply) and not _in_vain(reply),
    )


def pose(now_s: float, state: BodyState) -> events.Pose:
    """The body's report in the units of the rehearsal."""
    return events.Pose(
        t=now_s,
        x_cm=round(state.x_m * 100, 1),
        y_cm=round(state.y_m * 100, 1),
        heading_deg=round(math.degrees(state.heading_rad), 1),
        lift_permille=round(state.lift * 1000),
        grip_permille=round(state.grip * 1000),
        holding=state.holding,
        range_cm=None if state.range_m is None else round(state.range_m * 100, 1),
    )


def _unanswered(reply: Reply) -> bool:
    return isinstance(reply, Answer) and reply.verdict == "unknown"


def _in_vain(reply: Reply) -> bool:
    """There was nothing to forget."""
    return isinstance(reply, Forgotten) and not (reply.lessons or reply.resting)


def _number(value: object) -> int:
    return value if isinstance(value, int) else 0
