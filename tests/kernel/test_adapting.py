"""Strengths that experience and feedback move, and how often a robot chooses what."""

import pytest

from kernel.action.call import MoveGrip, Travel
from kernel.memory.choice import choice_weights
from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Control, Feedback, Revision
from kernel.memory.reply import FeedbackTaken, Halted, TakenBack
from kernel.memory.settings import Settings
from tests.kernel.conftest import Robot, chain

SAY = "DO[ act-5 -lex- say; -obj-> txt-6; txt-6 -str- {} ]"
GREET = "trig: DO[ act-1 -lex- greet; {more}-obj-> obj-2{terms} ]; pref: {pref}; ---; " + SAY
FORWARD = "DO[ act-3 -lex- drive; dir-4 -lex- forward; -dir-> act-3 ]"
GREET_MARY = "FIND[ obj-2 -lex- mary ]; DO[ act-1 -lex- greet; -obj-> obj-2 ]"
DANCE = "DO[ act-1 -lex- dance ]"
FAILS = "DO[ act-8 -lex- salute ]"


def strength(robot: Robot, lesson: Lesson) -> float:
    return robot.mind._commons.policy.strength(lesson)


def feedback(robot: Robot, *, good: bool) -> FeedbackTaken:
    robot.hear(Feedback(good), "good robot" if good else "bad robot", "mary")
    robot.settle()
    reply = robot.replies[-1]
    assert isinstance(reply, FeedbackTaken)
    return reply


def to_dance(chain: str, pref: float = 1.0) -> str:
    return f"trig: DO[ act-1 -lex- dance ]; pref: {pref}; ---; {chain}"


# -- experience ----------------------------------------------------------------------------


def test_a_way_that_failed_before_another_one_worked_is_liked_less_down_to_the_bound() -> None:
    robot = Robot(settings=Settings(sharpness=0.0, least_preference=0.0))
    bad = robot.teach(to_dance(FAILS))
    good = robot.teach(to_dance(FORWARD))
    seen = []
    for _ in range(60):
        assert robot.do(DANCE) == [Travel(0.2, 1.0)]
        seen.append(strength(robot, bad))
    assert seen == sorted(seen, reverse=True)
    assert seen[-1] == pytest.approx(0.1)
    assert strength(robot, good) == 1.0
    assert all(change.own for change in robot.mind._commons.policy.changes() if change.adapted)


def test_a_failure_that_nothing_made_good_lowers_nothing(robot: Robot) -> None:
    only = robot.teach(to_dance(FAILS))
    robot.do(DANCE)
    assert strength(robot, only) == 1.0


def test_success_brings_a_lowered_preference_back_to_what_was_taught_and_no_further(
    robot: Robot,
) -> None:
    dance = robot.teach(to_dance(FORWARD, 0.8))
    robot.do(DANCE)
    assert strength(robot, dance) == 0.8
    feedback(robot, good=False)
    assert strength(robot, dance) == pytest.approx(0.6)
    seen = []
    for _ in range(6):
        robot.do(DANCE)
        seen.append(strength(robot, dance))
    assert seen == pytest.approx([0.65, 0.7, 0.75, 0.8, 0.8, 0.8])


def test_the_last_step_back_is_no_longer_than_it_has_to_be() -> None:
    robot = Robot(settings=Settings(recovery_step=0.15))
    dance = robot.teach(to_dance(FORWARD))
    robot.do(DANCE)
    feedback(robot, good=False)
    robot.do(DANCE)
    robot.do(DANCE)
    assert strength(robot, dance) == 1.0


@pytest.mark.parametrize(
    "law",
    [
        f"trig: ANTE[ act-1 -lex- dance ]; pref: 1.0; ---; {FAILS}",
        f"trig: POST[ act-1 -lex- dance ]; pref: 1.0; ---; {FAILS}",
    ],
)
def test_what_prepares_and_tidies_up_never_adapts(robot: Robot, law: str) -> None:
    robot.teach(to_dance(FORWARD))
    lesson = robot.teach(law)
    for _ in range(3):
        robot.do(DANCE)
    assert strength(robot, lesson) == 1.0
    assert not [change for change in robot.mind._commons.policy.changes() if change.adapted]


def test_the_taught_strength_stays_with_the_lesson(robot: Robot) -> None:
    dance = robot.teach(to_dance(FORWARD))
    robot.do(DANCE)
    feedback(robot, good=True)
    assert robot.mind.policy[-1] == dance
    assert (dance.strength, strength(robot, dance)) == (1.0, pytest.approx(1.1))


# -- feedback ------------------------------------------------------------------------------


@pytest.mark.parametrize(("good", "bound"), [(True, 1.5), (False, 0.1)])
def test_praise_and_blame_move_within_bounds(good: bool, bound: float) -> None:
    robot = Robot(settings=Settings(recovery_step=0.0))
    dance = robot.teach(to_dance(FORWARD))
    robot.do(DANCE)
    for _ in range(20):
        assert feedback(robot, good=good) == FeedbackTaken(good, dance)
    assert strength(robot, dance) == pytest.approx(bound)


def test_it_is_the_last_deed_that_is_praised_the_outermost_operator_of_it(robot: Robot) -> None:
    dance = robot.teach(to_dance("DO[ act-2 -lex- step ]"))
    step = robot.teach(f"trig: DO[ act-1 -lex- step ]; pref: 1.0; ---; {FORWARD}")
    robot.do(DANCE)
    feedback(robot, good=True)
    assert (strength(robot, dance), strength(robot, step)) == (pytest.approx(1.1), 1.0)


def test_a_reaction_can_be_blamed(robot: Robot) -> None:
    close = robot.teach(f"trig: NOTE[ hq-1 -lex- close; -hq-> obj-2 ]; pref: 1.0; ---; {FORWARD}")
    robot.tell("hq-1 -lex- close; -hq-> obj-2", "obj-2 -lex- mary")
    assert robot.moved == [Travel(0.2, 1.0)]
    assert feedback(robot, good=False) == FeedbackTaken(False, close)
    assert strength(robot, close) == pytest.approx(0.8)


def test_stop_that_halts_and_blames(robot: Robot) -> None:
    dance = robot.teach(to_dance(FORWARD))
    robot.command(DANCE)
    robot.pass_time(0.3)
    robot.stop()
    robot.hear(Feedback(good=False, stop=True), "stop that")
    robot.settle()
    assert robot.replies[1:] == [Halted(was_busy=True)], "one answer to what is both"
    assert strength(robot, dance) == pytest.approx(0.8)


def test_the_bodys_own_skills_have_nothing_to_praise(robot: Robot) -> None:
    dance = robot.teach(to_dance(FORWARD))
    robot.do(DANCE)
    robot.do(FORWARD)
    assert feedback(robot, good=False) == FeedbackTaken(False)
    assert strength(robot, dance) == 1.0


def test_nothing_done_nothing_praised(robot: Robot) -> None:
    assert feedback(robot, good=True) == FeedbackTaken(True)


def test_undo_passes_over_the_robots_own_adaptations(robot: Robot) -> None:
    """What they have moved since stays moved."""
    hello = robot.teach(to_dance(SAY.format("hello")))
    robot.do(DANCE)
    feedback(robot, good=False)
    robot.do(DANCE)
    assert strength(robot, hello) == pytest.approx(0.85)
    for expected in (1.0, 0.85, 1.0):
        robot.hear(Control("undo"))
        robot.settle()
        assert robot.replies[-1] == TakenBack(moved=(hello,))
        assert strength(robot, hello) == pytest.approx(expected)
    assert robot.mind.policy == (hello,)


def test_doing_something_else_instead_blames_what_was_done(robot: Robot) -> None:
    dance = robot.teach(to_dance(FORWARD))
    robot.do(DANCE)
    robot.hear(Revision(chain("DO[ act-1 -lex- release ]")), "no, release instead")
    robot.settle()
    assert isinstance(robot.moved[-1], MoveGrip)
    assert strength(robot, dance) == pytest.approx(0.8)


def test_blame_can_be_undone() -> None:
    robot = Robot(settings=Settings(recovery_step=0.0))
    dance = robot.teach(to_dance(FORWARD))
    robot.do(DANCE)
    feedback(robot, good=False)
    robot.hear(Control("undo"))
    robot.settle()
    assert robot.replies[-1] == TakenBack(moved=(dance,))
    assert strength(robot, dance) == 1.0


def test_adaptation_survives_a_restart_by_the_journal(robot: Robot) -> None:
    dance = robot.teach(to_dance(FORWARD))
    robot.do(DANCE)
    feedback(robot, good=False)
    from kernel.mind import Mind

    history = tuple(reversed(list(robot.mind._commons.policy.changes())))
    again = Mind(history=history)
    assert again._commons.policy.strength(dance) == pytest.approx(0.8)


# -- beliefs of rules ----------------------------------------------------------------------

GIRLS = "if: ako-1 -lex- girl; -ako-> obj-2; then: ako-3 -lex- person; -ako-> obj-2; belief: {}"
PERSON = "ako-1 -lex- person; -ako-> obj-2"
NO_PERSON = "ako-1 -lex- person; -neg- yes; -ako-> obj-2"


@pytest.mark.parametrize(
    ("taught", "fact", "believed"),
    [
        pytest.param(0.7, PERSON, 0.8, id="confirmed"),
        pytest.param(0.7, NO_PERSON, 0.6, id="contradicted"),
        pytest.param(1.0, PERSON, 1.0, id="no surer than sure"),
        pytest.param(0.7, "hq-1 -lex- tall; -hq-> obj-2", 0.7, id="neither"),
    ],
)
def test_facts_that_confirm_or_contradict_a_rule_move_its_belief(
    robot: Robot, taught: float, fact: str, believed: float
) -> None:
    rule = robot.teach(GIRLS.format(taught))
    robot.tell("ako-1 -lex- girl; -ako-> obj-2", "obj-2 -lex- mary")
    robot.tell(fact, "obj-2 -lex- mary")
    assert strength(robot, rule) == pytest.approx(believed)
    assert rule.strength == taught


def test_a_belief_that_moved_is_what_the_rule_concludes_with(robot: Robot) -> None:
    robot.teach(GIRLS.format(0.55))
    robot.tell("ako-1 -lex- girl; -ako-> obj-2", "obj-2 -lex- janey")
    assert robot.believes(f"{PERSON}; obj-2 -lex- janey")
    robot.tell("ako-1 -lex- girl; -ako-> obj-2", "obj-2 -lex- mary")
    robot.tell(NO_PERSON, "obj-2 -lex- mary")
    assert not robot.believes(f"{PERSON}; obj-2 -lex- janey")


# -- measured choice -----------------------------------------------------------------------


def test_the_frequencies_of_choice_are_those_of_the_weights() -> None:
    """Chi-square over 2,000 choices with a fixed seed: three equally specific ways and a less specific one."""
    robot = Robot(seed=5)
    ways = [("a", 1.2, 2), ("b", 1.0, 2), ("c", 0.6, 2), ("d", 1.5, 1)]
    for word, pref, terms in ways:
        trigger = "act-1 -lex- greet; -obj-> obj-2" + ("; obj-2 -lex- mary" if terms == 2 else "")
        robot.teach(f"trig: DO[ {trigger} ]; pref: {pref}; ---; {SAY.format(word)}")
    for _ in range(2000):
        robot.command(GREET_MARY)
        robot.tick(1.0)
        robot.tick(1.0)
        robot.trace.clear()
    raw = [pref * 10.0 ** (terms - 2) for _, pref, terms in ways]
    assert choice_weights([p for _, p, _ in ways], [t for *_, t in ways]) == pytest.approx(
        [r / sum(raw) for r in raw]
    )
    expected = [2000 * r / sum(raw) for r in raw]
    seen = [robot.said.count(word) for word, *_ in ways]
    assert sum(seen) == 2000
    chi_square = sum((s - e) ** 2 / e for s, e in zip(seen, expected, strict=True))
    assert chi_square < 16.27, "3 degrees of freedom, p = 0.001"


def test_must_always_is_said_more_often_than_could() -> None:
    """D11."""
    robot = Robot(seed=1)
    for word, pref in (("good day", 1.2), ("howdy", 0.8)):
        robot.teach(
            f"trig: DO[ act-1 -lex- greet; -obj-> obj-2 ]; pref: {pref}; ---; {SAY.format(word)}"
        )
    for _ in range(200):
        robot.do(GREET_MARY)
    good_day = robot.said.count("good day")
    assert len(robot.said) == 200
    assert 100 < good_day < 140


def test_blame_makes_a_way_rarer_and_a_blamed_one_is_left_alone_in_the_end() -> None:
    robot = Robot(seed=2)
    robot.teach(to_dance(FORWARD))
    grab = robot.teach(to_dance("DO[ act-7 -lex- release ]"))
    for _ in range(40):
        if isinstance(robot.do(DANCE)[-1], MoveGrip):
            feedback(robot, good=False)
    assert strength(robot, grab) < 0.2
    assert {type(robot.do(DANCE)[-1]) for _ in range(20)} == {Travel}
