"""The log: utterances and changes in one order."""

from __future__ import annotations

from daemon.logbook import Entry, entries
from grammars.parse import parse
from kernel.memory.change import Adapted, Change
from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Teach


def zorp() -> Lesson:
    meaning = parse("to zorp, turn left").meaning
    assert isinstance(meaning, Teach)
    return Lesson(1, meaning.kind, meaning.content, "to zorp turn left", "mary", 10.0)


SAID = [
    (10.0, "to zorp turn left", "Mary", "typed", "procedure"),
    (20.0, "zorp", "", "heard", "command"),
    (40.0, "undo that", "Rick", "typed", "control"),
]
CHANGES = [
    Change(1, "mary", "to zorp turn left", 10.0, (zorp(),)),
    Change(2, "rick", "forget 1", 30.0, retracted=(1,)),
    Change(3, "", "", 35.0, adapted=(Adapted(1, 1.0, 0.5),), own=True),
    Change(4, "rick", "undo that", 40.0, undone=(2,)),
]


def test_utterances_and_changes_in_order_of_time() -> None:
    text = "to zorp, turn left"
    assert entries(SAID, CHANGES, 20) == (
        Entry(at_s=10.0, what="said", who="Mary", text="to zorp turn left", kind="procedure", source="typed"),
        Entry(at_s=10.0, what="learned", who="mary", text=text, kind="procedure", lesson=1),
        Entry(at_s=20.0, what="said", text="zorp", kind="command", source="heard"),
        Entry(at_s=30.0, what="retracted", who="rick", text=text, kind="procedure", lesson=1),
        Entry(at_s=35.0, what="adapted", text=text, kind="procedure", lesson=1, before=1.0, after=0.5),
        Entry(at_s=40.0, what="said", who="Rick", text="undo that", kind="control", source="typed"),
        Entry(at_s=40.0, what="undone", who="rick", text="forget 1"),
    )  # fmt: skip


def test_only_the_last_ones() -> None:
    assert [e.what for e in entries(SAID, CHANGES, 2)] == ["said", "undone"]
    assert entries([], [], 5) == ()


def test_lessons_that_rest_are_told_by_number() -> None:
    (entry,) = entries([], [Change(1, "rick", at_s=1.0, retracted=(7,))], 5)
    assert (entry.lesson, entry.text) == (7, "")
