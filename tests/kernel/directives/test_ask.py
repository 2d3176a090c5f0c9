"""ASK: a question is answered from memory; not knowing is an answer."""

from typing import Any

import pytest

from kernel.memory.meaning import Question
from kernel.memory.notation import read
from kernel.memory.reply import Answer
from kernel.net.graphlet import Graphlet

TALL = "hq-1 -lex- tall\n{}-hq-> obj-2\nobj-2 -lex- mary"


def ask(robot: Any, question: Question) -> Answer:
    robot.hear(question)
    robot.settle()
    reply = robot.replies[-1]
    assert isinstance(reply, Answer)
    return reply


def graphlet(text: str) -> Graphlet:
    content = read(text)
    assert isinstance(content, Graphlet)
    return content


@pytest.mark.parametrize(
    ("told", "asked", "verdict"),
    [
        (None, "", "unknown"),
        ("", "", "yes"),
        ("-neg- yes; ", "", "no"),
        ("", "-neg- yes\n", "no"),
        ("-neg- yes; ", "-neg- yes\n", "yes"),
    ],
)
def test_yes_no_and_i_do_not_know(robot: Any, told: str | None, asked: str, verdict: str) -> None:
    if told is not None:
        robot.tell(f"hq-1 -lex- tall; {told}-hq-> obj-2", "obj-2 -lex- mary")
    assert ask(robot, Question("yesno", graphlet(TALL.format(asked)))).verdict == verdict


def test_what_is_asked_for_is_described(robot: Any) -> None:
    robot.tell("hq-1 -lex- tall; -hq-> obj-2", "obj-2 -lex- mary")
    answer = ask(robot, Question("who", graphlet("hq-1 -lex- tall\n-hq-> obj-2"), "obj-2"))
    assert answer.verdict == "found"
    assert "mary" in answer.found[0].words()
    assert (
        ask(robot, Question("who", graphlet("hq-1 -lex- red\n-hq-> obj-2"), "obj-2")).verdict
        == "unknown"
    )


def test_what_was_told_long_ago_is_remembered_and_concluded_from(robot: Any) -> None:
    robot.teach(
        "if: ako-1 -lex- giant; -ako-> obj-2; then: hq-3 -lex- tall; -hq-> obj-2; belief: 1.0"
    )
    robot.tell("ako-1 -lex- giant; -ako-> obj-2", "obj-2 -lex- mary")
    robot.pass_time(60)
    assert ask(robot, Question("who", graphlet("ako-1 -lex- giant\n-ako-> obj-2"), "obj-2")).found
    robot.pass_time(60)
    assert ask(robot, Question("yesno", graphlet(TALL.format("")))).verdict == "yes"


def test_who_am_i(robot: Any) -> None:
    who = Question("who", graphlet("obj-1 -lex- me"), "obj-1", topic="identity")
    assert ask(robot, who).verdict == "unknown"
    robot.i_am("rick")
    answer = ask(robot, who)
    assert answer.verdict == "found"
    assert "rick" in answer.found[0].words()


def test_asking_changes_nothing(robot: Any) -> None:
    for _ in range(2):
        assert ask(robot, Question("yesno", graphlet(TALL.format("")))).verdict == "unknown"


# -- finding out first ---------------------------------------------------------------------

FIND_COLOR = """
    trig: FIND[ hq-1 -hq-> obj-2; ako-3 -lex- color; -ako-> hq-1 ]; pref: 1.0; ---;
    DO[ act-7 -lex- say; -obj-> txt-8; txt-8 -str- let me see ]
    NOTE[ hq-5 -lex- red; -hq-> obj-2 ]
"""
COLOR = "hq-1 -hq-> obj-2\nobj-2 -ref- the\nako-3 -lex- block\n-ako-> obj-2\nako-4 -lex- color\n-ako-> hq-1"


def test_whether_it_is_so_is_found_out_before_it_is_answered(robot: Any) -> None:
    robot.teach(
        "trig: CHK[ hq-1 -lex- tall; -hq-> obj-2 ]; pref: 1.0; ---; NOTE[ hq-3 -lex- tall; -hq-> obj-2 ]"
    )
    robot.tell("ako-1 -lex- girl; -ako-> obj-2", "obj-2 -lex- mary")
    assert ask(robot, Question("yesno", graphlet(TALL.format("")))).verdict == "yes"


def test_what_it_is_like_is_found_out_before_it_is_answered(robot: Any) -> None:
    robot.tell("ako-1 -lex- color; -ako-> obj-2", "obj-2 -lex- red")
    robot.tell("ako-1 -lex- block; -ako-> obj-2")
    question = Question("what", graphlet(COLOR), "hq-1")
    assert ask(robot, question).verdict == "unknown"
    robot.teach(FIND_COLOR)
    answer = ask(robot, question)
    assert answer.verdict == "found"
    assert "red" in answer.found[0].words()
    assert robot.said == ["let me see"]
    assert ask(robot, question).verdict == "found"  # now memory has it
    assert robot.said == ["let me see"]


def test_what_cannot_be_found_out_is_not_known(robot: Any) -> None:
    robot.teach(
        "trig: CHK[ hq-1 -lex- tall; -hq-> obj-2 ]; pref: 1.0; ---; DO[ act-7 -lex- twizzle ]"
    )
    assert ask(robot, Question("yesno", graphlet(TALL.format("")))).verdict == "unknown"
    assert robot.reasons == []


def test_it_is_looked_into_until_it_is_known(make_robot: Any) -> None:
    for seed in range(4):
        robot = make_robot(seed=seed)
        for number in (1, 2):
            robot.teach(
                "trig: CHK[ hq-1 -lex- tall; -hq-> obj-2 ]; pref: 1.0; ---;"
                f"DO[ act-7 -lex- say; -obj-> txt-8; txt-8 -str- way {number} ];"
                "NOTE[ hq-3 -lex- tall; -hq-> obj-2 ]"
            )
        robot.tell("ako-1 -lex- girl; -ako-> obj-2", "obj-2 -lex- mary")
        assert ask(robot, Question("yesno", graphlet(TALL.format("")))).verdict == "yes"
        assert len(robot.said) == 1
