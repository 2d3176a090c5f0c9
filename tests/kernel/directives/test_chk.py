"""CHK: true, false, or unknown: three different things."""

from typing import Any

import pytest

CHECK = "CHK[ hq-1 -lex- tall; -hq-> obj-2; obj-2 -lex- mary ]"
THEN = "; DO[ act-3 -lex- drive ]"
TALL = "hq-1 -lex- tall; {}-hq-> obj-2"


@pytest.mark.parametrize(
    ("told", "verdict"), [(None, "unknown"), ("", "succeeded"), ("-neg- yes; ", "failed")]
)
def test_what_memory_says_is_the_verdict(robot: Any, told: str | None, verdict: str) -> None:
    if told is not None:
        robot.tell(TALL.format(told), "obj-2 -lex- mary")
    robot.do(CHECK + THEN)
    ended = [r for r in robot.records("verdict") if r.utterance][-1]  # its complaint ends after it
    assert ended.data["verdict"] == verdict
    assert bool(robot.moved) is (verdict == "succeeded")


def test_a_conclusion_answers_too(robot: Any) -> None:
    robot.teach(
        "if: ako-1 -lex- giant; -ako-> obj-2; then: hq-3 -lex- tall; -hq-> obj-2; belief: 1.0"
    )
    robot.tell("ako-1 -lex- giant; -ako-> obj-2", "obj-2 -lex- mary")
    assert robot.do(CHECK + THEN)


def test_what_is_hardly_believed_is_not_true(robot: Any) -> None:
    robot.tell(TALL.format("-bel- 0.4; "), "obj-2 -lex- mary")
    assert robot.do(CHECK + THEN) == []


def test_the_denial_of_a_denial_is_true(robot: Any) -> None:
    robot.tell(TALL.format("-neg- yes; "), "obj-2 -lex- mary")
    assert robot.do(CHECK.replace("tall;", "tall; -neg- yes;") + THEN)


# -- CHK operators -------------------------------------------------------------------------

CLOSE = "hq-1 -lex- close; -hq-> obj-2"
LOOK = f"trig: CHK[ {CLOSE} ]; pref: 1.0; ---; NOTE[ hq-3 -lex- close; {{}}-hq-> obj-4 ]"
SAY = "DO[ act-7 -lex- say; -obj-> txt-8; txt-8 -str- {} ]"
LOOKING = f"trig: CHK[ {CLOSE} ]; pref: {{}}; ---; {SAY}"


@pytest.mark.parametrize(
    ("finds", "verdict"), [("", "succeeded"), ("-neg- yes; ", "failed"), (None, "unknown")]
)
def test_what_memory_does_not_say_is_found_out(robot: Any, finds: str | None, verdict: str) -> None:
    robot.teach(LOOK.format(finds) if finds is not None else LOOKING.format(1.0, "hm"))
    moved = robot.do(f"CHK[ {CLOSE} ]{THEN}")
    ended = [r for r in robot.records("verdict") if r.utterance][-1]
    assert ended.data["verdict"] == verdict
    assert bool(moved) is (verdict == "succeeded")


def test_what_memory_says_needs_no_finding_out(robot: Any) -> None:
    robot.teach(LOOKING.format(1.0, "looking"))
    robot.feel(range_m=0.1)
    robot.settle()
    assert robot.do(f"CHK[ {CLOSE} ]{THEN}")
    assert robot.said == []


def test_they_are_tried_in_turn_until_it_is_known(make_robot: Any) -> None:
    for seed in range(6):
        robot = make_robot(seed=seed)
        robot.teach(LOOKING.format(1.0, "one"))
        robot.teach(f"trig: CHK[ {CLOSE} ]; pref: 1.0; ---; DO[ act-3 -lex- twizzle ]")
        robot.teach(LOOK.format(""))
        assert robot.do(f"CHK[ {CLOSE} ]{THEN}")
        assert robot.said in ([], ["one"])


def test_a_punt_ends_the_search(robot: Any) -> None:
    robot.teach(f"trig: CHK[ {CLOSE} ]; pref: 1.2; ---; {SAY.format('no')}; PUNT[ ]")
    robot.teach(LOOKING.format(0.3, "second"))
    robot.mind._commons.chance.choices = lambda options, odds: [odds.index(max(odds))]
    robot.do(f"CHK[ {CLOSE} ]{THEN}")
    assert robot.said == ["no"]


def test_the_question_is_not_taken_for_a_fact(robot: Any) -> None:
    """Neither while it is looked into nor after, by rules, reactions or other questions."""
    robot.teach(f"trig: NOTE[ {CLOSE} ]; pref: 1.0; ---; {SAY.format('careful')}")
    robot.teach(f"if: {CLOSE}; then: hq-3 -lex- near; -hq-> obj-2; belief: 1.0")
    robot.teach(f"trig: CHK[ {CLOSE} ]; pref: 1.0; ---; CHK[ hq-5 -lex- near; -hq-> obj-6 ]")
    robot.do(f"CHK[ {CLOSE} ]{THEN}")
    assert robot.said == []
    assert robot.moved == []
    assert not robot.believes(CLOSE)
    assert not any(node.level > 3 for node in robot.mind.memory.net)


def test_checking_that_asks_itself_ends(robot: Any) -> None:
    far = "hq-5 -lex- far; -hq-> obj-6"
    robot.teach(f"trig: CHK[ {CLOSE} ]; pref: 1.0; ---; CHK[ {far} ]")
    robot.teach(f"trig: CHK[ {far} ]; pref: 1.0; ---; CHK[ {CLOSE} ]")
    robot.do(f"CHK[ {CLOSE} ]{THEN}")
    assert robot.reasons == ["not_known"]


@pytest.mark.parametrize(
    ("told", "verdict"), [(None, "unknown"), ("", "yes"), ("-neg- yes; ", "no")]
)
def test_as_a_command_it_reports(robot: Any, told: str | None, verdict: str) -> None:
    if told is not None:
        robot.tell(TALL.format(told), "obj-2 -lex- mary")
    robot.do("FIND[ obj-2 -lex- me ]; CHK[ hq-1 -lex- tall; -hq-> obj-3 ]")
    assert robot.replies[-1].verdict == verdict
    assert robot.reasons == []


def test_a_step_that_is_not_so_says_why(robot: Any) -> None:
    robot.tell(TALL.format("-neg- yes; "), "obj-2 -lex- mary")
    robot.do(CHECK + THEN)
    assert robot.reasons == ["not_so"]
