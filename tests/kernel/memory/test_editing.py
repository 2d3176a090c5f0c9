"""Corrections of chains: one row, one sentence a teacher might say."""

import pytest

from kernel.action.chain import Chain
from kernel.memory.editing import (
    has_step,
    keeping,
    with_more,
    with_other_end,
    with_other_step,
    with_other_thing,
)
from kernel.memory.lesson import Operator
from kernel.memory.meaning import Beside
from kernel.memory.notation import canonical, read, read_chain
from kernel.net.graphlet import Graphlet, Term


def lines(text: str) -> str:
    return "\n".join(line.strip() for line in text.replace(";", "\n").splitlines())


def operator(chain: str, trigger: str = "act-1 -lex- wiggle") -> Operator:
    content = read(lines(f"trig: DO[ {trigger} ]; pref: 1.2; ---; {chain}"))
    assert isinstance(content, Operator)
    return content


def chain(text: str) -> Chain:
    return read_chain(lines(text))


def net(text: str) -> Graphlet:
    content = read(lines(text))
    assert isinstance(content, Graphlet)
    return content


LEFT = "DO[ act-2 -lex- turn; dir-3 -lex- left; -dir-> act-2 ]"
RIGHT = "DO[ act-4 -lex- turn; dir-5 -lex- right; -dir-> act-4 ]"
TWICE = "DO[ act-1 -lex- turn; dir-2 -lex- right; -dir-> act-1; cnt-3 -str- 2; -cnt-> act-1 ]"
TWICE_THERE = (
    "DO[ act-21 -lex- turn; dir-22 -lex- right; -dir-> act-21; cnt-23 -str- 2; -cnt-> act-21 ]"
)
TURNING_LEFT = "act-1 -lex- turn; dir-2 -lex- left; -dir-> act-1"
TO_X = "act-1 -lex- greet; -obj-> obj-9"
GOOD_DAY = "DO[ act-2 -lex- say; -obj-> txt-3; -dest-> obj-9; txt-3 -str- good day ]"
CUP = "FIND[ obj-7 -ref- the; ako-8 -lex- cup; -ako-> obj-7 ]"


@pytest.mark.parametrize(
    ("before", "old", "new", "after"),
    [
        pytest.param(
            f"{LEFT}; {RIGHT}", TURNING_LEFT, TWICE, f"{TWICE_THERE}; {RIGHT}", id="a step"
        ),
        pytest.param(
            f"PLAY{{; {LEFT}; DO[ act-7 -lex- say ]; }}",
            TURNING_LEFT,
            TWICE,
            f"PLAY{{; {TWICE_THERE}; DO[ act-7 -lex- say ]; }}",
            id="a step beside another one",
        ),
        pytest.param(
            f"{CUP}; DO[ act-5 -lex- grab; -obj-> obj-7 ]; {RIGHT}",
            "act-1 -lex- grab",
            LEFT,
            f"{LEFT.replace('act-2', 'act-22').replace('dir-3', 'dir-23')}; {RIGHT}",
            id="a look-up nobody needs goes as well",
        ),
    ],
)
def test_another_step(before: str, old: str, new: str, after: str) -> None:
    changed = with_other_step(operator(before), net(old), chain(new))
    assert changed is not None
    assert changed.preference == 1.2
    assert canonical(changed) == canonical(operator(after))


def place(word: str) -> Graphlet:
    at = Term("hq-2", frozenset((word,)), links=(("hq", "act-1"),))
    return Graphlet((Term("act-1"), at), "act-1")


@pytest.mark.parametrize(
    ("word", "beside", "after"),
    [
        pytest.param("last", "", f"{LEFT}; {TWICE_THERE}", id="the last step otherwise"),
        pytest.param("first", "before", f"{TWICE_THERE}; {LEFT}; {RIGHT}", id="one before it"),
        pytest.param("first", "after", f"{LEFT}; {TWICE_THERE}; {RIGHT}", id="one after it"),
        pytest.param("third", "", None, id="there is no such step"),
    ],
)
def test_a_step_by_its_place(word: str, beside: Beside, after: str | None) -> None:
    before = operator(f"{LEFT}; {RIGHT}")
    changed = with_other_step(before, place(word), chain(TWICE), beside)
    assert (changed and canonical(changed)) == (after and canonical(operator(after)))


def test_what_is_to_be_so_meanwhile_is_looked_up_and_kept() -> None:
    kept = chain(f"{CUP}; KEEP[ hq-1 -lex- closed; -hq-> obj-7 ]")
    whole = keeping(chain(f"{LEFT}; {RIGHT}"), kept)
    assert [d.tag for d in whole.directives()] == ["DO", "FIND", "DO", "KEEP"]
    assert len(whole.plays[-1].auxiliary) == 1


def test_a_step_is_replaced_wherever_it_stands() -> None:
    again = LEFT.replace("act-2", "act-6").replace("dir-3", "dir-7")
    changed = with_other_step(operator(f"{LEFT}; {again}"), net(TURNING_LEFT), chain(RIGHT))
    assert changed is not None
    steps = [d.graphlet.words() for d in changed.chain.directives() if d.graphlet]
    assert steps == [{"turn", "right"}] * 2


def test_other_words_are_said_to_the_same_person() -> None:
    changed = with_other_step(
        operator(GOOD_DAY, TO_X),
        net("act-1 -lex- say; -obj-> txt-2; txt-2 -str- good day"),
        chain("DO[ act-1 -lex- say; -obj-> txt-2; txt-2 -str- good evening ]"),
    )
    assert changed is not None
    assert canonical(changed) == canonical(operator(GOOD_DAY.replace("day", "evening"), TO_X))


def test_what_has_no_such_step_cannot_be_corrected() -> None:
    assert with_other_step(operator(RIGHT), net(TURNING_LEFT), chain(TWICE)) is None
    assert not has_step(chain(RIGHT), net(TURNING_LEFT))
    assert has_step(chain(f"{RIGHT}; {LEFT}"), net(TURNING_LEFT))
    assert with_other_end(operator("PUNT[ ]"), chain(TWICE)) is None


def test_the_last_step_is_another_one() -> None:
    changed = with_other_end(operator(f"{LEFT}; {LEFT}"), chain(RIGHT))
    assert changed is not None
    fresh = RIGHT.replace("act-4", "act-24").replace("dir-5", "dir-25")
    assert canonical(changed) == canonical(operator(f"{LEFT}; {fresh}"))


def test_further_steps_come_first_or_last() -> None:
    fresh = RIGHT.replace("act-4", "act-24").replace("dir-5", "dir-25")
    first, last = (with_more(operator(LEFT), chain(RIGHT), last=at_end) for at_end in (False, True))
    assert canonical(first) == canonical(operator(f"{fresh}; {LEFT}"))
    assert canonical(last) == canonical(operator(f"{LEFT}; {fresh}"))


RED_BLOCK = "FIND[ obj-1 -ref- the; ako-2 -lex- block; -ako-> obj-1; hq-3 -lex- red; -hq-> obj-1 ]"
GRAB_IT = "DO[ act-4 -lex- grab; -obj-> obj-1 ]"
RED_ONE = "obj-1 -ref- the; ako-2 -lex- one; -ako-> obj-1; hq-3 -lex- red; -hq-> obj-1"
BLUE = "obj-1 -ref- the; ako-2 -lex- {}; -ako-> obj-1; hq-3 -lex- blue; -hq-> obj-1"


@pytest.mark.parametrize(
    ("old", "new", "kind"),
    [
        pytest.param(RED_ONE, BLUE.format("one"), "block", id="not the red one, the blue one"),
        pytest.param(None, BLUE.format("one"), "block", id="no, the blue one"),
        pytest.param(RED_ONE, BLUE.format("cup"), "cup", id="not the red one, the blue cup"),
    ],
)
def test_another_thing(old: str | None, new: str, kind: str) -> None:
    changed = with_other_thing(
        chain(f"{RED_BLOCK}; {GRAB_IT}"), net(old) if old else None, net(new)
    )
    assert changed is not None
    wanted = RED_BLOCK.replace("red", "blue").replace("block", kind)
    assert canonical(changed) == canonical(chain(f"{wanted}; {GRAB_IT}"))


def test_a_thing_that_was_not_mentioned_cannot_be_exchanged() -> None:
    green = net(RED_ONE.replace("red", "green"))
    assert (
        with_other_thing(chain(f"{RED_BLOCK}; {GRAB_IT}"), green, net(BLUE.format("one"))) is None
    )
    assert with_other_thing(chain(LEFT), None, net(BLUE.format("one"))) is None
