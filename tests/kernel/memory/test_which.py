"""Which things a person has to decide between."""

import pytest

from kernel.memory.which import equal_best
from kernel.net.graphlet import Graphlet, Term
from kernel.net.node import Net, Node

THE = Graphlet((Term("obj-1", ref="the"),), "obj-1")


def things(*described: tuple[str, ...]) -> list[Node]:
    net = Net()
    made = []
    for words in described:
        thing = net.new("obj")
        for word in words:
            net.new("hq", word, hq=thing)
        made.append(thing)
    return made


@pytest.mark.parametrize(
    ("described", "ranks", "equal"),
    [
        ([("red",), ("blue",)], [0, 0], [0, 1]),
        ([("red",), ("blue",)], [4, 4], [0, 1]),
        ([("red",), ("blue",)], [4, 5], []),
        ([("red",), ("blue",), ("big",)], [5, 2, 5], [0, 2]),
        ([("red",), ()], [0, 0], [0, 1]),
        ([("red",), ("red",)], [0, 0], []),
        ([("red",), ("red",), ("blue",)], [0, 0, 0], []),
        ([("red",)], [0], []),
        ([], [], []),
    ],
)
def test_equal_is_of_the_newest_rank_and_can_be_told_apart(
    described: list[tuple[str, ...]], ranks: list[int], equal: list[int]
) -> None:
    nodes = things(*described)
    options = [{"obj-1": node} for node in nodes]
    rank = dict(zip(nodes, ranks, strict=True))
    assert equal_best(THE, options, rank.__getitem__) == tuple(nodes[at] for at in equal)


@pytest.mark.parametrize("ref", ["", "a", "any", "it", "one"])
def test_only_the_claims_that_there_is_one(ref: str) -> None:
    nodes = things(("red",), ("blue",))
    options = [{"obj-1": node} for node in nodes]
    said = Graphlet((Term("obj-1", ref=ref),), "obj-1")
    assert equal_best(said, options, lambda node: 0) == ()
