"""What was asked about and what was done; which known thing is meant."""

import pytest

from kernel.action.call import GROUNDINGS
from kernel.action.discover import load_all
from kernel.memory.meant import SAME, grounded, is_like
from kernel.memory.working import WorkingMemory
from tests.kernel.conftest import net

LEFT = "act-1 -lex- turn; dir-2 -lex- left; -dir-> act-1"
GRAB = (
    "act-5 -lex- grab; -obj-> obj-6; ako-7 -lex- block; -ako-> obj-6; hq-8 -lex- red; -hq-> obj-6"
)


@pytest.mark.parametrize(
    ("asked", "done", "like"),
    [
        ("act-1 -lex- turn", LEFT, True),
        (LEFT, "act-1 -lex- turn", False),
        (LEFT.replace("left", "right"), LEFT, False),
        (LEFT.replace("left", "counterclockwise"), LEFT, True),
        (LEFT.replace("turn", "rotate"), LEFT, True),
        (LEFT.replace("-lex- turn", "-lex- turn; -neg- yes"), LEFT, True),
        ("act-1 -lex- turn; -agt-> obj-2; obj-2 -lex- you", LEFT, True),
        ("act-1", LEFT, True),
        ("act-1 -lex- grab", GRAB, True),
        ("act-1 -lex- grab; -obj-> obj-2; obj-2 -ref- it", GRAB, True),
        ("act-1 -lex- grab; -obj-> obj-2; ako-3 -lex- block; -ako-> obj-2", GRAB, True),
        ("act-1 -lex- grab; -obj-> obj-2; ako-3 -lex- cup; -ako-> obj-2", GRAB, False),
        ("act-1 -lex- grab; -obj-> obj-2; obj-2 -lex- mary", GRAB, False),
        (
            "act-1 -lex- say; -obj-> txt-2; txt-2 -str- i'm here",
            "act-1 -lex- say; -obj-> txt-2; txt-2 -str- I'm here!",
            True,
        ),
    ],
)
def test_like(asked: str, done: str, like: bool) -> None:
    assert is_like(net(asked), net(done)) is like


def test_words_for_the_same_deed_are_words_of_the_same_skill() -> None:
    load_all("kernel.grounding")
    verbs = [set(grounding.verbs) for grounding in GROUNDINGS.values()]
    known = set().union(*verbs)
    for words in SAME:
        if words & known:
            assert any(words <= skill for skill in verbs), words


def test_known_things_are_those_with_a_name_or_spoken_of_as_known() -> None:
    memory = WorkingMemory(list)
    mary = memory.net.new("obj", "mary")
    block = memory.net.new("obj")
    memory.net.new("ako", "block", ako=block)
    found = grounded(net("hq-1 -lex- near; -hq-> obj-2; obj-2 -lex- mary"), memory)
    assert found["obj-2"] is mary
    the_block = "hq-1 -lex- near; -hq-> obj-2; obj-2 -ref- the; ako-3 -lex- block; -ako-> obj-2"
    assert grounded(net(the_block), memory)["obj-2"] is block
    assert "obj-2" not in grounded(net(the_block.replace("obj-2 -ref- the; ", "")), memory)
