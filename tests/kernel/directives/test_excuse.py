"""EXCUSE: a failure is a fact; what is said about it can be taught."""

from collections.abc import Callable
from typing import Any

import pytest

from kernel.action.call import MoveGrip, Travel
from kernel.memory.reply import Failed, Refused

SALUTE = "DO[ act-1 -lex- salute ]"
GRAB = "FIND[ obj-2; ako-3 -lex- ball; -ako-> obj-2 ]; DO[ act-1 -lex- grab; -obj-> obj-2 ]"
FAIL = "act-1 -lex- fail; -agt-> obj-2; -obj-> act-3; obj-2 -lex- you"
SAY = "DO[ act-7 -lex- say; -obj-> txt-8; txt-8 -str- {} ]"


def when_failing(step: str, more: str = "", pref: float = 1.0) -> str:
    return f"trig: NOTE[ {FAIL}{more} ]; pref: {pref}; ---; {step}"


SORRY = when_failing(SAY.format("sorry"))
OOPS = when_failing(SAY.format("oops"), "; act-3 -lex- grab; -obj-> obj-4")


def test_untaught_it_tells_why(robot: Any) -> None:
    robot.do(SALUTE)
    (reply,) = robot.replies
    assert isinstance(reply, Failed)
    assert reply.reason == "no_way"
    assert reply.act.words() == {"salute"}


def test_it_is_told_in_the_tick_of_the_failure(robot: Any) -> None:
    robot.command(SALUTE)
    robot.tick()
    assert robot.reasons == ["no_way"]
    assert not robot.out.busy


def test_what_was_taught_is_done_instead_always(make_robot: Callable[..., Any]) -> None:
    for seed in range(30):
        robot = make_robot(seed=seed)
        robot.teach(SORRY)
        robot.do(SALUTE)
        assert robot.said == ["sorry"]
        assert robot.reasons == []


def test_the_more_specific_complaint_goes_first(make_robot: Callable[..., Any]) -> None:
    said = []
    for seed in range(20):
        robot = make_robot(seed=seed)
        robot.teach(SORRY)
        robot.teach(OOPS)
        robot.body.within_reach = False
        robot.do(GRAB)
        said += robot.said
        robot.do(SALUTE)
        assert robot.said[1:] == ["sorry"]
    assert said.count("oops") >= 18


def test_a_look_up_that_fails_is_the_failure_of_what_was_commanded(robot: Any) -> None:
    robot.teach(OOPS)
    robot.do("FIND[ obj-2 -ref- it ]; DO[ act-1 -lex- grab; -obj-> obj-2 ]")
    assert robot.said == ["oops"]


def test_the_cause_is_part_of_the_fact(robot: Any) -> None:
    trigger = FAIL.replace("-agt->", "-because-> why-5; -agt->") + "; why-5 -lex- nothing gripped"
    robot.teach(f"trig: NOTE[ {trigger} ]; pref: 1.0; ---; {SAY.format('slippery')}")
    robot.body.within_reach = False
    robot.do(GRAB)
    robot.do(SALUTE)
    assert robot.said == ["slippery"]
    assert robot.reasons == ["no_way"]


def test_it_may_be_more_than_words(robot: Any) -> None:
    robot.teach(when_failing("DO[ act-7 -lex- drive ]"))
    assert robot.do(SALUTE) == [Travel(0.2, 1.0)]


@pytest.mark.parametrize("step", ["DO[ act-7 -lex- twizzle ]", SALUTE.replace("act-1", "act-7")])
def test_a_complaint_that_fails_is_silent_and_the_reason_is_told(robot: Any, step: str) -> None:
    robot.teach(when_failing(step))
    robot.do(SALUTE)
    assert robot.reasons == ["no_way"]
    assert robot.replies[-1].act.words() == {"salute"}


def test_a_complaint_that_fails_is_not_made_twice(robot: Any) -> None:
    robot.teach(when_failing(SAY.format("dear me") + "; DO[ act-11 -lex- twizzle ]"))
    robot.do(SALUTE)
    assert robot.said == ["dear me"]
    assert robot.reasons == ["no_way"]


def test_what_was_refused_in_words_is_not_complained_about(robot: Any) -> None:
    robot.teach(SORRY)
    robot.teach(
        f"trig: ANTE[ act-1 -lex- salute ]; pref: 1.0; ---; {SAY.format('not allowed')}; PUNT[ ]"
    )
    robot.do(SALUTE)
    assert robot.said == ["not allowed"]
    assert robot.reasons == []


def test_a_silent_refusal_is_complained_about(robot: Any) -> None:
    robot.teach("trig: ANTE[ act-1 -lex- salute ]; pref: 1.0; ---; PUNT[ ]")
    robot.do(SALUTE)
    assert isinstance(robot.replies[-1], Refused)
    robot.teach(SORRY)
    robot.do(SALUTE)
    assert robot.said == ["sorry"]
    assert len([r for r in robot.replies if isinstance(r, Refused)]) == 1


def test_what_is_punted_is_said_no_more(robot: Any) -> None:
    """A person may forbid complaining."""
    robot.teach(when_failing("PUNT[ ]"))
    robot.do(SALUTE)
    assert robot.reasons == []
    assert robot.said == []


def test_an_act_that_succeeded_is_no_failure(robot: Any) -> None:
    robot.teach(SORRY)
    assert robot.do(GRAB) == [MoveGrip(0.0)]
    assert robot.said == []


def test_a_stop_is_no_failure(robot: Any) -> None:
    robot.teach(SORRY)
    robot.command("DO[ act-1 -lex- drive ]")
    robot.tick()
    robot.stop()
    robot.settle()
    assert robot.said == []


def test_the_command_has_failed_whatever_is_said_about_it(robot: Any) -> None:
    robot.teach(SORRY)
    robot.do(SALUTE)
    assert [r.data["verdict"] for r in robot.records("verdict") if r.utterance][-1] == "failed"


def test_outside_a_failure_there_is_nothing_to_excuse(robot: Any) -> None:
    robot.do("EXCUSE[ act-1 -lex- fail ]")
    assert robot.replies[-1].reason == "no_way"
