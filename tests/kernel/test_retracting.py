"""Lessons taken back by number: one durable change, effective only once it is."""

from __future__ import annotations

from typing import Any

from kernel.memory.change import Change
from kernel.memory.meaning import Control

DANCE = """
    trig: DO[ act-1 -lex- dance ]
    pref: 1.0
    ---------------
    DO[ act-2 -lex- drive
        dir-3 -lex- forward
              -dir-> act-2 ]
"""
DANCING = "DO[ act-1 -lex- dance ]"


def test_a_lesson_taken_back_is_known_no_more(robot: Any) -> None:
    lesson = robot.teach(DANCE)
    assert robot.do(DANCING)
    robot.hear(Control("forget", lessons=(lesson.ident,)), "forget 1", "rick")
    robot.settle()
    assert robot.mind.policy == ()
    assert robot.do(DANCING) == []
    assert robot.reasons == ["no_way"]
    (last,) = robot.mind.history[-1:]
    assert last == Change(2, "rick", "forget 1", 0.0, retracted=(lesson.ident,))
    (record,) = robot.records("retracted")
    assert record.data["ident"] == lesson.ident


def test_several_at_once_are_one_change(robot: Any) -> None:
    lessons = [robot.teach(DANCE.replace("dance", verb)).ident for verb in ("zig", "zag", "zog")]
    robot.hear(Control("forget", lessons=(lessons[0], lessons[2], lessons[0])), "forget 1, 3, 1")
    robot.settle()
    assert [lesson.ident for lesson in robot.mind.policy] == [lessons[1]]
    assert robot.mind.history[-1].retracted == (lessons[0], lessons[2])


def test_nothing_counts_that_could_not_be_stored(robot: Any) -> None:
    lesson = robot.teach(DANCE)
    robot.keep = False
    robot.hear(Control("forget", lessons=(lesson.ident,)), "forget 1")
    robot.settle()
    assert robot.mind.policy == (lesson,)
    assert robot.reasons == ["not_stored"]
    assert len(robot.mind.history) == 1


def test_what_it_was_born_with_stays(robot: Any, make_robot: Any, lesson: Any) -> None:
    robot.hear(Control("forget", lessons=(-1_000_000, -1)), "forget")
    robot.settle()
    assert robot.do("DO[ act-1 -lex- drive; dir-2 -lex- forward; -dir-> act-1 ]")
    assert robot.mind.history == ()
