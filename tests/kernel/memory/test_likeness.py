"""Which lessons are alike, contradict each other, can never come to anything: by table."""

import pytest

from kernel.memory.lesson import Content
from kernel.memory.likeness import alike, contradicts, covering, covers, never_fires
from kernel.memory.notation import read
from kernel.net.graphlet import Graphlet


def content(text: str) -> Content:
    return read("\n".join(line.strip() for line in text.replace(";", "\n").splitlines()))


def net(text: str) -> Graphlet:
    read_ = content(text)
    assert isinstance(read_, Graphlet)
    return read_


GIRL = "if: ako-1 -lex- girl; -ako-> obj-2; then: ako-3 -lex- person; -ako-> obj-2; belief: {}"
NO_GIRL = "if: ako-7 -lex- girl; -ako-> obj-4; then: ako-5 -lex- person; -ako-> obj-4; -neg- yes; belief: {}"
TALL_GIRL = (
    "if: ako-1 -lex- girl; -ako-> obj-2; hq-8 -lex- tall; -hq-> obj-2;"
    "then: ako-3 -lex- person; -ako-> obj-2; -neg- yes; belief: {}"
)
BOY = "if: ako-1 -lex- boy; -ako-> obj-2; then: ako-3 -lex- person; -ako-> obj-2; -neg- yes; belief: 1.0"
EXCEPT = (
    "if: ako-1 -lex- girl; -ako-> obj-2; unless: hq-4 -lex- tall; -hq-> obj-2;"
    "then: ako-3 -lex- person; -ako-> obj-2; belief: 1.0"
)
CLOSE = (
    "trig: NOTE[ hq-1 -lex- close; -hq-> obj-2 ]; {}pref: {}; ---;"
    "DO[ act-3 -lex- drive; dir-4 -lex- {}; -dir-> act-3 ]"
)
NEVER = "trig: ANTE[ act-1 -lex- lift; -obj-> obj-2; ako-3 -lex- cup; -ako-> obj-2 ]; {}pref: 1.0; ---; PUNT[ ]"
MAY = (
    "trig: ALLOW[ act-1 -lex- lift; -obj-> obj-2; ako-3 -lex- cup; -ako-> obj-2 ]; {}pref: 1.0; ---"
)
EMPTY = "with: hq-5 -lex- empty; -hq-> obj-2; "
DANCE = "trig: DO[ act-1 -lex- dance ]; {}pref: 1.0; ---; DO[ act-2 -lex- {} ]"


@pytest.mark.parametrize(
    ("one", "other", "are"),
    [
        pytest.param(GIRL.format(1.0), GIRL.format(0.8), True, id="a hedge is no difference"),
        pytest.param(
            CLOSE.format("", 1.0, "backward"),
            CLOSE.format("", 1.2, "backward").replace("obj-2", "obj-9"),
            True,
            id="names and preference are none",
        ),
        pytest.param(GIRL.format(1.0), NO_GIRL.format(1.0), False, id="a denial is one"),
        pytest.param(
            CLOSE.format("", 1.0, "backward"), CLOSE.format("", 1.0, "forward"), False, id="the act"
        ),
        pytest.param(NEVER.format(""), NEVER.format(EMPTY), False, id="a condition"),
        pytest.param(NEVER.format(""), MAY.format(""), False, id="may is not never"),
        pytest.param(
            "obj-1 -lex- mary; -ref- the", "obj-1 -lex- mary", True, id="how it was referred to"
        ),
    ],
)
def test_alike(one: str, other: str, are: bool) -> None:
    assert alike(content(one), content(other)) is are
    assert alike(content(other), content(one)) is are


@pytest.mark.parametrize(
    ("one", "other", "do"),
    [
        pytest.param(GIRL.format(1.0), NO_GIRL.format(1.0), True, id="the opposite of the same"),
        pytest.param(GIRL.format(0.8), NO_GIRL.format(1.0), True, id="hedged, of the very same"),
        pytest.param(GIRL.format(1.0), TALL_GIRL.format(1.0), True, id="of some of these"),
        pytest.param(GIRL.format(0.8), TALL_GIRL.format(1.0), False, id="usually leaves room"),
        pytest.param(EXCEPT, TALL_GIRL.format(1.0), False, id="an exception leaves room"),
        pytest.param(GIRL.format(1.0), BOY, False, id="of something else"),
        pytest.param(GIRL.format(1.0), GIRL.format(1.0), False, id="the same"),
        pytest.param(NEVER.format(""), MAY.format(""), True, id="never and may"),
        pytest.param(NEVER.format(EMPTY), MAY.format(EMPTY), True, id="under the same condition"),
        pytest.param(NEVER.format(""), MAY.format(EMPTY), False, id="a permitted exception"),
        pytest.param(
            CLOSE.format("", 1.0, "backward"),
            CLOSE.format("", 1.0, "forward"),
            True,
            id="back, forth",
        ),
        pytest.param(
            CLOSE.format("", 1.0, "backward"),
            CLOSE.format("with: hq-9 -lex- red; -hq-> obj-2; ", 1.0, "forward"),
            False,
            id="forth from red things only",
        ),
        pytest.param(
            CLOSE.format("", 1.0, "backward"), CLOSE.format("", 1.0, "up"), False, id="another way"
        ),
        pytest.param(
            DANCE.format("", "raise"), DANCE.format("", "lower"), False, id="two ways to dance"
        ),
    ],
)
def test_contradicts(one: str, other: str, do: bool) -> None:
    assert contradicts(content(one), content(other)) is do
    assert contradicts(content(other), content(one)) is do


@pytest.mark.parametrize(
    ("text", "why"),
    [
        pytest.param(CLOSE.format("", 1.0, "backward"), None, id="something close"),
        pytest.param(
            CLOSE.format("with: hq-5 -lex- close; -hq-> obj-2; -neg- yes; ", 1.0, "backward"),
            "both",
            id="close and not close",
        ),
        pytest.param(
            CLOSE.format("with: hq-5 -lex- close; -hq-> obj-6; -neg- yes; ", 1.0, "backward"),
            None,
            id="this is close, that is not",
        ),
        pytest.param(
            CLOSE.format(
                "with: hq-5 -lex- close; -hq-> obj-2; -neg- yes; deg-7 -lex- very; -deg-> hq-5; ",
                1.0,
                "backward",
            ),
            None,
            id="close, not very close",
        ),
        pytest.param(
            CLOSE.format("unless: hq-5 -lex- close; -hq-> obj-2; ", 1.0, "backward"),
            "always_excepted",
            id="close unless close",
        ),
        pytest.param(
            CLOSE.format("unless: hq-5 -lex- red; -hq-> obj-2; ", 1.0, "backward"),
            None,
            id="close unless red",
        ),
        pytest.param(
            "if: ako-1 -lex- girl; -ako-> obj-2; ako-4 -lex- girl; -ako-> obj-2; -neg- yes;"
            "then: ako-3 -lex- person; -ako-> obj-2; belief: 1.0",
            "both",
            id="a rule on a girl that is none",
        ),
        pytest.param(DANCE.format("", "dance"), "only_itself", id="to dance, dance"),
        pytest.param(
            DANCE.format("", "dance") + "; DO[ act-3 -lex- turn ]",
            None,
            id="to dance, dance and turn",
        ),
    ],
)
def test_never_fires(text: str, why: str | None) -> None:
    assert never_fires(content(text)) == why


def test_a_pattern_covers_what_is_more_specific_and_says_which_name_is_which() -> None:
    step = net("act-1 -lex- turn; dir-2 -lex- left; -dir-> act-1; cnt-3 -str- 2; -cnt-> act-1")
    pattern = net("act-7 -lex- turn; dir-8 -lex- left; -dir-> act-7")
    assert covering(pattern, (step,), step) == {"act-7": "act-1", "dir-8": "dir-2"}
    assert not covers(step, (pattern,), pattern)
    assert covers(
        net("obj-1 -lex- mary"), (net("ako-1 -lex- girl; -ako-> obj-2; obj-2 -lex- mary"),)
    )
