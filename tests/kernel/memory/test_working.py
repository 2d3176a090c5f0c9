"""Working memory: what was told, what is in mind, who is there."""

from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kernel.memory.working import TOLD_LIMIT, WorkingMemory
from kernel.net.graphlet import Graphlet, Sketch
from kernel.net.match import holds
from kernel.net.node import REMEMBERED, WORKING, Node


def quality(word: str, negated: bool = False, belief: float = 1.0) -> Graphlet:
    sketch = Sketch()
    thing = sketch.add("obj")
    return sketch.graphlet(sketch.add("hq", word, hq=thing, negated=negated, belief=belief))


def about(graphlet: Graphlet, node: Node) -> dict[str, Node]:
    (name,) = graphlet.mentioned - graphlet.names
    return {name: node}


@pytest.fixture
def roots() -> list[Node]:
    return []


@pytest.fixture
def memory(roots: list[Node]) -> WorkingMemory:
    return WorkingMemory(lambda: roots, ("gripper",))


def tell(
    memory: WorkingMemory, thing: Node, word: str, negated: bool = False, belief: float = 1.0
) -> Node:
    fact = quality(word, negated, belief)
    _, carrying = memory.tell(fact, about(fact, thing))
    return carrying[0]


def knows(
    memory: WorkingMemory, thing: Node, word: str, negated: bool = False, depth: int = REMEMBERED
) -> bool:
    memory.refresh()
    fact = quality(word, negated)
    return holds(fact, memory.net, depth, about(fact, thing), 0.0)


def test_what_is_told_twice_is_one_fact(memory: WorkingMemory) -> None:
    thing = memory.net.new("obj", "mary")
    first = tell(memory, thing, "tall")
    assert tell(memory, thing, "tall") is first
    assert len(memory.told) == 1


def test_what_is_told_again_is_believed_as_it_was_told_last(memory: WorkingMemory) -> None:
    thing = memory.net.new("obj", "mary")
    tell(memory, thing, "tall", belief=0.3)
    assert tell(memory, thing, "tall").belief == 1.0


def test_the_contrary_takes_it_back(memory: WorkingMemory) -> None:
    thing = memory.net.new("obj", "mary")
    tell(memory, thing, "tall")
    tell(memory, thing, "tall", negated=True)
    assert not knows(memory, thing, "tall")
    assert knows(memory, thing, "tall", negated=True)
    assert len(memory.told) == 1


def test_the_contrary_of_another_thing_takes_nothing_back(memory: WorkingMemory) -> None:
    mary, rick = memory.net.new("obj", "mary"), memory.net.new("obj", "rick")
    tell(memory, mary, "tall")
    tell(memory, rick, "tall", negated=True)
    assert knows(memory, mary, "tall")


def test_a_fact_is_in_mind_while_what_it_is_about_is(
    memory: WorkingMemory, roots: list[Node]
) -> None:
    thing = memory.net.new("obj", "mary")
    tell(memory, thing, "tall")
    memory.changed()
    assert not knows(memory, thing, "tall", depth=WORKING)
    assert knows(memory, thing, "tall")
    roots.append(thing)
    memory.changed()
    assert knows(memory, thing, "tall", depth=WORKING)


def test_a_thousand_facts_and_the_least_recently_mentioned_goes(memory: WorkingMemory) -> None:
    things = [memory.net.new("obj", f"thing{n}") for n in range(TOLD_LIMIT + 1)]
    mains = [tell(memory, thing, "tall") for thing in things[:-1]]
    memory.mention(mains[0])
    tell(memory, things[-1], "tall")
    assert len(memory.told) == TOLD_LIMIT
    assert mains[0] in memory.told
    assert mains[1] not in memory.told
    assert not knows(memory, things[1], "tall")


def test_what_a_retracted_fact_was_about_is_forgotten_with_it(memory: WorkingMemory) -> None:
    before = len(memory.net)
    for number in range(3 * TOLD_LIMIT // 2):
        thing = memory.net.new("obj", f"thing{number}")
        tell(memory, thing, "tall")
        memory.forget([thing])
    assert len(memory.net) <= before + 2 * TOLD_LIMIT


def test_the_speaker_is_me_one_at_a_time(memory: WorkingMemory) -> None:
    memory.person_speaking("rick")
    rick = memory.user
    memory.person_speaking("mary")
    assert list(memory.net.with_word("me")) == [memory.user]
    assert memory.user is not rick
    memory.person_speaking("rick")
    assert memory.user is rick
    memory.person_speaking("")
    assert not memory.user.lex & {"rick", "mary"}


def test_somebody_told_about_is_the_same_when_he_speaks(memory: WorkingMemory) -> None:
    mary = memory.net.new("obj", "mary")
    memory.person_speaking("mary")
    assert memory.user is mary


def test_you_and_me_are_the_robot_and_the_speaker(memory: WorkingMemory) -> None:
    sketch = Sketch()
    you, me = sketch.add("obj", "you"), sketch.add("obj", "me")
    fact = sketch.graphlet(sketch.add("act", "like", agt=you, obj=me), you, me)
    binding, _ = memory.tell(fact, {})
    assert binding[you] is memory.me
    assert binding[me] is memory.user


def test_its_own_parts_are_known_and_no_topics(memory: WorkingMemory) -> None:
    (kind,) = memory.net.with_word("gripper")
    (part,) = kind.to("ako")
    assert memory.is_part(part)
    memory.refresh()
    assert part.level == WORKING


def test_sensed_facts_share_what_they_are_about(memory: WorkingMemory) -> None:
    sketch = Sketch()
    thing = sketch.add("obj")
    close = sketch.add("hq", "close", hq=thing)
    very = sketch.add("deg", "very", deg=close)
    memory.sense("close", sketch.graphlet(close))
    memory.sense("very", sketch.graphlet(very))
    assert holds(sketch.graphlet(very, close), memory.net, WORKING)
    memory.unsense("very")
    assert holds(sketch.graphlet(close), memory.net, WORKING)
    memory.unsense("close")
    memory.unsense("never sensed")
    assert not memory.net.has_word("close")


STEPS = st.lists(
    st.tuples(
        st.sampled_from(("tell", "deny", "retract")), st.integers(0, 2), st.sampled_from("ab")
    ),
    max_size=25,
)


@settings(max_examples=40)
@given(STEPS)
def test_it_never_holds_a_fact_and_its_contrary(steps: list[tuple[str, int, str]]) -> None:
    memory = WorkingMemory(list)
    things = [memory.net.new("obj") for _ in range(3)]
    truth: dict[tuple[int, str], bool] = {}
    for what, index, word in steps:
        if what == "retract":
            for main in [m for m in memory.told if things[index] in m.to("hq") and word in m.lex]:
                memory.retract(main)
            truth.pop((index, word), None)
        else:
            tell(memory, things[index], word, negated=what == "deny")
            truth[index, word] = what == "tell"
        for i, thing in enumerate(things):
            for w in "ab":
                assert knows(memory, thing, w) is (truth.get((i, w)) is True)
                assert knows(memory, thing, w, negated=True) is (truth.get((i, w)) is False)


def test_deriving_after_every_change_is_deriving_from_scratch(
    robot: Any, make_robot: Callable[..., Any]
) -> None:
    rule = "if: ako-1 -lex- girl; -ako-> obj-2; then: ako-3 -lex- person; -ako-> obj-2; belief: 1.0"
    told = ("ako-1 -lex- girl; -ako-> obj-2", "obj-2 -lex- mary")
    robot.teach(rule)
    robot.tell(*told)
    other = make_robot()
    other.tell(*told)
    other.teach(rule)
    person = "ako-1 -lex- person; -ako-> obj-2; obj-2 -lex- mary"
    other.tell("hq-1 -lex- tall; -hq-> obj-2", "obj-2 -lex- mary")
    assert robot.believes(person)
    assert other.believes(person)
