"""What would you do if: told as a plan, and nothing has happened."""

import pytest

from kernel.memory.explanation import Plan
from kernel.memory.settings import Settings
from tests.kernel.answering.conftest import (
    BACK_OFF,
    DANCE,
    FORWARD,
    GRAB_MARY,
    LEFT,
    NEVER_GRAB,
    Questioned,
)

SUPPOSED = "act-1; -agt-> obj-2; obj-2 -lex- you"
DANCING = "DO[ act-1 -lex- dance ]"


def would(robot: Questioned, supposed: str = "", about: str = SUPPOSED) -> Plan:
    reply = robot.asked("what", about, "would", supposed=supposed)
    assert isinstance(reply, Plan)
    return reply


def told(plan: Plan) -> list[tuple[frozenset[str], float, float]]:
    return [(s.act.words(), round(s.begin_s, 1), round(s.end_s, 1)) for s in plan.steps]


def test_a_command_step_by_step(robot: Questioned) -> None:
    robot.taught("freddy", "to dance ...", DANCE)
    plan = would(robot, DANCING)
    assert told(plan) == [({"drive", "forward"}, 0.0, 1.0), ({"turn", "left"}, 1.0, 2.0)]
    assert plan.whole_s == pytest.approx(2.0)
    assert (plan.trouble, plan.unfinished) == (None, False)


def test_nothing_moves_and_nothing_is_remembered(robot: Questioned) -> None:
    robot.taught("freddy", "to dance ...", DANCE)
    trace, lessons = len(robot.trace), robot.mind.policy
    nodes, told_facts = len(robot.mind.memory.net), dict(robot.mind.memory.told)
    chance = robot.mind._commons.chance.getstate()
    would(robot, DANCING)
    robot.settle()
    assert robot.moved == []
    assert robot.said == []
    assert len(robot.mind.experience) == 0
    assert robot.mind.policy == lessons
    assert robot.mind.memory.told == told_facts
    assert robot.mind._commons.chance.getstate() == chance
    assert not any(r.what.startswith("action") for r in robot.trace[trace:])
    robot.pass_time(40)
    assert len(robot.mind.memory.net) <= nodes + 5


def test_what_is_foretold_comes_true(robot: Questioned) -> None:
    """With equal chances for two ways, the imagined choice is the real one, whatever the seed."""
    ways = set()
    for seed in range(12):
        robot = Questioned(seed=seed)
        robot.taught("freddy", "one", DANCE.replace(LEFT, ""))
        robot.taught("freddy", "other", DANCE.replace(FORWARD + "; ", ""))
        foretold = [step.act.words() for step in would(robot, DANCING).steps]
        robot.ordered("freddy", "dance", DANCING)
        done = [d.act.words() for d in reversed(list(robot.mind.experience)) if d.parent]
        assert foretold == done
        ways.add(tuple(foretold))
    assert len(ways) == 2


def test_a_refusal_with_its_inference_and_who_says_it_counts(robot: Questioned) -> None:
    robot.taught("freddy", "never grab a person", NEVER_GRAB, "prohibition")
    robot.rule("janey", "girl", "person")
    robot.told_kind("rick", "mary", "girl")
    plan = would(robot, GRAB_MARY)
    assert plan.steps == ()
    assert plan.trouble is not None
    assert plan.trouble.by is not None
    assert [step.lesson.teacher for step in plan.trouble.steps] == ["janey"]


def test_a_veto_on_the_person_who_asks(robot: Questioned) -> None:
    veto = (
        "trig: ANTE[ act-1; tell-2 -lex- tell; -agt-> obj-3; -dest-> obj-4; -cmd-> act-1; obj-3 -lex- rick; "
        "obj-4 -lex- you ]; pref: 1.0; ---------------; PUNT[ ]"
    )
    robot.taught("freddy", "don't obey rick", veto, "prohibition")
    for speaker, obeyed in (("rick", False), ("mary", True)):
        reply = robot.asked("what", SUPPOSED, "would", speaker, LEFT)
        assert isinstance(reply, Plan)
        assert bool(reply.steps) is obeyed


def test_a_fact_that_is_not_so(robot: Questioned) -> None:
    robot.taught("freddy", "back off", BACK_OFF, "reaction")
    very_close = "hq-1 -lex- close; -hq-> obj-2; deg-3 -lex- very; -deg-> hq-1"
    assert told(would(robot, about=very_close)) == [({"drive", "backward"}, 0.0, 1.0)]
    assert told(would(robot, about="hq-1 -lex- close; -hq-> obj-2")) == []
    assert robot.moved == []


def test_what_it_senses_already_is_no_news(robot: Questioned) -> None:
    robot.feel(range_m=0.04)
    robot.tick()
    robot.taught("freddy", "back off", BACK_OFF, "reaction")
    assert told(would(robot, LEFT)) == [({"turn", "left"}, 0.0, 1.0)]


def test_what_it_would_run_into(robot: Questioned) -> None:
    robot.feel(range_m=0.20)
    robot.taught("freddy", "back off", BACK_OFF, "reaction")
    words = [step.act.words() for step in would(robot, FORWARD).steps]
    assert {"drive", "backward"} in words


def test_speech_takes_time_and_what_never_ends_is_cut_off(robot: Questioned) -> None:
    plan = would(robot, "DO[ act-1 -lex- say; -obj-> txt-2; txt-2 -str- one two three four ]")
    assert plan.whole_s == pytest.approx(1.4, abs=0.11)
    plan = would(robot, "DO[ act-1 -lex- wait; amt-2 -lex- minute; -str- 5; -amt-> act-1 ]")
    assert plan.unfinished
    assert plan.whole_s <= 60.0


def test_told_facts_decide_in_imagination_too(robot: Questioned) -> None:
    red = "obj-2 -ref- the; ako-3 -lex- block; -ako-> obj-2; hq-4 -lex- red; -hq-> obj-2"
    robot.told("janey", "the red block is fragile", "hq-1 -lex- fragile; -hq-> obj-2", red)
    never = NEVER_GRAB.replace(
        "ako-3 -lex- person; -ako-> obj-2", "hq-3 -lex- fragile; -hq-> obj-2"
    )
    robot.taught("freddy", "never grab something fragile", never, "prohibition")
    for colour, refused in (("red", True), ("blue", False)):
        order = f"FIND[ {red.replace('red', colour)} ]; DO[ act-9 -lex- grab; -obj-> obj-2 ]"
        assert (would(robot, order).trouble is not None) is refused


def test_the_settings_hold_in_imagination() -> None:
    robot = Questioned(settings=Settings(depth=1))
    robot.taught("freddy", "to dance ...", DANCE)
    assert would(robot, DANCING).steps == ()


def test_whoever_asks_is_who_is_meant(robot: Questioned) -> None:
    greet = (
        "trig: NOTE[ hq-1 -lex- near; -hq-> obj-2; obj-2 -lex- rick ]; pref: 1.0; ---------------; "
        "DO[ act-3 -lex- say; -obj-> txt-4; txt-4 -str- hello rick ]"
    )
    robot.taught("freddy", "when rick is near say hello rick", greet, "reaction")
    near = "hq-1 -lex- near; -hq-> obj-2; obj-2 -lex- me"
    for speaker, greeted in (("rick", True), ("mary", False)):
        reply = robot.asked("what", near, "would", speaker)
        assert isinstance(reply, Plan)
        assert bool(reply.steps) is greeted


def test_an_order_of_somebody_elses(robot: Questioned) -> None:
    veto = (
        "trig: ANTE[ act-1; tell-2 -lex- tell; -agt-> obj-3; -dest-> obj-4; -cmd-> act-1; obj-3 -lex- rick; "
        "obj-4 -lex- you ]; pref: 1.0; ---------------; PUNT[ ]"
    )
    robot.taught("freddy", "don't obey rick", veto, "permission")
    order = (
        "act-1 -lex- tell; -agt-> obj-2; -dest-> obj-3; -cmd-> act-4; obj-2 -lex- {}; obj-3 -lex- you; "
        "act-4 -lex- turn; dir-5 -lex- left; -dir-> act-4"
    )
    for name, obeyed in (("rick", False), ("mary", True), ("me", True)):
        assert bool(would(robot, about=order.format(name)).steps) is obeyed
