"""ADD: a lesson is in force, and acknowledged, once it is durable; not before."""

from typing import Any

from kernel.action.call import Travel
from kernel.memory.lesson import Operator
from kernel.memory.meaning import Fact, Teach
from kernel.memory.notation import read
from kernel.memory.reply import FactTaken, Failed, LessonTaken
from kernel.net.graphlet import Graphlet

TO_DANCE = "trig: DO[ act-1 -lex- dance ]\npref: 1.0\n---\nDO[ act-2 -lex- drive ]"
DANCE = "DO[ act-1 -lex- dance ]"


def to_dance() -> Teach:
    content = read(TO_DANCE)
    assert isinstance(content, Operator)
    return Teach("procedure", content)


def test_it_is_not_in_force_before_the_store_has_answered(robot: Any) -> None:
    robot.hear(to_dance(), "to dance drive")
    robot.tick()
    ((_, lesson),) = robot.out.persist
    assert (lesson.ident, lesson.words) == (0, "to dance drive")
    assert robot.mind.policy == ()
    assert robot.replies == []
    robot.tick()
    (taken,) = robot.replies
    assert isinstance(taken, LessonTaken)
    assert robot.mind.policy == (taken.lesson,)
    assert taken.lesson.ident == 1
    assert robot.do(DANCE) == [Travel(0.2, 1.0)]


def test_what_could_not_be_stored_is_not_learned_and_it_says_so(robot: Any) -> None:
    robot.keep = False
    robot.hear(to_dance())
    robot.settle()
    (failed,) = robot.replies
    assert isinstance(failed, Failed)
    assert (failed.reason, failed.detail) == ("not_stored", "disk full")
    assert robot.mind.policy == ()
    assert robot.do(DANCE) == []


def test_a_stop_while_it_is_being_stored_does_not_lose_it(robot: Any) -> None:
    robot.hear(to_dance(), "to dance drive")
    robot.tick()
    robot.stop()
    robot.tick()
    robot.tick()
    assert [lesson.ident for lesson in robot.mind.policy] == [1]
    assert robot.do(DANCE) == [Travel(0.2, 1.0)]


def test_the_teacher_is_remembered(robot: Any) -> None:
    robot.i_am("rick")
    robot.hear(to_dance())
    robot.settle()
    assert robot.mind.policy[-1].teacher == "rick"


def test_what_kind_a_named_one_is_of_is_stored_like_a_lesson(robot: Any) -> None:
    for fact in ("ako-1 -lex- girl; -ako-> obj-2", "hq-1 -lex- tall; -hq-> obj-2"):
        graphlet, mary = (read(text.replace(";", "\n")) for text in (fact, "obj-2 -lex- mary"))
        assert isinstance(graphlet, Graphlet)
        assert isinstance(mary, Graphlet)
        robot.hear(Fact(graphlet, (mary,)), fact)
        robot.settle()
    (kept,) = robot.mind.policy
    assert kept.kind == "fact"


def test_a_stored_fact_is_known_after_a_restart(robot: Any, make_robot: Any) -> None:
    robot.tell("ako-1 -lex- girl; -ako-> obj-2", "obj-2 -lex- mary")
    again = make_robot(robot.mind.policy)
    again.teach(
        "if: ako-1 -lex- girl; -ako-> obj-2; then: ako-3 -lex- person; -ako-> obj-2; belief: 1.0"
    )
    again.teach(
        "trig: ANTE[ act-1 -lex- grab; -obj-> obj-2; ako-3 -lex- person; -ako-> obj-2 ]; pref: 1.0; ---; PUNT[ ]"
    )
    assert again.do("FIND[ obj-2 -lex- mary ]; DO[ act-1 -lex- grab; -obj-> obj-2 ]") == []


def mary_is_a_girl(girl: str, mary: str) -> Fact:
    fact, find = read(f"{girl} -lex- girl\n-ako-> {mary}"), read(f"{mary} -lex- mary")
    assert isinstance(fact, Graphlet)
    assert isinstance(find, Graphlet)
    return Fact(fact, (find,))


def test_a_lasting_fact_is_acknowledged_once_it_is_durable(robot: Any) -> None:
    robot.hear(mary_is_a_girl("ako-1", "obj-2"))
    robot.tick()
    assert robot.out.persist
    assert robot.replies == []
    robot.tick()
    (taken,) = robot.replies
    assert isinstance(taken, FactTaken)


def test_a_fact_told_again_is_stored_once_and_acknowledged_twice(robot: Any) -> None:
    for names in (("ako-1", "obj-2"), ("ako-7", "obj-4")):
        robot.hear(mary_is_a_girl(*names))
        robot.settle()
    assert len(robot.mind.policy) == 1
    assert [type(reply) for reply in robot.replies] == [FactTaken, FactTaken]
