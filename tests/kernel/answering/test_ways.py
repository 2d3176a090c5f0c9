"""Do you know how, how do you, what happens when, what can you do, are you allowed."""

import pytest

from kernel.memory.explanation import Abilities, Allowed, Lessons, Taught
from tests.kernel.answering.conftest import (
    BACK_OFF,
    DANCE,
    GRAB_MARY,
    LEFT,
    NEVER_GRAB,
    Questioned,
)

SHAKE = (
    "trig: DO[ act-1 -lex- shake ]; pref: 1.0; ---------------; "
    f"{GRAB_MARY.replace('-1', '-7').replace('-2', '-8')}"
)


def lessons(robot: Questioned, ask: str, about: str, topic: str) -> list[str]:
    reply = robot.asked(ask, about, topic)  # type: ignore[arg-type]
    assert isinstance(reply, Lessons)
    return [lesson.words for lesson in reply.lessons]


@pytest.mark.parametrize(("verb", "known"), [("dance", "yes"), ("turn", "yes"), ("salute", "no")])
def test_do_you_know_how(robot: Questioned, verb: str, known: str) -> None:
    robot.taught("freddy", "to dance ...", DANCE)
    reply = robot.asked("yesno", f"act-1 -lex- {verb}", "know_how")
    assert reply.verdict == known  # type: ignore[union-attr]
    assert robot.moved == []


def test_a_verb_known_by_an_alias_only(robot: Questioned) -> None:
    alias = "if: act-1 -lex- twirl; then: act-1 -lex- turn; belief: 1.0"
    robot.taught("rick", "twirl means turn", alias, "alias")
    assert robot.asked("yesno", "act-1 -lex- twirl", "know_how").verdict == "yes"  # type: ignore[union-attr]


def test_how_do_you(robot: Questioned) -> None:
    robot.taught("freddy", "to dance one way", DANCE)
    robot.taught("mary", "to dance another way", DANCE.replace("left", "right"))
    assert lessons(robot, "how", "act-1 -lex- dance", "know_how") == [
        "to dance another way",
        "to dance one way",
    ]
    assert lessons(robot, "how", "act-1 -lex- salute", "know_how") == []
    born = robot.asked("how", "act-1 -lex- turn", "know_how")
    assert isinstance(born, Taught)
    assert born.born


def test_what_happens_when_it_is_so(robot: Questioned) -> None:
    robot.taught("freddy", "back off", BACK_OFF, "reaction")
    very_close = "hq-1 -lex- close; -hq-> obj-2; deg-3 -lex- very; -deg-> hq-1"
    assert lessons(robot, "what", very_close, "happens") == ["back off"]
    assert lessons(robot, "what", "hq-1 -lex- close; -hq-> obj-2", "happens") == []
    assert robot.moved == []
    robot.settle()
    assert not robot.believes("hq-1 -lex- close; -hq-> obj-2"), "it was only supposed"


def test_what_follows_when_it_is_so(robot: Questioned) -> None:
    robot.rule("janey", "girl", "person")
    assert lessons(robot, "what", "ako-1 -lex- girl; -ako-> obj-2", "happens") == [
        "a girl is a person"
    ]


def test_what_happens_before_and_after_an_act(robot: Questioned) -> None:
    for tag in ("ANTE", "POST"):
        text = (
            f"trig: {tag}[ act-1 -lex- turn ]; pref: 1.0; ---------------; DO[ act-2 -lex- wait ]"
        )
        robot.taught("freddy", tag, text, "before" if tag == "ANTE" else "after")
    assert lessons(robot, "what", "act-1 -lex- turn", "before") == ["ANTE"]
    assert lessons(robot, "what", "act-1 -lex- turn", "after") == ["POST"]


def test_abilities(robot: Questioned) -> None:
    robot.taught("freddy", "to dance ...", DANCE)
    robot.taught("mary", "to dance otherwise", DANCE)
    reply = robot.asked("what", "act-1; -agt-> obj-2; obj-2 -lex- you", "abilities")
    assert isinstance(reply, Abilities)
    assert {"drive", "turn", "grab", "release", "raise", "lower", "say"} <= set(reply.born)
    assert [act.words() for act in reply.taught] == [{"dance"}]


def test_allowed_and_not_through_an_inference_and_through_a_step(robot: Questioned) -> None:
    robot.taught("freddy", "never grab a person", NEVER_GRAB, "prohibition")
    robot.taught("freddy", "to shake grab mary", SHAKE)
    robot.rule("janey", "girl", "person")
    grab = "act-1 -lex- grab; -obj-> obj-2; obj-2 -lex- mary"
    for about, forbidden in ((grab, False), ("act-1 -lex- shake", False)):
        assert _allowed(robot, about) is not forbidden
    robot.told_kind("rick", "mary", "girl")
    for about in (grab, "act-1 -lex- shake"):
        assert not _allowed(robot, about)
    assert _allowed(robot, LEFT[4:-2])
    assert robot.moved == []
    assert robot.mind.memory.told, "what was told stays told"
    assert lessons(robot, "yesno", "act-1 -ref- that", "allowed") == ["never grab a person"]


def _allowed(robot: Questioned, about: str) -> bool:
    reply = robot.asked("yesno", about, "allowed")
    assert isinstance(reply, Allowed)
    return reply.trouble is None


def test_what_happens_when_somebody_gives_an_order(robot: Questioned) -> None:
    veto = (
        "trig: ANTE[ act-1; tell-2 -lex- tell; -agt-> obj-3; -dest-> obj-4; -cmd-> act-1; "
        "obj-3 -lex- rick; obj-4 -lex- you ]; pref: 1.0; ---------------; PUNT[ ]"
    )
    robot.taught("freddy", "don't obey rick", veto, "permission")
    order = (
        "act-1 -lex- tell; -agt-> obj-2; -dest-> obj-3; -cmd-> act-4; obj-2 -lex- {}; "
        "obj-3 -lex- you; act-4 -lex- turn"
    )
    assert lessons(robot, "what", order.format("rick"), "happens") == ["don't obey rick"]
    assert lessons(robot, "what", order.format("mary"), "happens") == []
