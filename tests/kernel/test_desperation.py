"""Desperate, the robot takes what it hardly believes or likes: what counts when (mind.md)."""

from typing import Any

import pytest

PERSON = "; ako-3 -lex- person; -ako-> obj-2"
GREET = "FIND[ obj-2 -lex- mary ]; DO[ act-1 -lex- greet; -obj-> obj-2 ]"
SAY = "DO[ act-7 -lex- say; -obj-> txt-8; txt-8 -str- {} ]"


def way(text: str, tag: str = "DO", more: str = "", pref: float = 1.0, punt: bool = False) -> str:
    steps = SAY.format(text) + ("; PUNT[ ]" if punt else "")
    return f"trig: {tag}[ act-1 -lex- greet; -obj-> obj-2{more} ]; pref: {pref}; ---; {steps}"


def mary_is(robot: Any, belief: float, kind: str = "person") -> None:
    robot.tell(f"ako-1 -lex- {kind}; -bel- {belief}; -ako-> obj-2", "obj-2 -lex- mary")


@pytest.mark.parametrize(
    ("belief", "alone", "beside_another"),
    [(0.9, True, True), (0.5, True, True), (0.45, True, False), (0.25, True, False), (0.2, False, False)],
)  # fmt: skip
def test_what_is_hardly_believed_counts_only_where_nothing_else_applies(
    make_robot: Any, belief: float, alone: bool, beside_another: bool
) -> None:
    for other, counts in ((False, alone), (True, beside_another)):
        robot = make_robot(seed=3)
        robot.teach(way("a person", more=PERSON))
        if other:
            robot.teach(way("anybody", pref=1.0))
        mary_is(robot, belief)
        robot.do(GREET)
        assert robot.said == (["a person"] if counts else ["anybody"] if other else [])


@pytest.mark.parametrize(("preference", "considered"), [(0.2, True), (0.19, False), (0.1, False)])
def test_what_is_hardly_liked_is_done_only_where_nothing_else_applies(
    make_robot: Any, preference: float, considered: bool
) -> None:
    robot = make_robot()
    robot.teach(way("reluctantly", pref=preference))
    robot.do(GREET)
    assert robot.said == ["reluctantly"]
    robot.teach(way("gladly"))
    for _ in range(40):
        robot.do(GREET)
    assert ("reluctantly" in robot.said[1:]) is considered


def test_within_a_desperate_act_what_is_hardly_believed_counts_until_a_success(robot: Any) -> None:
    check = "CHK[ ako-5 -lex- guest; -ako-> obj-2 ]"
    robot.tell("ako-1 -lex- guest; -bel- 0.3; -ako-> obj-2", "obj-2 -lex- mary")
    steps = f"{check}; {SAY.format('hm')}; {check.replace('5', '6')}; {SAY.format('no more')}"
    robot.teach(f"trig: DO[ act-1 -lex- greet; -obj-> obj-2 ]; pref: 0.1; ---; {steps}")
    robot.do(GREET)
    assert robot.said == ["hm"]


def test_it_recovers_with_the_act(robot: Any) -> None:
    mary_is(robot, 0.3)
    robot.teach(way("hello", more=PERSON))
    robot.do(GREET + "; CHK[ ako-5 -lex- person; -ako-> obj-2 ]; " + SAY.format("sure"))
    assert robot.said == ["hello"]


@pytest.mark.parametrize(
    ("belief", "refused"), [(0.9, True), (0.3, True), (0.2, True), (0.15, False)]
)
def test_a_prohibition_counts_what_is_hardly_believed(
    robot: Any, belief: float, refused: bool
) -> None:
    robot.teach(way("hello"))
    robot.teach(way("no", "ANTE", PERSON, punt=True))
    mary_is(robot, belief)
    robot.do(GREET)
    assert robot.said == (["no"] if refused else ["hello"])


@pytest.mark.parametrize(("belief", "allowed"), [(1.0, True), (0.8, True), (0.79, False), (0.3, False)])  # fmt: skip
def test_a_permission_counts_only_what_is_well_believed(
    robot: Any, belief: float, allowed: bool
) -> None:
    robot.teach(way("hello"))
    robot.teach(way("no", "ANTE", PERSON, punt=True))
    friend = "with: ako-4 -lex- friend; -ako-> obj-2"
    robot.teach(f"trig: ALLOW[ act-1 -lex- greet; -obj-> obj-2{PERSON} ]; {friend}; pref: 1.0; ---")
    mary_is(robot, 1.0)
    mary_is(robot, belief, "friend")
    robot.do(GREET)
    assert robot.said == (["hello"] if allowed else ["no"])


def test_desperation_never_lifts_a_veto(robot: Any) -> None:
    robot.teach(way("reluctantly", pref=0.1))
    robot.teach(way("no", "ANTE", punt=True))
    robot.do(GREET)
    assert robot.said == ["no"]
