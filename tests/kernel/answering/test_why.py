"""Why did you, why are you, why didn't you."""

import pytest

from kernel.action.verdict import Verdict
from kernel.memory.explanation import Because, Taught
from kernel.memory.meaning import Question
from tests.kernel.answering.conftest import (
    BACK_OFF,
    DANCE,
    FORWARD,
    GRAB_MARY,
    LEFT,
    NEVER_GRAB,
    Questioned,
)
from tests.kernel.conftest import net

THAT = "act-1 -ref- that"
TURN = "act-1 -lex- turn"
NOT_GRAB = "act-1 -lex- grab; -neg- yes; -obj-> obj-2; obj-2 -lex- mary"


def why(robot: Questioned, about: str) -> Because:
    reply = robot.asked("why", about, "did")
    assert isinstance(reply, Because)
    return reply


def test_a_reaction_is_explained_by_its_fact_and_its_teacher(robot: Questioned) -> None:
    robot.taught("freddy", "if something is very close then drive backwards", BACK_OFF, "reaction")
    robot.feel(range_m=0.04)
    robot.settle()
    deed = why(robot, THAT).deed
    assert deed is not None
    assert deed.occasion is not None
    assert deed.occasion.lesson.teacher == "freddy"
    assert deed.occasion.lesson.words == "if something is very close then drive backwards"
    assert {"very", "close"} <= deed.occasion.fact.words()
    assert deed.source is None
    assert "backward" in deed.act.words()


def test_a_command_is_explained_by_who_gave_it(robot: Questioned) -> None:
    robot.ordered("mary", "turn left", LEFT)
    reply = why(robot, TURN)
    assert reply.deed is not None
    assert reply.deed is reply.root
    assert reply.deed.source is not None
    assert (reply.deed.source.teacher, reply.deed.source.words) == ("mary", "turn left")
    assert reply.deed.wall_s == pytest.approx(robot.wall_s - 60, abs=1.0)


def test_a_step_is_explained_by_the_command_and_the_procedure(robot: Questioned) -> None:
    robot.taught("freddy", "to dance drive forward then turn left", DANCE)
    robot.ordered("mary", "dance", "DO[ act-1 -lex- dance ]")
    reply = why(robot, TURN)
    assert reply.root is not None
    assert reply.root.act.words() == {"dance"}
    assert reply.deed is not None
    assert [lesson.teacher for lesson in reply.deed.within] == ["freddy"]


def test_what_is_going_on_can_be_asked_about(robot: Questioned) -> None:
    robot.command(LEFT, "mary")
    robot.pass_time(0.3)
    reply = why(robot, TURN)
    assert reply.deed is not None
    assert reply.deed.going_on


def test_a_refusal_is_explained_by_the_prohibition_and_the_inference(robot: Questioned) -> None:
    robot.taught("freddy", "never grab a person", NEVER_GRAB, "prohibition")
    robot.rule("janey", "girl", "child")
    robot.rule("rick", "child", "person")
    robot.told_kind("john", "mary", "girl")
    robot.ordered("john", "grab mary", GRAB_MARY)
    assert robot.moved == []
    for about in (NOT_GRAB, THAT, "act-1 -ref- that; -neg- yes"):
        deed = why(robot, about).deed
        assert deed is not None
        assert deed.verdict is Verdict.FAILED
        assert deed.trouble is not None
        assert deed.trouble.by is not None
        assert deed.trouble.by.words == "never grab a person"
        assert [step.lesson.teacher for step in deed.trouble.steps] == ["janey", "rick"]
        assert [fact.words() for step in deed.trouble.steps for fact in step.told] == [
            {"girl", "mary"}
        ]


def test_an_alias_is_part_of_the_inference(robot: Questioned) -> None:
    robot.taught("freddy", "never grab a person", NEVER_GRAB, "prohibition")
    robot.rule("janey", "girl", "person")
    alias = "if: ako-1 -lex- lass; then: ako-1 -lex- girl; belief: 1.0"
    robot.taught("rick", "lass means girl", alias, "alias")
    robot.told_kind("john", "mary", "lass")
    robot.ordered("john", "grab mary", GRAB_MARY)
    deed = why(robot, NOT_GRAB).deed
    assert deed is not None
    assert deed.trouble is not None
    assert {step.lesson.words for step in deed.trouble.steps} == {
        "lass means girl",
        "a girl is a person",
    }


def test_an_alias_of_the_verb_too(robot: Questioned) -> None:
    robot.taught("freddy", "never grab a person", NEVER_GRAB, "prohibition")
    alias = "if: act-1 -lex- seize; then: act-1 -lex- grab; belief: 1.0"
    robot.taught("rick", "seize means grab", alias, "alias")
    robot.told_kind("john", "mary", "person")
    robot.ordered("john", "seize mary", GRAB_MARY.replace("grab", "seize"))
    deed = why(robot, NOT_GRAB).deed
    assert deed is not None
    assert deed.trouble is not None
    assert [step.lesson.words for step in deed.trouble.steps] == ["seize means grab"]


@pytest.mark.parametrize(
    ("order", "about", "reason"),
    [
        ("DO[ act-1 -lex- salute ]", "act-1 -lex- salute; -neg- yes", "no_way"),
        (
            "FIND[ obj-1 -ref- it ]; DO[ act-2 -lex- grab; -obj-> obj-1 ]",
            "act-1 -lex- grab; -neg- yes",
            "nothing_found",
        ),
        (
            FORWARD.replace(
                "-dir-> act-1", "-dir-> act-1; amt-3 -lex- meter; -str- 3; -amt-> act-1"
            ),
            "act-1 -lex- drive; -neg- yes",
            "too_much",
        ),
    ],
)
def test_a_failure_is_explained_by_its_reason(
    robot: Questioned, order: str, about: str, reason: str
) -> None:
    robot.ordered("mary", "do it", order)
    deed = why(robot, about).deed
    assert deed is not None
    assert deed.trouble is not None
    assert deed.trouble.reason == reason


def test_what_a_stop_cut_off_and_what_it_kept_from_beginning(robot: Questioned) -> None:
    robot.command(f"{FORWARD}; {LEFT}", "mary")
    robot.pass_time(0.3)
    robot.stop()
    robot.settle()
    for about, began in (("act-1 -lex- drive; -neg- yes", True), (f"{TURN}; -neg- yes", False)):
        deed = why(robot, about).deed
        assert deed is not None
        assert deed.trouble is not None
        assert deed.trouble.reason == "stopped"
        assert (deed.ended_s != deed.began_s) is began


def test_never_told_but_it_would_be_forbidden(robot: Questioned) -> None:
    robot.taught("freddy", "never grab a person", NEVER_GRAB, "prohibition")
    robot.told_kind("john", "mary", "person")
    reply = why(robot, NOT_GRAB)
    assert reply.deed is None
    assert reply.trouble is not None
    assert reply.trouble.by is not None
    assert reply.trouble.by.teacher == "freddy"
    assert robot.moved == []


def test_never_told_and_nothing_in_the_way(robot: Questioned) -> None:
    reply = why(robot, f"{TURN}; -neg- yes")
    assert (reply.deed, reply.trouble) == (None, None)


def test_it_did_after_all(robot: Questioned) -> None:
    robot.ordered("mary", "turn left", LEFT)
    deed = why(robot, f"{TURN}; -neg- yes").deed
    assert deed is not None
    assert deed.done


def test_a_fact_has_a_source_instead(robot: Questioned) -> None:
    robot.rule("janey", "girl", "person")
    robot.told_kind("john", "mary", "girl")
    reply = robot.asked("why", "ako-1 -lex- person; -ako-> obj-2; obj-2 -lex- mary", "taught")
    assert isinstance(reply, Taught)
    assert [step.lesson.teacher for step in reply.steps] == ["janey"]


def test_a_reaction_is_nobodys_order_whoever_told_the_fact(robot: Questioned) -> None:
    react = BACK_OFF.replace("close", "near").split("; ---")[0]
    robot.taught("mary", "to dance ...", DANCE)
    dance = "---------------; DO[ act-4 -lex- dance ]"
    robot.taught("freddy", "if something is very near then dance", f"{react}; {dance}", "reaction")
    robot.told(
        "rick",
        "mary is very near",
        "hq-1 -lex- near; -hq-> obj-2; deg-3 -lex- very; -deg-> hq-1",
        "obj-2 -lex- mary",
    )
    reply = why(robot, TURN)
    for deed in (reply.deed, reply.root):
        assert deed is not None
        assert deed.source is None
        assert deed.occasion is not None, "steps of a reaction have its occasion"
        assert deed.occasion.lesson.teacher == "freddy"
    assert reply.root is not None
    assert reply.root.act.words() == {"dance"}


def test_why_not_is_about_what_came_to_nothing_and_why_about_the_newest(robot: Questioned) -> None:
    robot.ordered("mary", "salute", "DO[ act-1 -lex- salute ]")
    robot.ordered("rick", "turn left", LEFT)
    refused, newest = why(robot, f"{THAT}; -neg- yes").deed, why(robot, THAT).deed
    assert refused is not None
    assert newest is not None
    assert (refused.act.words(), newest.act.words()) == ({"salute"}, {"turn", "left"})


def test_what_is_going_on_comes_before_what_is_newer(robot: Questioned) -> None:
    wait = "DO[ act-1 -lex- wait; amt-2 -lex- second; -str- {}; -amt-> act-1 ]"
    robot.command(wait.format(5), "mary")
    robot.pass_time(0.5)
    robot.command(wait.format("0.1"), "rick")
    robot.pass_time(0.5)
    robot.hear(Question("why", net("act-1 -lex- wait"), topic="did"))
    robot.tick()
    robot.tick()
    (reply,) = [reply for reply in robot.replies if isinstance(reply, Because)]
    assert reply.deed is not None
    assert reply.deed.source is not None
    assert reply.deed.source.teacher == "mary"
