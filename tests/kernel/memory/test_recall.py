"""What a description refers to."""

import pytest

from kernel.action.chain import Directive
from kernel.memory.recall import is_so, may_assume, missing, referents
from kernel.memory.working import WorkingMemory
from kernel.net.graphlet import Graphlet
from kernel.net.node import Node
from kernel.net.notation import read_terms, tokens


def net(text: str) -> Graphlet:
    return read_terms(tokens(text.replace("; ", "\n")))


@pytest.fixture
def memory() -> WorkingMemory:
    return WorkingMemory(list, ("gripper",))


def thing(memory: WorkingMemory, kind: str, *qualities: str) -> Node:
    node = memory.net.new("obj")
    memory.net.new("ako", kind, ako=node)
    for quality in qualities:
        memory.net.new("hq", quality, hq=node)
    memory.changed()
    return node


def found(memory: WorkingMemory, description: str) -> list[Node]:
    graphlet = net(description)
    return [binding[graphlet.main] for binding in referents(graphlet, memory, {}, 0.5)]


def test_newest_first_and_only_what_fits(memory: WorkingMemory) -> None:
    red, blue = thing(memory, "block", "red"), thing(memory, "block", "blue")
    thing(memory, "ball", "red")
    assert found(memory, "obj-1 -ref- the; ako-2 -lex- block; -ako-> obj-1") == [blue, red]
    assert found(memory, "obj-1; ako-2 -lex- block; -ako-> obj-1; hq-3 -lex- red; -hq-> obj-1") == [
        red
    ]
    memory.net.touch(red)
    assert found(memory, "obj-1; ako-2 -lex- block; -ako-> obj-1") == [red, blue]


def test_one_thing_is_offered_once_however_often_it_fits(memory: WorkingMemory) -> None:
    block = thing(memory, "block", "red", "red")
    assert found(memory, "obj-1; hq-2 -lex- red; -hq-> obj-1") == [block]


def test_it_is_a_thing_spoken_of_not_a_person_here_nor_a_part(memory: WorkingMemory) -> None:
    memory.net.new("obj")
    memory.net.new("act", "drive")
    assert found(memory, "obj-1 -ref- it") == []
    block = thing(memory, "block")
    assert found(memory, "obj-1 -ref- it") == [block]


def test_a_part_of_the_robot_is_found_by_its_name(memory: WorkingMemory) -> None:
    (part,) = found(memory, "obj-1 -ref- the; ako-2 -lex- gripper; -ako-> obj-1")
    assert memory.is_part(part)


DO = Directive("DO", net("act-1 -lex- grab; -obj-> obj-2"))
GO = Directive("DO", net("act-1 -lex- go; -dest-> obj-2"))
SAY = Directive("DO", net("act-1 -lex- say; -dest-> obj-2"))


@pytest.mark.parametrize(
    ("description", "use", "allowed"),
    [
        ("obj-2; ako-3 -lex- block; -ako-> obj-2", DO, True),
        ("obj-2 -lex- mary", DO, True),
        ("obj-2; ako-3 -lex- kitchen; -ako-> obj-2", GO, False),
        ("obj-2 -lex- mary", SAY, True),
        ("obj-2 -ref- it", DO, False),
        ("obj-9 -lex- mary", DO, False),
    ],
)
def test_what_may_be_assumed(description: str, use: Directive, allowed: bool) -> None:
    assert may_assume(net(description), [use]) is allowed


@pytest.mark.parametrize(
    ("description", "words"),
    [
        ("obj-2; ako-3 -lex- kitchen; -ako-> obj-2", "kitchen"),
        ("obj-2 -lex- mary", "mary"),
        ("obj-2 -ref- it", "it"),
    ],
)
def test_what_was_looked_for_in_words(description: str, words: str) -> None:
    assert missing(Directive("FIND", net(description))) == words


def test_what_was_merely_said_is_not_so(memory: WorkingMemory) -> None:
    assert is_so({"a": memory.net.new("hq", "red")})
    assert not is_so({"a": memory.net.new("said", "red")})
