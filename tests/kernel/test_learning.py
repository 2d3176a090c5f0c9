"""Taking lessons: what is known already, what is doubtful, who may teach, whom a veto or a permission is about."""

from typing import Any

import pytest

from kernel.action.call import MoveGrip, Rotate, Travel
from kernel.memory.lesson import Operator, Rule
from kernel.memory.meaning import (
    Command,
    Control,
    Fact,
    Feedback,
    Heard,
    Identity,
    Question,
    Revision,
    Teach,
    Utterance,
)
from kernel.memory.notation import read
from kernel.memory.reply import (
    Answer,
    AskKeep,
    FactTaken,
    FeedbackTaken,
    KnownAlready,
    LessonDropped,
    LessonTaken,
    NothingToDo,
    Refused,
    Revised,
)
from tests.kernel.conftest import Robot, chain, net, notation

FORWARD = "DO[ act-1 -lex- drive; dir-2 -lex- forward; -dir-> act-1 ]"
TO_DANCE = "trig: DO[ act-1 -lex- dance ]; pref: {}; ---; DO[ act-2 -lex- drive ]"
RECURSIVE = "trig: DO[ act-1 -lex- dance ]; pref: 1.0; ---; DO[ act-2 -lex- dance ]"
GIRLS = "if: ako-1 -lex- girl; -ako-> obj-2; then: ako-3 -lex- person; -ako-> obj-2; belief: 1.0"
NO_GIRLS = GIRLS.replace("person", "person; -neg- yes")
GIRL = "ako-1 -lex- girl; -ako-> obj-2"
MARY = "obj-2 -lex- mary"


def say(robot: Robot, text: str, speaker: str = "") -> list[Any]:
    """Teach it, answering nothing; the replies."""
    content = read(notation(text))
    assert isinstance(content, Rule | Operator)
    before = len(robot.replies)
    kind: Any = "rule" if isinstance(content, Rule) else "procedure"
    robot.hear(Teach(kind, content), text, speaker)
    robot.settle()
    return robot.replies[before:]


def answer(robot: Robot, act: Any) -> list[Any]:
    before = len(robot.replies)
    robot.hear(Control(act))
    robot.settle()
    return robot.replies[before:]


# -- repetition ----------------------------------------------------------------------------


def test_a_lesson_told_again_is_known_already_and_stored_once(robot: Robot) -> None:
    (taken,) = say(robot, TO_DANCE.format(1.0), "mary")
    again = TO_DANCE.format(1.0).replace("act-1", "act-8").replace("act-2", "act-3")
    assert say(robot, again, "john") == [KnownAlready(taken.lesson)]
    assert len(robot.mind.policy) == 1


def test_told_again_in_another_strength_it_takes_the_place_of_the_old_one(robot: Robot) -> None:
    say(robot, TO_DANCE.format(1.0))
    (revised,) = say(robot, TO_DANCE.format(1.2))
    assert isinstance(revised, Revised)
    (lesson,) = robot.mind.policy
    assert lesson.strength == 1.2
    robot.hear(Control("undo"))
    robot.settle()
    assert [lesson.strength for lesson in robot.mind.policy] == [1.0]


def test_what_was_forgotten_can_be_taught_again(robot: Robot) -> None:
    say(robot, TO_DANCE.format(1.0))
    answer(robot, "forget")
    (taken,) = say(robot, TO_DANCE.format(1.0))
    assert isinstance(taken, LessonTaken)


# -- the open question ---------------------------------------------------------------------


def test_a_contradiction_is_asked_about_and_nothing_is_stored_meanwhile(robot: Robot) -> None:
    (old,) = say(robot, GIRLS)
    (asked,) = say(robot, NO_GIRLS)
    assert isinstance(asked, AskKeep)
    assert (asked.why, asked.other) == ("contradicts", old.lesson)
    robot.pass_time(5)
    assert robot.mind.policy == (old.lesson,)
    assert not robot.out.busy


@pytest.mark.parametrize(
    ("act", "kept", "replied"),
    [
        ("keep", [False, True], LessonTaken),
        ("replace", [True], Revised),
        ("cancel", [False], LessonDropped),
    ],
)
def test_each_answer(robot: Robot, act: str, kept: list[bool], replied: type) -> None:
    say(robot, GIRLS)
    say(robot, NO_GIRLS)
    (reply,) = answer(robot, act)
    assert isinstance(reply, replied)
    rules = [lesson.content for lesson in robot.mind.policy]
    assert [r.conclusion.terms[0].negated for r in rules if isinstance(r, Rule)] == kept
    assert answer(robot, "keep") == [NothingToDo("answer")]


@pytest.mark.parametrize("how", ["time", "another utterance"])
def test_without_an_answer_both_are_kept(robot: Robot, how: str) -> None:
    say(robot, GIRLS)
    say(robot, NO_GIRLS)
    if how == "time":
        robot.pass_time(29)
        assert len(robot.mind.policy) == 1
        robot.pass_time(2)
    else:
        assert robot.do(FORWARD) == [Travel(0.2, 1.0)]
    assert len(robot.mind.policy) == 2


def test_a_stop_closes_the_question_and_nothing_is_kept(robot: Robot) -> None:
    say(robot, GIRLS)
    say(robot, NO_GIRLS)
    robot.stop()
    robot.settle()
    assert len(robot.mind.policy) == 1
    assert answer(robot, "keep") == [NothingToDo("answer")]
    robot.pass_time(40)
    assert len(robot.mind.policy) == 1


def test_what_can_never_come_to_anything_is_asked_about(robot: Robot) -> None:
    (asked,) = say(robot, RECURSIVE)
    assert isinstance(asked, AskKeep)
    assert (asked.why, asked.other) == ("only_itself", None)
    assert [type(r) for r in answer(robot, "cancel")] == [LessonDropped]
    assert robot.mind.policy == ()


# -- facts ---------------------------------------------------------------------------------


def test_a_fact_of_the_session_is_no_lesson_and_is_not_stored(robot: Robot) -> None:
    robot.tell("hq-1 -lex- tall; -hq-> obj-2", MARY)
    assert isinstance(robot.replies[-1], FactTaken)
    assert robot.mind.policy == ()
    assert robot.out.shift.entered == ()


def test_facts_of_a_session_are_bounded_and_what_is_lost_is_lost_whole(
    robot: Robot, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in ("kernel.commons", "kernel.memory.working"):
        monkeypatch.setattr(f"{module}.TOLD_LIMIT", 20)
    for number in range(60):
        robot.tell(f"hq-1 -lex- q{number}; -hq-> obj-2", MARY)
    commons = robot.mind._commons
    assert len(commons.sayings) == len(commons.facts) == 20
    assert len(list(commons.policy.changes())) == 20
    assert not robot.believes("hq-1 -lex- q5", depth=3)
    assert robot.believes("hq-1 -lex- q59", depth=3)


def test_a_lasting_fact_that_memory_had_lost_is_stored_once(
    robot: Robot, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("kernel.memory.working.TOLD_LIMIT", 5)
    robot.tell(GIRL, MARY)
    for number in range(10):
        robot.tell(f"hq-1 -lex- q{number}; -hq-> obj-2", "obj-2 -lex- john")
    assert not robot.believes(f"{GIRL}; {MARY}", depth=3)
    robot.tell(GIRL, MARY)
    assert robot.believes(f"{GIRL}; {MARY}", depth=3)
    assert len(robot.mind.policy) == 1
    robot.hear(Control("forget", told=Fact(net(GIRL), (net(MARY),))))
    robot.settle()
    assert not robot.believes(f"{GIRL}; {MARY}", depth=3)


# -- teaching may be forbidden -------------------------------------------------------------

BY_RICK = (
    "act-5 -lex- tell; -agt-> obj-6; -cmd-> act-1; -dest-> obj-7; obj-6 -lex- rick; obj-7 -lex- you"
)
NO_LESSONS = f"trig: ANTE[ act-1 -lex- learn; {BY_RICK} ]; pref: 1.0; ---; PUNT[ ]"
NO_ORDERS = f"trig: ANTE[ act-1; {BY_RICK} ]; pref: 1.0; ---; PUNT[ ]"


@pytest.mark.parametrize(("speaker", "learned"), [("rick", False), ("mary", True), ("", True)])
def test_teaching_may_be_forbidden_to_a_person(robot: Robot, speaker: str, learned: bool) -> None:
    robot.teach(NO_LESSONS)
    before = len(robot.mind.policy)
    robot.i_am(speaker)
    reply = say(robot, TO_DANCE.format(1.0), speaker)[-1]
    assert isinstance(reply, LessonTaken if learned else Refused)
    robot.tell("hq-1 -lex- tall; -hq-> obj-2", MARY, speaker=speaker)
    assert robot.believes("hq-1 -lex- tall; -hq-> obj-2", depth=3) is learned
    assert (len(robot.mind.policy) > before) is learned
    assert robot.do(FORWARD, speaker) == [Travel(0.2, 1.0)], "only teaching is forbidden"


def test_a_veto_on_all_his_orders_is_none_on_what_he_teaches(robot: Robot) -> None:
    robot.teach(NO_ORDERS)
    robot.i_am("rick")
    (taken,) = say(robot, TO_DANCE.format(1.0), "rick")
    assert isinstance(taken, LessonTaken)
    robot.tell(GIRL, MARY, speaker="rick")
    assert isinstance(robot.replies[-1], FactTaken)
    assert robot.do(FORWARD, "rick") == []


def test_a_revision_is_teaching_too(robot: Robot) -> None:
    robot.teach(TO_DANCE.format(1.0))
    robot.teach(NO_LESSONS)
    old = net("act-1 -lex- drive")
    robot.hear(Revision(chain("DO[ act-1 -lex- grab ]"), old), "no, grab instead", "rick")
    robot.settle()
    assert isinstance(robot.replies[-1], Refused)
    assert robot.do("DO[ act-1 -lex- dance ]", "mary") == [Travel(0.2, 1.0)]


# -- vetoes and permissions by person ------------------------------------------------------

RICK_MAY = f"trig: ALLOW[ act-1; {BY_RICK} ]; pref: 1.0; ---"


def hear_one_of(robot: Robot, candidates: tuple[str, ...]) -> list[Any]:
    """An order in a voice that is one of these; the motions."""
    before = len(robot.moved)
    utterance = Utterance("drive forward", candidates=candidates)
    robot._heard.append(Heard(utterance, Command(chain(FORWARD))))
    robot.settle()
    return robot.moved[before:]


@pytest.mark.parametrize(
    ("lessons", "candidates", "moves"),
    [
        pytest.param([NO_ORDERS], ("rick", "mary"), False, id="vetoed if any is"),
        pytest.param([NO_ORDERS], ("mary", "rick"), False, id="in whatever order"),
        pytest.param([NO_ORDERS], ("john", "mary"), True, id="not vetoed if none is"),
        pytest.param([NO_ORDERS, RICK_MAY], ("rick", "mary"), False, id="not all are permitted"),
        pytest.param(
            [NO_ORDERS, RICK_MAY, RICK_MAY.replace("rick", "mary")],
            ("rick", "mary"),
            True,
            id="permitted as all are",
        ),
    ],
)
def test_a_voice_that_may_be_one_of_several(
    robot: Robot, lessons: list[str], candidates: tuple[str, ...], moves: bool
) -> None:
    for text in lessons:
        robot.teach(text)
    assert bool(hear_one_of(robot, candidates)) is moves


ONLY_MARY = (
    "trig: ANTE[ act-1 -lex- drive ]; unless: "
    + BY_RICK.replace("rick", "mary")
    + "; pref: 1.0; ---; PUNT[ ]"
)


@pytest.mark.parametrize(
    ("candidates", "moves"),
    [(("mary",), True), (("mary", "rick"), False), (("rick", "john"), False)],
)
def test_only_mary_may_is_not_for_a_voice_that_may_be_anothers(
    robot: Robot, candidates: tuple[str, ...], moves: bool
) -> None:
    robot.teach(ONLY_MARY)
    assert bool(hear_one_of(robot, candidates)) is moves


def test_of_a_veto_and_a_permission_by_name_the_newer_wins(robot: Robot) -> None:
    robot.teach(RICK_MAY)
    robot.teach(NO_ORDERS)
    assert robot.do(FORWARD, "rick") == []
    again = Robot()
    again.teach(NO_ORDERS)
    again.teach(RICK_MAY)
    assert again.do(FORWARD, "rick") == [Travel(0.2, 1.0)]


def test_a_permission_that_names_nobody_lifts_no_veto_about_a_speaker(robot: Robot) -> None:
    """ "If a tall person tells you to" fits Rick, and does not name him."""
    robot.teach(NO_ORDERS)
    robot.tell("hq-1 -lex- tall; -hq-> obj-2", "obj-2 -lex- rick")
    robot.teach(RICK_MAY.replace("obj-6 -lex- rick", "hq-8 -lex- tall; -hq-> obj-6"))
    assert robot.do(FORWARD, "rick") == []


def test_a_veto_reaches_the_steps_of_what_he_orders_but_not_reactions(robot: Robot) -> None:
    robot.teach(
        TO_DANCE.format(1.0).replace("-lex- drive", "-lex- turn; dir-9 -lex- left; -dir-> act-2")
    )
    robot.teach(NO_ORDERS.replace("ANTE[ act-1; ", "ANTE[ act-1 -lex- turn; "))
    robot.teach(
        "trig: NOTE[ hq-1 -lex- close; -hq-> obj-2 ]; pref: 1.0; ---;"
        "DO[ act-3 -lex- turn; dir-4 -lex- left; -dir-> act-3 ]"
    )
    assert robot.do("DO[ act-1 -lex- dance ]", "rick") == []
    robot.tell("hq-1 -lex- close; -hq-> obj-2", MARY, speaker="rick")
    assert [type(move) for move in robot.moved] == [Rotate]


def test_stop_status_identity_and_feedback_are_never_vetoed(robot: Robot) -> None:
    robot.teach(NO_ORDERS)
    robot.teach(NO_LESSONS)
    robot.i_am("rick")
    robot.hear(Question("who", net("obj-1 -lex- me"), "obj-1", "identity"), "who am i", "rick")
    robot.settle()
    assert isinstance(robot.replies[-1], Answer)
    robot.hear(Feedback(good=True), "good robot", "rick")
    robot.settle()
    assert robot.replies[-1] == FeedbackTaken(True)
    robot.hear(Identity("mary"), "i am mary", "rick")
    robot.settle()
    assert robot.mind.speaker == "mary"


# -- prohibitions by inference -------------------------------------------------------------

NEVER_GRAB = "trig: ANTE[ act-1 -lex- grab; -obj-> obj-2; ako-3 -lex- person; -ako-> obj-2 ]; pref: 1.0; ---; PUNT[ ]"
WOMEN = GIRLS.replace("person", "woman")
WOMEN_ARE_PERSONS = GIRLS.replace("girl", "woman")
GRAB_MARY = "FIND[ obj-2 -lex- mary ]; DO[ act-1 -lex- grab; -obj-> obj-2 ]"


def test_a_prohibition_is_reached_through_two_steps_of_inference(robot: Robot) -> None:
    for text in (NEVER_GRAB, WOMEN, WOMEN_ARE_PERSONS):
        robot.teach(text)
    assert robot.do(GRAB_MARY) == [MoveGrip(0.0)]
    robot.tell(GIRL, MARY)
    assert robot.do(GRAB_MARY) == []
    refused = robot.replies[-1]
    assert isinstance(refused, Refused)
    assert refused.by.words == NEVER_GRAB


def test_a_prohibition_is_reached_through_an_alias(robot: Robot) -> None:
    robot.teach(NEVER_GRAB)
    robot.teach("if: act-1 -lex- clutch; then: act-1 -lex- grab; belief: 1.0", kind="alias")
    robot.tell("ako-1 -lex- person; -ako-> obj-2", MARY)
    assert robot.do(GRAB_MARY.replace("grab", "clutch")) == []
    assert isinstance(robot.replies[-1], Refused)


def test_a_prohibition_is_reached_through_the_steps_of_a_procedure(robot: Robot) -> None:
    robot.teach(NEVER_GRAB)
    robot.teach(
        "trig: DO[ act-1 -lex- hug; -obj-> obj-2 ]; pref: 1.0; ---; DO[ act-3 -lex- grab; -obj-> obj-2 ]"
    )
    robot.teach(
        "trig: DO[ act-1 -lex- greet; -obj-> obj-2 ]; pref: 1.0; ---; DO[ act-3 -lex- hug; -obj-> obj-2 ]"
    )
    robot.tell("ako-1 -lex- person; -ako-> obj-2", MARY)
    assert robot.do(GRAB_MARY.replace("grab", "greet")) == []
    assert isinstance(robot.replies[-1], Refused)
