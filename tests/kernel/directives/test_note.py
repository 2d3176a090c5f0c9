"""NOTE: something is so; the robot reacts to what has just become so."""

from collections.abc import Callable
from typing import Any

from kernel.action.call import Travel

HAPPY = ("hq-1 -lex- happy; -hq-> obj-2", "obj-2 -lex- mary")
SAY = "DO[ act-7 -lex- say; -obj-> txt-8; txt-8 -str- {} ]"


def when(condition: str, *steps: str, pref: float = 1.0) -> str:
    return "; ".join((f"trig: NOTE[ {condition} ]", f"pref: {pref}", "---", *steps))


def test_a_told_fact_is_reacted_to(robot: Any) -> None:
    robot.teach(when(HAPPY[0], SAY.format("hurray")))
    robot.tell(*HAPPY)
    assert robot.said == ["hurray"]


def test_a_fact_told_again_fires_again(robot: Any) -> None:
    robot.teach(when(HAPPY[0], SAY.format("hurray")))
    robot.tell(*HAPPY)
    robot.tell(*HAPPY)
    assert robot.said == ["hurray", "hurray"]


def test_a_fact_known_already_does_not_fire_when_another_is_told(robot: Any) -> None:
    robot.teach(when(HAPPY[0], SAY.format("hurray")))
    robot.tell(*HAPPY)
    robot.tell("hq-1 -lex- tall; -hq-> obj-2", "obj-2 -lex- mary")
    assert robot.said == ["hurray"]


def test_a_conclusion_that_rests_on_the_fact_fires(robot: Any) -> None:
    for word, then in (("glad", "joyful"), ("joyful", "happy")):
        robot.teach(
            f"if: hq-1 -lex- {word}; -hq-> obj-2; then: hq-3 -lex- {then}; -hq-> obj-2; belief: 1.0"
        )
    robot.teach(when(HAPPY[0], SAY.format("hurray")))
    robot.tell("hq-1 -lex- glad; -hq-> obj-2", "obj-2 -lex- mary")
    assert robot.said == ["hurray"]


def test_one_that_succeeds_is_enough(make_robot: Callable[..., Any]) -> None:
    for seed in range(6):
        robot = make_robot(seed=seed)
        robot.teach(when(HAPPY[0], "DO[ act-3 -lex- twizzle ]"))
        robot.teach(when(HAPPY[0], SAY.format("one")))
        robot.teach(when(HAPPY[0], SAY.format("two")))
        robot.tell(*HAPPY)
        assert len(robot.said) == 1
        assert robot.reasons == []


def test_it_never_fails(robot: Any) -> None:
    robot.teach(when(HAPPY[0], "DO[ act-3 -lex- twizzle ]"))
    robot.tell(*HAPPY)
    assert robot.records("verdict")[-1].data["verdict"] == "succeeded"


def test_a_punt_tries_nothing_else(make_robot: Callable[..., Any]) -> None:
    for seed in range(6):
        robot = make_robot(seed=seed)
        robot.teach(when(HAPPY[0], SAY.format("no"), "PUNT[ ]", pref=1.2))
        robot.teach(when(HAPPY[0], SAY.format("hurray"), pref=0.3))
        robot.tell(*HAPPY)
        assert robot.said in (["no"], ["hurray"])


def test_all_conditions_have_to_hold_and_the_exceptions_not(robot: Any) -> None:
    robot.teach(
        f"trig: NOTE[ {HAPPY[0]}; hq-3 -lex- tall; -hq-> obj-2 ];"
        f"unless: hq-4 -lex- busy; -hq-> obj-2; pref: 1.0; ---; {SAY.format('hurray')}"
    )
    robot.tell(*HAPPY)
    assert robot.said == []
    robot.tell("hq-1 -lex- tall; -hq-> obj-2", "obj-2 -lex- mary")
    assert robot.said == ["hurray"]
    robot.tell("hq-1 -lex- busy; -hq-> obj-2", "obj-2 -lex- mary")
    robot.tell(*HAPPY)
    assert robot.said == ["hurray"]


def test_every_utterance_is_noted_before_its_content(robot: Any) -> None:
    robot.teach(
        when(
            "tell-1 -lex- tell; -agt-> obj-2; -dest-> obj-3; obj-3 -lex- you",
            SAY.format("okey dokey"),
        )
    )
    before = len(robot.trace)
    robot.do("DO[ act-1 -lex- drive ]")
    started = [r.data["words"][0] for r in robot.trace[before:] if r.what == "action_started"]
    assert started == ["say", "drive"]


def test_a_step_may_note_something(robot: Any) -> None:
    robot.teach(when("hq-1 -lex- ready; -hq-> obj-2", SAY.format("here I come")))
    robot.do("NOTE[ hq-1 -lex- ready; -hq-> obj-2; obj-2 -lex- you ]; DO[ act-3 -lex- drive ]")
    assert robot.said == ["here I come"]
    assert robot.moved == [Travel(0.2, 1.0)]
    assert robot.believes("hq-1 -lex- ready; -hq-> obj-2; obj-2 -lex- you")
