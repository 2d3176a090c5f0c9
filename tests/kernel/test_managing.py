"""Forgetting, undoing, revising, repeating: what a person does with what was taught."""

from typing import Any

import pytest

from kernel.action.call import MoveGrip, MoveLift, Rotate, Travel
from kernel.memory.attention import Focus
from kernel.memory.change import Change
from kernel.memory.lesson import Lesson, Operator, Resting
from kernel.memory.meaning import Control, Fact, Heard, Revision, Teach, Utterance
from kernel.memory.notation import read
from kernel.memory.reply import (
    Failed,
    Forgotten,
    NothingToDo,
    Revised,
    TakenBack,
)
from kernel.memory.settings import Settings
from tests.kernel.conftest import Robot, chain, net, notation

LEFT = "DO[ act-3 -lex- turn; dir-4 -lex- left; -dir-> act-3 ]"
RIGHT = "DO[ act-3 -lex- turn; dir-4 -lex- right; -dir-> act-3 ]"
FORWARD = "DO[ act-3 -lex- drive; dir-4 -lex- forward; -dir-> act-3 ]"
TO_WIGGLE = f"trig: DO[ act-1 -lex- wiggle ]; pref: 1.0; ---; {LEFT}"
TO_WIGGLE_FAST = (
    "trig: DO[ act-1 -lex- wiggle; mod-2 -lex- quickly; -mod-> act-1 ]; pref: 1.0; ---;"
    "DO[ act-3 -lex- grab ]"
)
WIGGLE = "DO[ act-1 -lex- wiggle ]"
GIRL = "ako-1 -lex- girl; -ako-> obj-2"
MARY = "obj-2 -lex- mary"
HEAVY = "hq-1 -lex- heavy; -hq-> obj-2"
BLOCK = "obj-2 -ref- the; ako-3 -lex- block; -ako-> obj-2"
HEAVY_BLOCK = "hq-1 -lex- heavy; -hq-> obj-2; ako-3 -lex- block; -ako-> obj-2"
NO_GIRLS = "trig: ANTE[ act-1 -lex- grab; -obj-> obj-2; ako-3 -lex- girl; -ako-> obj-2 ]; pref: 1.0; ---; PUNT[ ]"
GRAB_MARY = "FIND[ obj-2 -lex- mary ]; DO[ act-1 -lex- grab; -obj-> obj-2 ]"
TURNED_LEFT = Rotate(pytest.approx(1.5708, abs=0.001), 1.0)


def control(robot: Robot, act: Any, speaker: str = "", at_s: float = 0.0, **more: Any) -> Any:
    """Say it; the last reply."""
    robot._heard.append(Heard(Utterance(act, speaker, at_s), Control(act, **more)))
    robot.settle()
    return robot.replies[-1]


def ways(robot: Robot) -> int:
    return len(robot.do(WIGGLE))


# -- forget --------------------------------------------------------------------------------


def test_forgetting_how_to_do_something_takes_every_way_and_what_is_more_specific(
    robot: Robot,
) -> None:
    robot.teach(TO_WIGGLE)
    robot.teach(TO_WIGGLE_FAST)
    robot.teach(TO_WIGGLE.replace("wiggle", "dance"))
    reply = control(robot, "forget", about=net("act-1 -lex- wiggle"))
    assert isinstance(reply, Forgotten)
    assert len(reply.lessons) == 2
    assert robot.do(WIGGLE) == []
    assert robot.reasons == ["no_way"]
    assert len(robot.mind.policy) == 1


def test_forgetting_what_was_never_learned_says_so_and_changes_nothing(robot: Robot) -> None:
    reply = control(robot, "forget", about=net("act-1 -lex- wiggle"))
    assert reply == Forgotten((), net("act-1 -lex- wiggle"))
    assert list(robot.mind._commons.policy.changes()) == []


def test_the_bodys_own_skills_stay_while_what_was_taught_of_them_goes(robot: Robot) -> None:
    drive = net("act-1 -lex- drive")
    assert control(robot, "forget", about=drive) == NothingToDo("inborn")
    robot.teach(TO_WIGGLE.replace("wiggle", "drive"))
    reply = control(robot, "forget", about=drive)
    assert isinstance(reply, Forgotten)
    assert robot.do(FORWARD) == [Travel(0.2, 1.0)]


def test_a_sentence_it_was_born_with_can_be_forgotten(make_robot: Any, lesson: Any) -> None:
    robot = make_robot([lesson(TO_WIGGLE, ident=-7)])
    assert ways(robot) == 1
    control(robot, "forget", about=net("act-1 -lex- wiggle"))
    assert ways(robot) == 0


def test_a_lesson_told_again_is_forgotten_whatever_its_names_and_strength(robot: Robot) -> None:
    robot.teach(TO_WIGGLE)
    again = read(notation(TO_WIGGLE.replace("act-1", "act-9").replace("1.0", "1.2")))
    assert isinstance(again, Operator)
    control(robot, "forget", told=Teach("procedure", again))
    assert ways(robot) == 0


def test_a_lasting_fact_is_forgotten_and_an_undo_brings_it_back(robot: Robot) -> None:
    robot.teach(NO_GIRLS)
    robot.tell(GIRL, MARY)
    assert robot.do(GRAB_MARY) == []
    control(robot, "forget", told=Fact(net(GIRL), (net(MARY),)))
    assert robot.do(GRAB_MARY) == [MoveGrip(0.0)]
    robot.mind._commons.recent.thing = ""  # nothing moved since
    control(robot, "undo")
    assert robot.do(GRAB_MARY) == []


def test_what_was_told_of_a_thing_is_forgotten_facts_of_the_session_as_well(robot: Robot) -> None:
    robot.tell(HEAVY, BLOCK)
    robot.tell(GIRL, MARY)
    robot.tell("hq-1 -lex- tall; -hq-> obj-2", MARY)
    reply = control(robot, "forget", about=net("obj-1 -lex- mary"))
    assert isinstance(reply, Forgotten)
    assert len(reply.lessons) == 2
    assert not robot.believes("hq-1 -lex- tall", depth=3)
    assert robot.believes(HEAVY_BLOCK, depth=3)


def test_what_the_robot_made_of_a_lesson_goes_with_it(make_robot: Any, lesson: Any) -> None:
    parts = [lesson(TO_WIGGLE, ident=n) for n in (1, 2)]
    chunk = lesson(TO_WIGGLE.replace("wiggle", "dance"), ident=3, origins=(1,))
    second = lesson(TO_WIGGLE.replace("wiggle", "bow"), ident=4, origins=(3,))
    robot = make_robot([*parts, chunk, second])
    control(robot, "forget", about=net("act-1 -lex- wiggle"))
    assert robot.mind.policy == ()


# -- undo ----------------------------------------------------------------------------------


def test_undo_takes_back_the_newest_change_and_undo_again_brings_it_back(robot: Robot) -> None:
    wiggle = robot.teach(TO_WIGGLE)
    assert control(robot, "undo") == TakenBack(left=(wiggle,))
    assert robot.mind.policy == ()
    for _ in range(3):
        assert control(robot, "undo") == TakenBack(entered=(wiggle,))
        assert control(robot, "undo") == TakenBack(left=(wiggle,))


def test_what_the_robot_made_of_a_lesson_is_undone_with_it_and_comes_back_with_it(
    robot: Robot,
) -> None:
    taught = robot.teach(TO_WIGGLE)
    chunk = read(notation(TO_WIGGLE.replace("wiggle", "dance")))
    assert isinstance(chunk, Operator)
    commons = robot.mind._commons
    made = Lesson(0, "procedure", chunk, origins=(taught.ident,))
    commons.keep(Focus(99), Change(own=True, learned=(made,)))
    robot.settle()
    assert len(robot.mind.policy) == 2
    control(robot, "undo")
    assert robot.mind.policy == ()
    control(robot, "undo")
    assert len(robot.mind.policy) == 2


def test_undo_waits_for_what_was_said_just_before(robot: Robot) -> None:
    content = read(notation(TO_WIGGLE))
    assert isinstance(content, Operator)
    robot.hear(Teach("procedure", content), "to wiggle")
    robot.hear(Control("undo"), "undo that")
    robot.settle()
    assert robot.mind.policy == ()
    assert isinstance(robot.replies[-1], TakenBack)


def test_taking_back_a_name_leaves_the_thing(robot: Robot) -> None:
    robot.tell(HEAVY, BLOCK)
    robot.tell("obj-2 -lex- pookie", BLOCK)
    control(robot, "undo")
    assert robot.believes(HEAVY_BLOCK, depth=3)


def test_facts_and_lessons_are_undone_in_the_order_of_time(robot: Robot) -> None:
    robot.teach(TO_WIGGLE)
    robot.tell(HEAVY, BLOCK)
    reply = control(robot, "undo")
    assert [lesson.kind for lesson in reply.left] == ["fact"]
    assert not robot.believes(HEAVY_BLOCK, depth=3)
    assert control(robot, "undo").entered
    assert robot.believes(HEAVY_BLOCK, depth=3)
    assert ways(robot) == 1


def test_a_fact_that_counts_again_is_about_the_very_same_thing(robot: Robot) -> None:
    robot.tell(HEAVY, BLOCK)
    robot.tell("hq-1 -lex- red; -hq-> obj-2", BLOCK)
    control(robot, "undo")
    control(robot, "undo")
    both = "hq-1 -lex- heavy; -hq-> obj-2; hq-4 -lex- red; -hq-> obj-2"
    assert robot.believes(both, depth=3)


def test_undoing_a_contradiction_brings_back_what_was_so_before(robot: Robot) -> None:
    robot.tell(HEAVY, BLOCK)
    robot.tell("hq-1 -lex- heavy; -neg- yes; -hq-> obj-2", BLOCK)
    assert not robot.believes(HEAVY_BLOCK, depth=3)
    control(robot, "undo")
    assert robot.believes(HEAVY_BLOCK, depth=3)


def test_a_denied_lasting_fact_does_not_come_back_after_a_restart(
    robot: Robot, make_robot: Any
) -> None:
    robot.tell(GIRL, MARY)
    robot.tell("ako-1 -lex- girl; -neg- yes; -ako-> obj-2", MARY)
    robot.tell(GIRL, MARY)
    again = make_robot(robot.mind.policy)
    assert again.believes(f"{GIRL}; {MARY}", depth=3)


def test_a_motion_cannot_be_undone_but_what_is_taught_after_it_can(robot: Robot) -> None:
    wiggle = robot.teach(TO_WIGGLE)
    robot.do(WIGGLE)
    assert control(robot, "undo") == NothingToDo("motion")
    assert robot.mind.policy == (wiggle,)
    assert control(robot, "forget") == Forgotten((wiggle,))


def test_nothing_to_undo(robot: Robot) -> None:
    assert control(robot, "undo") == NothingToDo("undo")
    assert control(robot, "undo_today") == NothingToDo("undo")
    assert control(robot, "forget") == Forgotten(())


DAY_S = 86_400.0


def test_undoing_a_day_goes_back_to_what_was_in_force_when_it_began(robot: Robot) -> None:
    yesterday, today = 100.5 * DAY_S, 101.5 * DAY_S
    for text, at_s in ((TO_WIGGLE, yesterday), (TO_WIGGLE_FAST, today)):
        content = read(notation(text))
        assert isinstance(content, Operator)
        utterance = Utterance(text, "john" if at_s == today else "mary", at_s)
        robot._heard.append(Heard(utterance, Teach("procedure", content)))
        robot.settle()
    first, _ = robot.mind.policy
    assert control(robot, "forget", at_s=today, about=net("act-1 -lex- wiggle"))
    assert robot.mind.policy == ()
    reply = control(robot, "undo_today", at_s=today)
    assert reply == TakenBack(entered=(first,))
    assert robot.mind.policy == (first,)
    control(robot, "undo", at_s=today)
    assert robot.mind.policy == ()


# -- who may -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("owner", "speaker", "may"),
    [
        ("", "rick", True),
        ("", "", True),
        ("janey", "mary", True),
        ("janey", "Janey", True),
        ("janey", "rick", False),
        ("janey", "", False),
    ],
)
@pytest.mark.parametrize("how", ["undo", "forget", "told", "permit", "undo_today"])
def test_who_may_take_back_a_prohibition(owner: str, speaker: str, may: bool, how: str) -> None:
    robot = Robot(settings=Settings(owner=owner))
    robot.tell(GIRL, MARY, speaker="mary")
    robot.teach(NO_GIRLS, speaker="mary")
    if how == "permit":
        allow = read(notation(NO_GIRLS.replace("ANTE", "ALLOW").split("---")[0] + "---"))
        assert isinstance(allow, Operator)
        robot.i_am(speaker)
        robot.hear(Teach("permission", allow), "you may", speaker)
        robot.settle()
        robot.hear(Control("keep"), "keep both", speaker)
        robot.settle()
    else:
        veto = read(notation(NO_GIRLS))
        assert isinstance(veto, Operator)
        told = Teach("prohibition", veto) if how == "told" else None
        robot.i_am(speaker)
        control(robot, "forget" if how == "told" else how, speaker, told=told)
    assert (robot.reasons == ["not_yours"]) is not may
    moved = robot.do(GRAB_MARY)
    assert (moved == [MoveGrip(0.0)]) is may


ALLOW_TALL_MARY = (
    "trig: ALLOW[ act-1 -lex- grab; -obj-> obj-2; obj-2 -lex- mary; hq-5 -lex- tall; -hq-> obj-2 ];"
    "pref: 1.0; ---"
)


@pytest.mark.parametrize(("speaker", "moved"), [("rick", []), ("janey", [MoveGrip(0.0)])])
def test_a_permission_counts_only_from_who_may_even_where_nothing_but_inference_shows_it(
    speaker: str, moved: list[Any]
) -> None:
    """Neither lesson says of itself that the two are about the same: Mary is a girl."""
    robot = Robot(settings=Settings(owner="janey"))
    robot.tell(GIRL, MARY, speaker="mary")
    robot.tell("hq-1 -lex- tall; -hq-> obj-2", MARY, speaker="mary")
    robot.teach(NO_GIRLS, speaker="mary")
    robot.teach(ALLOW_TALL_MARY, speaker=speaker)
    assert robot.do(GRAB_MARY) == moved


@pytest.mark.parametrize(("speaker", "moved"), [("rick", []), ("janey", [MoveGrip(0.0)])])
def test_who_may_not_permit_may_not_bring_a_permission_back(speaker: str, moved: list[Any]) -> None:
    """Janey allowed it and thought better of it."""
    robot = Robot(settings=Settings(owner="janey"))
    robot.tell(GIRL, MARY, speaker="mary")
    robot.teach(NO_GIRLS, speaker="mary")
    robot.teach(NO_GIRLS.replace("ANTE", "ALLOW").split("---")[0] + "---", speaker="janey")
    control(robot, "forget", "janey")
    assert robot.do(GRAB_MARY) == []
    control(robot, "undo", speaker)
    assert robot.do(GRAB_MARY) == moved


@pytest.mark.parametrize(
    ("kind", "speaker", "may"),
    [
        ("prohibition", "rick", False),
        ("permission", "rick", False),
        ("prohibition", "mary", True),
        ("prohibition", "janey", True),
        ("procedure", "rick", True),
    ],
)
@pytest.mark.parametrize("how", ["forget", "undo_today"])
def test_who_may_take_back_a_lesson_that_rests(
    kind: str, speaker: str, may: bool, how: str
) -> None:
    """Nobody can read what it says, but the store knows who taught it and what sort it is."""
    sleeper = Resting(50, "never grab a girl", "broken", kind, "mary", 0.0, change=10)
    robot = Robot(settings=Settings(owner="janey"), resting=(sleeper,), history=(Change(10),))
    robot.i_am(speaker)
    robot.teach(TO_WIGGLE)
    control(robot, how, speaker, **({"lessons": (50,)} if how == "forget" else {}))
    taken = [change for change in robot.journal if change.retracted or change.undone]
    assert (robot.reasons == ["not_yours"]) is not may
    assert bool(taken) is may


# -- revision ------------------------------------------------------------------------------


def revise(robot: Robot, new: str, old: str = "", of: str = "", speaker: str = "") -> list[Any]:
    """Say it; the motions it brought."""
    before = len(robot.moved)
    meaning = Revision(chain(new), net(old) if old else None, net(of) if of else None)
    robot.hear(meaning, "revised", speaker)
    robot.settle()
    return robot.moved[before:]


TURNING_LEFT = "act-1 -lex- turn; dir-2 -lex- left; -dir-> act-1"


def test_the_operator_of_the_last_deed_is_revised_in_one_change(robot: Robot) -> None:
    robot.teach(TO_WIGGLE)
    robot.teach(TO_WIGGLE.replace("wiggle", "dance"))
    assert robot.do(WIGGLE) == [TURNED_LEFT]
    assert revise(robot, FORWARD, TURNING_LEFT, speaker="john") == []
    assert isinstance(robot.replies[-1], Revised)
    assert robot.do(WIGGLE) == [Travel(0.2, 1.0)]
    assert robot.do("DO[ act-1 -lex- dance ]") == [TURNED_LEFT]
    newest = robot.mind.policy[-1]
    assert (newest.words, newest.teacher) == ("revised", "john")
    robot.mind._commons.recent.thing = ""
    control(robot, "undo")
    assert robot.do(WIGGLE) == [TURNED_LEFT]


def test_nothing_is_lost_where_the_revision_cannot_be_stored(robot: Robot) -> None:
    robot.teach(TO_WIGGLE)
    robot.keep = False
    revise(robot, FORWARD, TURNING_LEFT)
    assert robot.reasons == ["not_stored"]
    assert robot.do(WIGGLE) == [TURNED_LEFT]


def test_after_a_command_the_correction_is_done_instead_of_what_is_still_going_on(
    robot: Robot,
) -> None:
    robot.command(FORWARD)
    robot.pass_time(0.3)
    assert revise(robot, RIGHT) == [Rotate(pytest.approx(-1.5708, abs=0.001), 1.0)]
    assert [r.data["verdict"] for r in robot.records("action_ended")] == ["stopped", "succeeded"]


def test_right_after_a_lesson_its_last_step_is_another_one(robot: Robot) -> None:
    then_left = LEFT.replace("act-3", "act-7").replace("dir-4", "dir-8")
    robot.teach(TO_WIGGLE.replace(LEFT, f"{FORWARD}; {then_left}"))
    assert revise(robot, "DO[ act-1 -lex- raise ]") == []
    assert (
        robot.do(WIGGLE) == [Travel(0.2, 1.0), MoveLift(pytest.approx(0.34, abs=0.2))]
        or len(robot.moved) == 2
    )


def test_another_thing_for_the_last_command(robot: Robot) -> None:
    red = "FIND[ obj-2 -ref- the; ako-3 -lex- block; -ako-> obj-2; hq-4 -lex- red; -hq-> obj-2 ]"
    robot.do(f"{red}; DO[ act-1 -lex- grab; -obj-> obj-2 ]")
    one = "obj-1 -ref- the; ako-2 -lex- one; -ako-> obj-1; hq-3 -lex- {}; -hq-> obj-1"
    robot.trace.clear()
    revise(robot, f"FIND[ {one.format('blue')} ]", one.format("red"))
    (started,) = robot.records("action_started")
    assert "blue" in str(started.data["words"])
    assert "red" not in str(started.data["words"])


@pytest.mark.parametrize(
    ("new", "old", "of"),
    [
        pytest.param(FORWARD, "", "", id="nothing was said before"),
        pytest.param(FORWARD, TURNING_LEFT, "", id="no lesson has that step"),
        pytest.param(FORWARD, "", "act-1 -lex- salute", id="no such verb was taught"),
        pytest.param(FORWARD, "", "act-1 -lex- drive", id="a skill of the body"),
        pytest.param("FIND[ obj-1 -lex- mary ]", "", "", id="another thing for nothing"),
    ],
)
def test_where_nothing_can_be_revised_it_says_so(robot: Robot, new: str, old: str, of: str) -> None:
    assert revise(robot, new, old, of) == []
    assert robot.replies == [NothingToDo("revise")]


def test_a_prohibition_of_somebody_elses_is_not_revised() -> None:
    robot = Robot(settings=Settings(owner="janey"))
    instead = "DO[ act-5 -lex- say; -obj-> txt-6; txt-6 -str- no ]"
    robot.teach(NO_GIRLS.replace("PUNT[ ]", f"{instead}; PUNT[ ]"), speaker="mary")
    revise(robot, LEFT, "act-5 -lex- say", speaker="rick")
    assert isinstance(robot.replies[-1], Failed)
    assert robot.reasons == ["not_yours"]


# -- repeat --------------------------------------------------------------------------------


def test_the_last_command_is_done_again_or_the_last_reply_said_again(robot: Robot) -> None:
    assert control(robot, "repeat") == NothingToDo("repeat")
    robot.do(LEFT)
    robot.hear(Control("repeat"))
    robot.settle()
    assert robot.moved == [TURNED_LEFT] * 2
    robot.do("DO[ act-1 -lex- salute ]")
    said = robot.replies[-1]
    assert control(robot, "repeat") == said
    assert robot.moved == [TURNED_LEFT] * 2
