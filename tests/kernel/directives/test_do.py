"""DO: prepare, act, tidy up; a prohibition ends it before anything moves."""

from collections import Counter
from collections.abc import Callable
from typing import Any

import pytest

from kernel.action.call import MoveGrip, Rotate, Travel
from kernel.memory.lesson import Lesson
from kernel.memory.reply import Refused
from kernel.memory.settings import Settings

MakeLesson = Callable[..., Lesson]

FORWARD = "DO[ act-1 -lex- drive; dir-2 -lex- forward; -dir-> act-1 ]"
DANCE = "DO[ act-1 -lex- dance ]"
GRAB_MARY = "FIND[ obj-2 -lex- mary ]; DO[ act-1 -lex- grab; -obj-> obj-2 ]"
GRAB_BLOCK = (
    "FIND[ obj-2 -ref- the; ako-3 -lex- block; -ako-> obj-2 ]; DO[ act-1 -lex- grab; -obj-> obj-2 ]"
)
NO_PERSONS = """
    trig: ANTE[ act-1 -lex- grab; -obj-> obj-2; ako-3 -lex- person; -ako-> obj-2 ]
    pref: 1.0
    ---
    DO[ act-4 -lex- say; -obj-> txt-5; txt-5 -str- I'm not allowed to ]
    PUNT[ ]
"""
GIRLS = "if: ako-1 -lex- girl; -ako-> obj-2; then: ako-3 -lex- person; -ako-> obj-2; belief: 1.0"
NOT_RICK = """
    trig: ANTE[ act-1
                tell-2 -lex- tell
                       -agt-> obj-3
                       -dest-> obj-4
                       -cmd-> act-1
                obj-3 -lex- rick
                obj-4 -lex- you ]
    pref: 1.0
    ---
    DO[ act-5 -lex- complain ]
    PUNT[ ]
"""


def say(text: str, number: int = 7) -> str:
    return f"DO[ act-{number} -lex- say; -obj-> txt-{number + 1}; txt-{number + 1} -str- {text} ]"


def drive(way: str, number: int = 2) -> str:
    return f"DO[ act-{number} -lex- drive; dir-{number + 1} -lex- {way}; -dir-> act-{number} ]"


def advice(trigger: str, *steps: str, pref: float = 1.0, more: str = "") -> str:
    return "; ".join(
        (f"trig: {trigger}", *((more,) if more else ()), f"pref: {pref}", "---", *steps)
    )


def to(verb: str, *steps: str, pref: float = 1.0) -> str:
    return advice(f"DO[ act-1 -lex- {verb} ]", *steps, pref=pref)


# -- ANTE, DO, POST ------------------------------------------------------------------------


def test_before_comes_before_and_after_comes_after(robot: Any) -> None:
    robot.teach(to("dance", drive("forward")))
    robot.teach(advice("ANTE[ act-1 -lex- dance ]", say("music")))
    robot.teach(advice("POST[ act-1 -lex- dance ]", say("applause")))
    robot.do(DANCE)
    assert [(r.data["words"][0], r.data["words"][1]) for r in robot.records("action_started")] == [
        ("say", "music"),
        ("drive", "forward"),
        ("say", "applause"),
    ]


def test_all_of_them_run_and_their_failures_change_nothing(robot: Any) -> None:
    robot.teach(to("dance", drive("forward")))
    for tag in ("ANTE", "POST"):
        for step in ("DO[ act-2 -lex- twizzle ]", say(f"{tag} one"), say(f"{tag} two")):
            robot.teach(advice(f"{tag}[ act-1 -lex- dance ]", step))
    assert robot.do(DANCE) == [Travel(0.2, 1.0)]
    assert sorted(robot.said) == ["ANTE one", "ANTE two", "POST one", "POST two"]
    assert robot.reasons == []


def test_after_runs_where_acting_failed(robot: Any) -> None:
    robot.teach(to("dance", "DO[ act-2 -lex- twizzle ]"))
    robot.teach(advice("POST[ act-1 -lex- dance ]", say("oops")))
    robot.do(DANCE)
    assert robot.said == ["oops"]
    assert robot.reasons == ["no_way"]


def test_after_does_not_run_where_acting_was_forbidden(robot: Any) -> None:
    robot.teach(advice("ANTE[ act-1 -lex- drive ]", "PUNT[ ]"))
    robot.teach(advice("POST[ act-1 -lex- drive ]", say("done")))
    assert robot.do(FORWARD) == []
    assert robot.said == []


def test_ways_are_tried_in_turn_until_one_succeeds(make_robot: Callable[..., Any]) -> None:
    for seed in range(6):
        robot = make_robot(seed=seed)
        robot.teach(to("dance", "DO[ act-2 -lex- twizzle ]"))
        robot.teach(to("dance", drive("forward")))
        robot.teach(to("dance", "DO[ act-2 -lex- hop ]"))
        assert robot.do(DANCE) == [Travel(0.2, 1.0)]
        assert robot.reasons == []


def test_none_left_is_failure_and_the_first_cause_is_told(robot: Any) -> None:
    robot.teach(to("dance", "DO[ act-2 -lex- twizzle ]"))
    robot.do(DANCE)
    assert robot.reasons == ["no_way"]
    assert robot.replies[-1].act.words() == {"twizzle"}


def test_no_way_known_is_told(robot: Any) -> None:
    robot.do("DO[ act-1 -lex- salute ]")
    assert robot.reasons == ["no_way"]


def test_a_way_that_is_given_up_is_not_unknown(robot: Any) -> None:
    robot.teach(to("dance", "PUNT[ ]"))
    robot.do(DANCE)
    assert robot.reasons == ["given_up"]


def test_a_punt_tries_no_further_way_but_the_parent_may(make_robot: Callable[..., Any]) -> None:
    for seed in range(6):
        robot = make_robot(seed=seed)
        robot.teach(to("dance", "DO[ act-2 -lex- cha-cha ]", pref=1.2))
        robot.teach(to("dance", drive("forward"), pref=0.8))
        robot.teach(to("cha-cha", "PUNT[ ]"))
        robot.teach(to("cha-cha", drive("backward"), pref=0.5))
        robot.mind._commons.chance.choices = lambda options, odds: [odds.index(max(odds))]
        assert robot.do(DANCE) == [Travel(0.2, 1.0)]


def test_desperate_it_takes_what_it_hardly_believes(robot: Any) -> None:
    """And only then: belief 0.4 is below the threshold while another way is known."""
    maybe = advice(
        "DO[ act-1 -lex- greet; -obj-> obj-2; ako-3 -lex- person; -ako-> obj-2 ]", say("hello")
    )
    robot.teach(maybe)
    robot.tell("ako-1 -lex- person; -bel- 0.4; -ako-> obj-2", "obj-2 -lex- mary")
    greet = "FIND[ obj-2 -lex- mary ]; DO[ act-1 -lex- greet; -obj-> obj-2 ]"
    robot.do(greet)
    assert robot.said == ["hello"]
    robot.teach(to("greet", say("hm")))
    robot.do(greet)
    assert robot.said == ["hello", "hm"]


def test_twice_is_two_times(robot: Any) -> None:
    moved = robot.do("DO[ act-1 -lex- drive; cnt-2 -str- 2; -cnt-> act-1 ]")
    assert moved == [Travel(0.2, 1.0)] * 2


# -- choice --------------------------------------------------------------------------------


def chosen(
    make_robot: Any, lesson: MakeLesson, weights: dict[str, float], times: int
) -> Counter[str]:
    lessons = [lesson(to("complain", say(text), pref=pref)) for text, pref in weights.items()]
    robot = make_robot(lessons, seed=11, settings=Settings(fade_s=1.0))
    for _ in range(times):
        robot.do("DO[ act-1 -lex- complain ]")
    return Counter(robot.said)


def test_equal_ways_to_complain_share(make_robot: Any, lesson: MakeLesson) -> None:
    counts = chosen(make_robot, lesson, {"a": 1.0, "b": 1.0}, 80)
    assert 25 <= counts["a"] <= 55  # 3.3 standard deviations


def test_must_always_is_chosen_oftener_than_could(make_robot: Any, lesson: MakeLesson) -> None:
    counts = chosen(make_robot, lesson, {"could": 0.8, "must": 1.2}, 120)
    assert counts["must"] > counts["could"] > 20


def test_what_is_hardly_liked_is_not_considered(make_robot: Any, lesson: MakeLesson) -> None:
    assert chosen(make_robot, lesson, {"never": 0.19, "fine": 0.21}, 20) == {"fine": 20}


def test_the_more_specific_way_wins(robot: Any) -> None:
    robot.teach(to("turn", say("somehow")))
    widdershins = "[ act-1 -lex- turn; dir-2 -lex- widdershins; -dir-> act-1 ]"
    robot.teach(advice(f"DO{widdershins}", drive("forward", 3)))
    for _ in range(5):
        robot.do(f"DO{widdershins}")
    assert len(robot.moved) >= 4


# -- prohibitions --------------------------------------------------------------------------


def test_the_papers_prohibition_reached_through_a_rule(robot: Any) -> None:
    robot.teach(NO_PERSONS)
    robot.teach(GIRLS)
    robot.tell("ako-1 -lex- girl; -ako-> obj-2", "obj-2 -lex- mary")
    assert robot.do(GRAB_BLOCK) == [MoveGrip(0.0)]
    assert robot.do(GRAB_MARY) == []
    assert robot.said == ["I'm not allowed to"]
    assert not any(isinstance(reply, Refused) for reply in robot.replies)  # it has been said


def test_whom_nothing_is_known_about_may_be_grabbed(robot: Any) -> None:
    robot.teach(NO_PERSONS)
    robot.teach(GIRLS)
    assert robot.do(GRAB_MARY) == [MoveGrip(0.0)]


def test_a_prohibition_reached_through_an_alias(robot: Any) -> None:
    robot.teach(NO_PERSONS)
    robot.teach("if: act-1 -lex- snatch; then: act-1 -lex- grab; belief: 1.0")
    robot.tell("ako-1 -lex- person; -ako-> obj-2", "obj-2 -lex- mary")
    assert robot.do(GRAB_MARY.replace("grab", "snatch")) == []
    assert robot.said == ["I'm not allowed to"]


def test_caution_counts_what_is_hardly_believed(robot: Any) -> None:
    robot.teach(NO_PERSONS)
    robot.teach(GIRLS.replace("belief: 1.0", "belief: 0.25"))
    robot.tell("ako-1 -lex- girl; -ako-> obj-2", "obj-2 -lex- mary")
    assert robot.do(GRAB_MARY) == []


def test_a_silent_prohibition_is_explained_with_the_inference_that_led_to_it(robot: Any) -> None:
    taught = robot.teach(
        NO_PERSONS.replace(say("I'm not allowed to", 4), ""), "never grab a person"
    )
    robot.teach(GIRLS)
    robot.teach(GIRLS.replace("girl", "block").replace("person", "toy"))
    robot.tell("ako-1 -lex- block; -ako-> obj-2", "obj-2 -lex- brick")
    robot.tell("ako-1 -lex- girl; -ako-> obj-2", "obj-2 -lex- mary")
    assert robot.do(GRAB_MARY) == []
    refused = robot.replies[-1]
    assert isinstance(refused, Refused)
    assert refused.by == taught
    assert "person" in refused.because[0].words()


def test_it_stands_where_the_instead_action_fails(robot: Any) -> None:
    """The anti-Rick operator taught before any way to complain."""
    robot.teach(NOT_RICK)
    robot.i_am("rick")
    assert robot.do(FORWARD) == []
    assert isinstance(robot.replies[-1], Refused)


def test_nothing_moves_while_it_complains(robot: Any) -> None:
    robot.teach(advice("ANTE[ act-1 -lex- drive ]", say("no"), "PUNT[ ]"))
    robot.command(FORWARD)
    robot.tick()
    assert robot.said == ["no"]
    assert robot.out.bids == ()


def test_a_parent_may_try_another_way_and_prohibited_stays_the_explanation(robot: Any) -> None:
    robot.teach(advice("ANTE[ act-1 -lex- shimmy ]", "PUNT[ ]"), "never shimmy")
    robot.teach(to("dance", "DO[ act-2 -lex- shimmy ]"))
    robot.do(DANCE)
    assert isinstance(robot.replies[-1], Refused)
    robot.teach(to("dance", drive("forward")))
    for _ in range(4):
        assert robot.do(DANCE) == [Travel(0.2, 1.0)]


def test_an_exception_in_the_prohibition_lifts_it(robot: Any) -> None:
    robot.teach(NO_PERSONS.replace("pref: 1.0", "unless: hq-8 -lex- happy; -hq-> obj-2\npref: 1.0"))
    robot.tell("ako-1 -lex- person; -ako-> obj-2", "obj-2 -lex- mary")
    assert robot.do(GRAB_MARY) == []
    robot.tell("hq-1 -lex- happy; -hq-> obj-2", "obj-2 -lex- mary")
    assert robot.do(GRAB_MARY) == [MoveGrip(0.0)]


# -- permissions ---------------------------------------------------------------------------

ALLOW = "trig: ALLOW[ act-1 -lex- grab; -obj-> obj-2; ako-3 -lex- person; -ako-> obj-2{more} ]; {with_}pref: 1.0; ---"
HAPPY = "with: hq-9 -lex- happy; -hq-> obj-2; "


def test_a_permission_as_specific_and_newer_lifts_it(robot: Any) -> None:
    robot.teach(NO_PERSONS)
    robot.tell("ako-1 -lex- person; -ako-> obj-2", "obj-2 -lex- mary")
    robot.teach(ALLOW.format(more="", with_=""))
    assert robot.do(GRAB_MARY) == [MoveGrip(0.0)]
    assert robot.records("permitted")


def test_a_prohibition_as_specific_and_newer_stands(robot: Any) -> None:
    robot.teach(ALLOW.format(more="", with_=""))
    robot.teach(NO_PERSONS)
    robot.tell("ako-1 -lex- person; -ako-> obj-2", "obj-2 -lex- mary")
    assert robot.do(GRAB_MARY) == []


def test_a_less_specific_permission_does_not_lift_it(robot: Any) -> None:
    robot.teach(NO_PERSONS)
    robot.tell("ako-1 -lex- person; -ako-> obj-2", "obj-2 -lex- mary")
    robot.teach("trig: ALLOW[ act-1 -lex- grab ]; pref: 1.0; ---")
    assert robot.do(GRAB_MARY) == []


@pytest.mark.parametrize(("belief", "allowed"), [("", True), ("; -bel- 0.7", False), (None, False)])
def test_a_permissions_condition_has_to_be_known_for_sure(
    robot: Any, belief: str | None, allowed: bool
) -> None:
    robot.teach(NO_PERSONS)
    robot.tell("ako-1 -lex- person; -ako-> obj-2", "obj-2 -lex- mary")
    robot.teach(ALLOW.format(more="", with_=HAPPY))
    if belief is not None:
        robot.tell(f"hq-1 -lex- happy{belief}; -hq-> obj-2", "obj-2 -lex- mary")
    assert bool(robot.do(GRAB_MARY)) is allowed


def test_a_veto_on_a_speaker_is_lifted_only_by_naming_him(robot: Any) -> None:
    robot.teach(NOT_RICK)
    robot.i_am("rick")
    robot.teach(
        "trig: ALLOW[ act-1 -lex- drive; dir-2 -lex- forward; -dir-> act-1; deg-3 -deg-> dir-2;"
        "deg-4 -deg-> dir-2; deg-5 -deg-> dir-2; deg-6 -deg-> dir-2 ]; pref: 1.0; ---"
    )
    assert robot.do(FORWARD) == []
    robot.teach(NOT_RICK.replace("ANTE", "ALLOW").split("---")[0] + "---")
    assert robot.do(FORWARD) == [Travel(0.2, 1.0)]


# -- the anti-Rick operator ----------------------------------------------------------------


@pytest.fixture
def wary(robot: Any) -> Any:
    robot.teach(NOT_RICK)
    robot.teach(to("complain", say("I don't take orders from you")))
    return robot


def test_only_ricks_commands_are_refused(wary: Any) -> None:
    assert wary.do(FORWARD) == [Travel(0.2, 1.0)]
    wary.i_am("rick")
    assert wary.do(FORWARD) == []
    assert wary.said == ["I don't take orders from you"]
    wary.i_am("mary")
    assert wary.do(FORWARD) == [Travel(0.2, 1.0)]
    wary.i_am("rick")
    assert wary.do(FORWARD) == []


def test_a_speaker_known_by_his_voice_is_refused_as_well(wary: Any) -> None:
    assert wary.do(FORWARD, speaker="Rick") == []


def test_both_ways_to_complain_are_heard(wary: Any) -> None:
    wary.teach(to("complain", say("Forget it, puny human")))
    wary.i_am("rick")
    for _ in range(12):
        assert wary.do(FORWARD) == []
    assert set(wary.said) == {"I don't take orders from you", "Forget it, puny human"}


def test_it_reaches_the_steps_of_a_procedure(robot: Any) -> None:
    """A veto on Rick's driving alone finds the drive inside his dance."""
    robot.teach(NOT_RICK.replace("ANTE[ act-1\n", "ANTE[ act-1 -lex- drive\n"))
    robot.teach(to("complain", say("no")))
    robot.teach(to("dance", drive("forward")))
    robot.i_am("rick")
    assert robot.do(DANCE) == []
    assert robot.said == ["no"]


def test_it_does_not_reach_reactions(wary: Any) -> None:
    wary.teach(advice("NOTE[ hq-1 -lex- close; -hq-> obj-2 ]", drive("backward", 3)))
    wary.teach(advice("NOTE[ hq-1 -lex- happy; -hq-> obj-2 ]", say("hurray")))
    wary.i_am("rick")
    wary.feel(range_m=0.1)
    wary.settle()
    assert wary.moved == [Travel(-0.2, 1.0)]
    wary.tell("hq-1 -lex- happy; -hq-> obj-2", "obj-2 -lex- mary")
    assert wary.said == ["hurray"]


# -- recursion -----------------------------------------------------------------------------


def test_to_dance_dance_is_noticed_and_told(robot: Any) -> None:
    robot.teach(to("dance", "DO[ act-2 -lex- dance ]"))
    assert robot.do(DANCE) == []
    assert robot.reasons == ["recursion"]


def test_a_round_of_three_is_noticed_as_well(robot: Any) -> None:
    for verb, step in (("a", "b"), ("b", "c"), ("c", "a")):
        robot.teach(to(verb, f"DO[ act-2 -lex- {step} ]"))
    robot.do("DO[ act-1 -lex- a ]")
    assert robot.reasons == ["recursion"]


def test_depth_is_bounded(robot: Any) -> None:
    for number in range(30):
        robot.teach(to(f"step{number}", f"DO[ act-2 -lex- step{number + 1} ]"))
    robot.teach(to("step30", drive("forward")))
    assert robot.do("DO[ act-1 -lex- step20 ]") == [Travel(0.2, 1.0)]
    assert robot.do("DO[ act-1 -lex- step0 ]") == []
    assert robot.reasons == ["too_deep"]


def test_advice_before_an_act_may_contain_the_act(robot: Any) -> None:
    robot.teach(
        advice(
            "ANTE[ act-1 -lex- turn ]", "DO[ act-3 -lex- turn; dir-4 -lex- right; -dir-> act-3 ]"
        )
    )
    moved = robot.do("DO[ act-1 -lex- turn; dir-2 -lex- left; -dir-> act-1 ]")
    assert [command.rate_rad_s > 0 for command in moved if isinstance(command, Rotate)] == [
        False,
        True,
    ]
