"""Records and replies of the mind as events, fields in the units of the rehearsal."""

from __future__ import annotations

import math

import pytest

from daemon import events
from daemon.telling import from_record, from_reply, pose
from grammars.replies import Said
from kernel.action.call import BodyState
from kernel.action.trace import Record
from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Question
from kernel.memory.reply import Answer, AskKeep, AskWhich, Failed, Forgotten, Halted, Met, Reply
from kernel.net.graphlet import Graphlet, Term


def test_a_pose_is_in_centimetres_degrees_and_permille() -> None:
    state = BodyState(
        x_m=0.2,
        y_m=-0.015,
        heading_rad=math.pi / 2,
        lift=0.5,
        grip=0.25,
        holding=True,
        range_m=0.04,
    )
    assert events.as_dict(pose(1.23456, state)) == {
        "t": 1.235,
        "event": "pose",
        "x_cm": 20.0,
        "y_cm": -1.5,
        "heading_deg": 90.0,
        "lift_permille": 500,
        "grip_permille": 250,
        "holding": True,
        "range_cm": 4.0,
    }


@pytest.mark.parametrize(
    ("record", "event"),
    [
        (
            Record(
                0.0, "action_started", 1, "dance", {"function": "base_turn", "words": ("left",)}
            ),
            events.ActionStarted(t=2.0, function="base_turn", words=("left",), utterance="dance"),
        ),
        (
            Record(0.0, "prohibited", 1, "grab mary", {"by": "never grab", "text": "grab mary"}),
            events.Prohibited(t=2.0, by="never grab", text="grab mary"),
        ),
        (
            Record(0.0, "resource_lost", 1, "", {"resource": "wheels"}),
            events.ResourceLost(t=2.0, resource="wheels"),
        ),
        (
            Record(0.0, "error", 0, "", {"text": "attention is full"}),
            events.Error(t=2.0, part="mind", text="attention is full"),
        ),
        (
            Record(0.0, "sensed", 0, "", {"key": "close", "holds": True}),
            events.Noted(t=2.0, what="sensed", text="key=close holds=True"),
        ),
    ],
)
def test_records(record: Record, event: events.Event) -> None:
    assert from_record(record, 2.0) == event


@pytest.mark.parametrize(
    ("reply", "acknowledged", "ok"),
    [
        (Met("rick"), True, True),
        (Halted(True), True, True),
        (Failed(None, "no_way"), False, False),
        (Answer(Question("yesno", Graphlet((), "hq-1")), "unknown"), False, False),
        (Answer(Question("yesno", Graphlet((), "hq-1")), "no"), False, True),
    ],
)
def test_replies(reply: Reply, acknowledged: bool, ok: bool) -> None:
    told = list(from_reply(reply, Said("shown", "spoken"), 2.0))
    assert [type(event) for event in told[:-1]] == [events.Acknowledged] * acknowledged
    last = told[-1]
    assert isinstance(last, events.Replied)
    assert (last.ok, last.shown, last.spoken) == (ok, "shown", "spoken")


def test_a_question_is_an_event_of_its_own() -> None:
    """And no failure: what was asked for waits."""
    wanted = Graphlet((Term("ako-2", frozenset({"block"}), links=(("ako", "obj-1"),)),), "obj-1")
    told = list(from_reply(AskWhich(wanted, ()), Said("Which block?", "Which block?"), 2.0))
    assert told[0] == events.Question(t=2.0, text="Which block?")
    assert isinstance(told[1], events.Replied)
    assert told[1].ok


def test_what_is_to_be_done_with_a_doubtful_lesson_is_a_question() -> None:
    reply = AskKeep(Lesson(0, "fact", Graphlet((), "obj-1")), "only_itself")
    question, told = from_reply(reply, Said("shown", "spoken"), 2.0)
    assert question == events.Question(t=2.0, text="shown")
    assert isinstance(told, events.Replied)
    assert told.ok


@pytest.mark.parametrize("found", [0, 1])
def test_what_there_was_to_forget_is_acknowledged_and_nothing_is_not(found: int) -> None:
    reply = Forgotten((Lesson(1, "fact", Graphlet((), "obj-1")),) * found)
    told = list(from_reply(reply, Said("shown", "spoken"), 2.0))
    assert [type(event) for event in told[:-1]] == [events.Acknowledged] * found
    last = told[-1]
    assert isinstance(last, events.Replied)
    assert last.ok is bool(found)


def test_event_names_are_those_of_service_md() -> None:
    named = {events.name(kind.__new__(kind)) for kind in events.Event.__subclasses__()}
    internal = {"replied", "ended", "noted"}
    assert named - internal == {
        *("heard", "understood", "not_understood", "acknowledged", "question", "say_started"),
        *("say_ended", "lesson", "retracted", "action_started", "action_ended", "resource_lost"),
        *("prohibited", "stopped", "pose", "link", "error"),
    }
