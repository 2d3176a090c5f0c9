"""Following changes one by one gives what deriving afresh gives, whatever happens."""

from __future__ import annotations

import random
import textwrap
from dataclasses import dataclass, field, replace
from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st

from kernel.memory.lesson import Lesson, Rule
from kernel.memory.notation import read
from kernel.memory.working import WorkingMemory
from kernel.net.graphlet import Graphlet
from kernel.net.match import holds
from kernel.net.node import BAND_1, WORKING, Node
from tests.kernel.memory.halo_oracle import derived, seen

WORDS = ("a", "b", "c", "d")
THINGS = 3


def parsed(text: str) -> Any:
    return read(
        "\n".join(line.strip() for line in textwrap.dedent(text).replace(";", "\n").splitlines())
    )


SHAPES = (  # W, X, Y stand for words
    "if: ako-1 -lex- W; -ako-> obj-2; then: ako-3 -lex- X; -ako-> obj-2;",
    "if: hq-1 -lex- W; -hq-> obj-2; then: ako-3 -lex- X; -ako-> obj-2;",
    "if: ako-1 -lex- W; -ako-> obj-2; then: hq-3 -lex- X; -neg- yes; -hq-> obj-2;",
    "if: ako-1 -lex- W; -ako-> obj-2; hq-3 -lex- X; -hq-> obj-2; then: ako-4 -lex- Y; -ako-> obj-2;",
    "if: ako-1 -lex- W; -ako-> obj-2; hq-5 -lex- X; -hq-> obj-6; then: loc-4 -lex- Y; -loc-> obj-2; -wrt-> obj-6;",
    "if: loc-1 -lex- W; -loc-> obj-2; -wrt-> obj-3; ako-4 -lex- X; -ako-> obj-2; then: ako-5 -lex- Y; -ako-> obj-3;",
    "if: ako-1 -lex- W; -ako-> obj-2; unless: hq-3 -lex- X; -hq-> obj-2; then: ako-4 -lex- Y; -ako-> obj-2;",
    "if: ako-1 -lex- W; -ako-> obj-2; unless: hq-3 -lex- X; -hq-> obj-9; then: hq-4 -lex- Y; -hq-> obj-2;",
    "if: hq-1 -lex- W; then: hq-1 -lex- X;",
    "if: x-1 -lex- W; then: x-1 -lex- X;",
    "if: ako-1 -lex- W; -ako-> obj-2; then: act-3 -lex- X; -agt-> obj-2; -obj-> obj-4; ako-5 -lex- Y; -ako-> obj-4;",
    "if: act-1 -lex- W; -agt-> obj-2; -obj-> obj-3; then: hq-4 -lex- X; -hq-> obj-3;",
    "if: hq-1 -lex- W; -hq-> obj-2; deg-3 -lex- X; -deg-> hq-1; then: ako-4 -lex- Y; -ako-> obj-2;",
    "if: ako-1 -lex- W; -ako-> obj-2; then: hq-3 -lex- X; -hq-> obj-2; deg-4 -lex- Y; -deg-> hq-3;",
    "if: x-1 -hq-> obj-2; ako-3 -lex- W; -ako-> obj-2; then: ako-4 -lex- X; -ako-> obj-2;",
    "if: x-1 -hq-> obj-2; x-3 -loc-> obj-2; then: ako-4 -lex- X; -ako-> obj-2;",
    "if: hq-1 -lex- W; -neg- yes; -hq-> obj-2; then: ako-3 -lex- X; -neg- yes; -ako-> obj-2;",
    "if: obj-1 -lex- you; hq-2 -lex- W; -hq-> obj-1; then: hq-3 -lex- X; -hq-> obj-1;",
)  # fmt: skip
FACTS = (
    "ako-1 -lex- W; -ako-> obj-2",
    "hq-1 -lex- W; -hq-> obj-2",
    "loc-1 -lex- W; -loc-> obj-2; -wrt-> obj-3",
    "act-1 -lex- W; -agt-> obj-2; -obj-> obj-3",
    "hq-1 -lex- W; -hq-> obj-2; deg-4 -lex- X; -deg-> hq-1",
)
BELIEFS = (1.0, 1.0, 0.8, 0.5, 0.3, 0.15)


def filled(shape: str, words: tuple[str, ...]) -> str:
    for place, word in zip("WXY", words, strict=True):
        shape = shape.replace(f"-lex- {place}", f"-lex- {word}")
    return shape


@dataclass
class World:
    """A working memory with three things, some of which are in attention, and a few rules."""

    foci: list[dict[Node, None]] = field(default_factory=list)
    taught: list[Lesson] = field(default_factory=list)
    count: int = 0

    def __post_init__(self) -> None:
        self.memory = WorkingMemory(lambda: [n for focus in self.foci for n in focus], ("gripper",))
        self.things = [self.memory.net.new("obj") for _ in range(THINGS - 1)]
        self.things.append(self.memory.net.new("obj", "d"))
        self.things.append(self.memory.me)
        self.foci.append(dict.fromkeys(self.things))

    def do(self, what: str, one: int, two: int, words: tuple[str, ...], belief: float) -> None:
        memory = self.memory
        thing, other = self.things[one % 4], self.things[two % 4]
        match what:
            case "tell" | "deny":
                fact = parsed(filled(FACTS[one % len(FACTS)], words))
                assert isinstance(fact, Graphlet)
                terms = fact.terms
                if what == "deny":
                    fact = fact.denied()
                elif belief < 1:
                    terms = tuple(replace(t, belief=belief) for t in terms)
                    fact = Graphlet(terms, fact.main)
                things = {"obj-2": thing, "obj-3": self.things[(one + 1 + two % 3) % 4]}
                memory.tell(fact, {n: t for n, t in things.items() if n in fact.mentioned})
            case "retract" if memory.told:
                memory.retract(list(memory.told)[one % len(memory.told)])
            case "teach":
                rule = parsed(filled(SHAPES[one % len(SHAPES)], words) + f"belief: {belief}")
                assert isinstance(rule, Rule)
                self.count += 1
                self.taught.append(Lesson(self.count, "rule", rule))
                memory.rules.add(self.taught[-1])
            case "retire" if self.taught:
                memory.rules.remove(self.taught.pop(one % len(self.taught)))
            case "weigh" if self.taught:
                memory.rules.believe(self.taught[one % len(self.taught)], belief)
            case "focus":
                self.foci.append({thing: None, other: None})
            case "mention" if self.foci and memory.halo.nodes:
                nodes = memory.halo.nodes
                self.foci[two % len(self.foci)][nodes[one % len(nodes)]] = None
            case "fade" if self.foci:
                memory.forget(
                    [n for n in self.foci.pop(one % len(self.foci)) if n not in self.things]
                )
            case "sense":
                memory.sense(words[0], parsed(filled(FACTS[1], words)))
            case "unsense":
                memory.unsense(words[0])
            case "name":
                memory.net.name(thing, words[0])
            case "unname" if thing is not memory.me:
                memory.net.unname(thing, words[0])
            case "promote" if self.foci:
                memory.refresh()
                overlaid = [(n, w) for n in memory.net for w in sorted(n.halo_lex)]
                items = [(n, "") for n in memory.halo.nodes] + overlaid
                if items:
                    memory.promote([items[one % len(items)]], self.foci[two % len(self.foci)])
        memory.changed()


OPERATIONS = (
    "tell tell tell tell deny teach teach teach retract retire weigh focus fade sense unsense name unname"
    " promote promote mention"
).split()


# Steps drawn by chance reach further than those that hypothesis makes small on purpose.
@settings(max_examples=80, deadline=None)
@given(st.randoms(use_true_random=True))
def test_the_halo_is_what_deriving_afresh_would_give(chance: random.Random) -> None:
    world = World()
    every = chance.randint(1, 3)
    for number in range(chance.randint(5, 40)):
        words = tuple(chance.choice(WORDS) for _ in range(3))
        world.do(
            chance.choice(OPERATIONS),
            chance.randrange(40),
            chance.randrange(40),
            words,
            chance.choice(BELIEFS),
        )
        if number % every:
            continue  # several changes at once
        world.memory.refresh()
        assert seen(world.memory) == derived(world.memory)
        check_levels(world)
    world.memory.refresh()
    followed = seen(world.memory, exactly=True)
    world.memory.rebuild()
    assert seen(world.memory, exactly=True) == followed


def check_levels(world: World) -> None:
    """In mind is what attention reaches, worked out from scratch."""
    memory = world.memory
    told = {n for group in memory.told.values() for n in group}
    sensed = {n for group in memory._sensed.values() for n in group}
    kept = told | sensed | memory._born
    roots = {memory.me, memory.user, *sensed, *(n for f in world.foci for n in f)}
    reached: set[Node] = set()
    pending = [n for n in roots if n in memory.net]
    while pending:
        node = pending.pop()
        if node in reached or node in memory.halo.nodes:
            continue
        reached.add(node)
        pending += [other for _, other in node.links]
        pending += [other for _, other in node.into if other in kept]
    in_mind = {n for n in memory.net if n.level == WORKING}
    assert in_mind == reached


def test_a_broken_rule_of_two_bands_would_be_noticed() -> None:
    """The oracle itself: one step, then two, then no third."""
    world = World()
    for words in (("a", "b", "c"), ("b", "c", "d"), ("c", "d", "a")):
        world.do("teach", 0, 0, words, 1.0)
    world.do("tell", 0, 0, ("a", "a", "a"), 1.0)
    world.memory.refresh()
    assert len(derived(world.memory)) == 2
    pattern = parsed("ako-1 -lex- b; -ako-> obj-2")
    assert holds(pattern, world.memory.net, BAND_1)
