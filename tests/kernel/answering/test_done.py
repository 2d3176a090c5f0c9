"""What are you doing, what did you do, did you, how often, when."""

import pytest

from kernel.memory.explanation import Because, Counted, Moment
from kernel.memory.meaning import Question
from kernel.memory.reply import Answer
from tests.kernel.answering.conftest import DANCE, FORWARD, LEFT, NEVER_GRAB, Questioned
from tests.kernel.conftest import net

ANY = "act-1; -agt-> obj-2; obj-2 -lex- you"
TURN = "act-1 -lex- turn"
TURN_LEFT = "act-1 -lex- turn; -agt-> obj-2; obj-2 -lex- you; dir-3 -lex- left; -dir-> act-1"


def times(robot: Questioned, about: str) -> int:
    reply = robot.asked("howmany", about, "did")
    assert isinstance(reply, Counted)
    return reply.times


def test_doing_nothing_then_something_then_nothing(robot: Questioned) -> None:
    assert robot.asked("what", ANY, "doing").verdict == "unknown"  # type: ignore[union-attr]
    robot.taught("freddy", "to dance ...", DANCE)
    robot.command("DO[ act-1 -lex- dance ]")
    robot.pass_time(0.5)
    robot.hear(Question("what", net(ANY), "", "doing"))
    robot.tick()
    robot.tick()
    (answer,) = [r for r in robot.replies if isinstance(r, Answer)][-1:]
    assert [act.words() for act in answer.found] == [{"dance"}]
    robot.settle()
    assert robot.asked("what", ANY, "doing").verdict == "unknown"  # type: ignore[union-attr]


def test_are_you_turning(robot: Questioned) -> None:
    robot.command(LEFT)
    robot.pass_time(0.3)
    robot.hear(Question("yesno", net(TURN_LEFT)))
    robot.tick()
    robot.tick()
    assert [r.verdict for r in robot.replies if isinstance(r, Answer)] == ["yes"]
    robot.settle()
    robot.hear(Question("yesno", net(TURN_LEFT)))
    robot.settle()
    assert robot.replies[-1].verdict == "no"  # type: ignore[union-attr]


def test_the_newest_whole_deed_is_what_was_just_done(robot: Questioned) -> None:
    assert robot.asked("what", ANY, "did").verdict == "unknown"  # type: ignore[union-attr]
    robot.taught("freddy", "to dance ...", DANCE)
    robot.ordered("mary", "dance", "DO[ act-1 -lex- dance ]")
    reply = robot.asked("what", ANY, "did")
    assert isinstance(reply, Answer)
    assert [act.words() for act in reply.found] == [{"dance"}]


def test_what_came_to_nothing_is_told_with_its_reason(robot: Questioned) -> None:
    robot.ordered("mary", "salute", "DO[ act-1 -lex- salute ]")
    reply = robot.asked("what", ANY, "did")
    assert isinstance(reply, Because)
    assert reply.deed is not None
    assert reply.deed.trouble is not None
    assert reply.deed.trouble.reason == "no_way"


def test_did_you(robot: Questioned) -> None:
    assert robot.asked("yesno", TURN_LEFT, "did").verdict == "no"  # type: ignore[union-attr]
    robot.ordered("mary", "turn left", LEFT)
    assert robot.asked("yesno", TURN_LEFT, "did").verdict == "yes"  # type: ignore[union-attr]
    right = TURN_LEFT.replace("left", "right")
    assert robot.asked("yesno", right, "did").verdict == "no"  # type: ignore[union-attr]


def test_what_was_refused_was_not_done(robot: Questioned) -> None:
    text = NEVER_GRAB.replace(
        "act-1 -lex- grab; -obj-> obj-2; ako-3 -lex- person; -ako-> obj-2", "act-1 -lex- turn"
    )
    robot.taught("freddy", "never turn", text, "prohibition")
    robot.ordered("mary", "turn left", LEFT)
    reply = robot.asked("yesno", TURN_LEFT, "did")
    assert isinstance(reply, Because)
    assert reply.deed is not None
    assert reply.deed.trouble is not None
    assert times(robot, TURN) == 0


@pytest.mark.parametrize(
    ("order", "turns"),
    [
        ("", 0),
        (LEFT, 1),
        (f"{LEFT}; {LEFT.replace('-5', '-7').replace('-6', '-8')}; {FORWARD}", 2),
        (LEFT.replace("-dir-> act-5", "-dir-> act-5; cnt-3 -str- 3; -cnt-> act-5"), 3),
        ("DO[ act-1 -lex- dance ]", 1),
    ],
)
def test_how_many_times(robot: Questioned, order: str, turns: int) -> None:
    robot.taught("freddy", "to dance ...", DANCE)
    if order:
        robot.ordered("mary", "do it", order)
    assert times(robot, TURN) == turns
    assert times(robot, "act-1 -lex- rotate") == turns, "another word for the same"


def test_a_deed_and_its_own_steps_are_one(robot: Questioned) -> None:
    rotate = LEFT.replace("turn", "rotate").replace("-5", "-7").replace("-6", "-8")
    to_turn = f"trig: {LEFT}; pref: 1.0; ---------------; {rotate}"
    robot.taught("freddy", "to turn left rotate left", to_turn)
    robot.ordered("mary", "turn left", LEFT)
    assert times(robot, TURN) == 1


def test_by_an_alias_it_was_done_too(robot: Questioned) -> None:
    alias = "if: dir-1 -lex- widdershins; then: dir-1 -lex- counterclockwise; belief: 1.0"
    robot.taught("rick", "widdershins means counterclockwise", alias, "alias")
    robot.ordered("mary", "turn widdershins", LEFT.replace("left", "widdershins"))
    assert times(robot, TURN_LEFT) == 1


def test_when(robot: Questioned) -> None:
    reply = robot.asked("when", TURN, "did")
    assert isinstance(reply, Moment)
    assert reply.deed is None
    robot.ordered("mary", "turn left", LEFT)
    ordered_s = robot.wall_s
    reply = robot.asked("when", TURN, "did")
    assert isinstance(reply, Moment)
    assert reply.deed is not None
    assert reply.deed.wall_s == pytest.approx(ordered_s, abs=0.1)


def test_of_what_is_no_deed_it_has_no_record(robot: Questioned) -> None:
    see = "act-1 -lex- see; -agt-> obj-2; -obj-> obj-3; obj-2 -lex- you; obj-3 -lex- mary"
    reply = robot.asked("yesno", see, "did")
    assert reply.verdict == "unknown"  # type: ignore[union-attr]
