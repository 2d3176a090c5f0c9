"""Steps in another order: one row, one correction."""

import pytest

from kernel.action.chain import Chain
from kernel.memory.lesson import Operator
from kernel.memory.meaning import Beside
from kernel.memory.notation import canonical, read, read_chain
from kernel.memory.ordering import reordered
from kernel.net.graphlet import Graphlet, Term

LEFT = "DO[ act-2 -lex- turn; dir-3 -lex- left; -dir-> act-2 ]"
RIGHT = "DO[ act-4 -lex- turn; dir-5 -lex- right; -dir-> act-4 ]"
WAVE = "DO[ act-6 -lex- wave ]"
CUP = "FIND[ obj-7 -ref- the; ako-8 -lex- cup; -ako-> obj-7 ]"
GRAB = "DO[ act-9 -lex- grab; -obj-> obj-7 ]"
LOOK = "DO[ act-10 -lex- look; -obj-> obj-7 ]"
FIRST, LAST = "first", "last"
SECOND_TURN = "act-1 -lex- turn; hq-2 -lex- second; -hq-> act-1"


def lines(text: str) -> str:
    return "\n".join(line.strip() for line in text.split(";"))


def operator(chain: str) -> Operator:
    content = read(lines(f"trig: DO[ act-1 -lex- wiggle ]; pref: 1.0; ---; {chain}"))
    assert isinstance(content, Operator)
    return content


def net(text: str) -> Graphlet:
    if text in (FIRST, LAST):
        place = Term("hq-2", frozenset((text,)), links=(("hq", "act-1"),))
        return Graphlet((Term("act-1"), place), "act-1")
    content = read(lines(text))
    assert isinstance(content, Graphlet)
    return content


@pytest.mark.parametrize(
    ("before", "step", "mark", "beside", "after"),
    [
        pytest.param(f"{LEFT};{WAVE}", FIRST, LAST, "", f"{WAVE};{LEFT}", id="they change places"),
        pytest.param(
            f"{LEFT};{WAVE};{RIGHT}", SECOND_TURN, FIRST, "before", f"{RIGHT};{LEFT};{WAVE}",
            id="the second of its like",
        ),
        pytest.param(
            f"{LEFT};{WAVE};{RIGHT}", FIRST, "act-1 -lex- wave", "after", f"{WAVE};{LEFT};{RIGHT}",
            id="after another",
        ),
        pytest.param(f"{LEFT};{WAVE}", FIRST, None, "", f"{WAVE};{LEFT}", id="to the end"),
        pytest.param(
            f"{CUP};{LOOK};{WAVE};{GRAB}", "act-1 -lex- grab", FIRST, "before",
            f"{CUP};{GRAB};{LOOK};{WAVE}", id="what it needs is looked up before",
        ),
        pytest.param(
            f"{WAVE};{CUP};{GRAB}", "act-1 -lex- grab", FIRST, "before", f"{CUP};{GRAB};{WAVE}",
            id="with its look-up",
        ),
    ],
)  # fmt: skip
def test_steps_are_moved(
    before: str, step: str, mark: str | None, beside: Beside, after: str
) -> None:
    changed = reordered(operator(before), net(step), None if mark is None else net(mark), beside)
    assert changed is not None
    expected: Chain = read_chain(lines(after))
    assert canonical(changed.chain) == canonical(expected)


@pytest.mark.parametrize(
    ("step", "mark"),
    [
        pytest.param("act-1 -lex- bow", FIRST, id="no such step"),
        pytest.param(FIRST, FIRST, id="the same"),
        pytest.param(SECOND_TURN, LAST, id="beside another in one play"),
    ],
)
def test_what_cannot_be_moved_stays(step: str, mark: str) -> None:
    both = f"{LEFT};PLAY{{;{RIGHT};{WAVE};}}"
    assert reordered(operator(both), net(step), net(mark), "") is None
