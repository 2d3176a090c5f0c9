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
