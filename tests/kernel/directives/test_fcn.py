"""FCN: the bridge to the body; what goes wrong there is explained."""

from typing import Any

import pytest

from kernel.action.call import Travel


def fcn(name: str) -> str:
    return f"FCN[ fcn-1 -lex- {name}; -arg-> act-2; act-2 -lex- drive; dir-3 -lex- backward; -dir-> act-2 ]"


def test_the_function_is_called_on_the_act_and_its_words(robot: Any) -> None:
    assert robot.do(fcn("base_drive")) == [Travel(-0.2, 1.0)]
    (record,) = robot.records("action_started")
    assert record.data["function"] == "base_drive"
    assert record.data["words"] == ("drive", "backward")


def test_its_verdict_is_the_directives(robot: Any) -> None:
    robot.body.within_reach = False
    robot.do("DO[ act-1 -lex- grab ]; DO[ act-2 -lex- drive ]")
    assert robot.records("action_ended")[-1].data["verdict"] == "failed"
    assert not any(isinstance(command, Travel) for command in robot.moved)


def test_a_function_that_is_not_there_fails(robot: Any) -> None:
    robot.do(fcn("teleport"))
    assert robot.reasons == ["no_way"]


@pytest.mark.parametrize(
    ("command", "reason", "detail"),
    [
        ("DO[ act-1 -lex- turn; dir-2 -lex- widdershins; -dir-> act-1 ]", "not_grounded", "widdershins"),
        ("DO[ act-1 -lex- turn ]", "not_grounded", "direction"),
        ("DO[ act-1 -lex- drive; amt-2 -lex- meter; -str- 3; -amt-> act-1 ]", "too_much", "2 meters"),
        ("DO[ act-1 -lex- drive; amt-2 -lex- meter; -str- ten; -amt-> act-1 ]", "not_grounded", "ten"),
        ("DO[ act-1 -lex- find ]", "no_sense", "find"),
        ("DO[ act-1 -lex- say ]", "not_grounded", "words"),
    ],
)  # fmt: skip
def test_its_errors_are_explained(robot: Any, command: str, reason: str, detail: str) -> None:
    robot.do(command)
    (failed,) = robot.replies
    assert (failed.reason, failed.detail) == (reason, detail)
    assert failed.act is not None
    assert robot.moved == []


def test_the_bodys_failures_are_explained(robot: Any) -> None:
    robot.body.within_reach = False
    robot.do("DO[ act-1 -lex- grab ]")
    robot.feel(connected=False)
    robot.do("DO[ act-1 -lex- drive ]")
    assert robot.reasons == ["nothing_gripped", "link_lost"]


def test_another_way_is_tried_where_the_body_fails(robot: Any) -> None:
    robot.body.within_reach = False
    robot.teach("trig: DO[ act-1 -lex- grab ]; pref: 0.2; ---; DO[ act-2 -lex- drive ]")
    robot.do("DO[ act-1 -lex- grab ]")
    assert Travel(0.2, 1.0) in robot.moved
    assert robot.reasons == []
