"""The net of memory: what is indexed is what is there."""

from hypothesis import given
from hypothesis import strategies as st

from kernel.net.describing import describe
from kernel.net.graphlet import Sketch
from kernel.net.node import BAND_1, BAND_2, REMEMBERED, WORKING, Net, instantiate

WORDS = ("a", "b", "c")


def test_a_node_is_found_by_each_of_its_words() -> None:
    net = Net()
    node = net.new("obj", "mary", "mom")
    assert list(net.with_word("mary")) == list(net.with_word("mom")) == [node]
    net.unname(node, "mom")
    assert not net.has_word("mom")


def test_a_concluded_word_is_known_from_its_band_on_and_goes_without_a_trace() -> None:
    net = Net()
    node = net.new("act", "turn")
    net.overlay(node, "rotate", BAND_2)
    assert node.words() == {"turn", "rotate"}
    assert [node.known_as("rotate", depth) for depth in (WORKING, BAND_1, BAND_2)] == [
        False,
        False,
        True,
    ]
    assert net.has_word("rotate")
    net.lift(node, "rotate", BAND_2)
    assert node.words() == {"turn"}
    assert not net.has_word("rotate")


def test_a_word_that_two_bands_conclude_goes_with_the_second() -> None:
    net = Net()
    node = net.new("act", "turn")
    net.overlay(node, "rotate", BAND_1, 0.3)
    net.overlay(node, "rotate", BAND_2, 0.9)
    assert not node.known_as("rotate", BAND_1, 0.5)
    assert node.known_as("rotate", BAND_2, 0.5)
    net.lift(node, "rotate", BAND_1)
    assert net.has_word("rotate")
    net.lift(node, "rotate", BAND_2)
    net.lift(node, "rotate", BAND_2)
    assert not net.has_word("rotate")


def test_every_change_is_noted_once() -> None:
    net = Net()
    thing, other = net.new("obj", "mary"), net.new("obj")
    changes = net.take_changes()
    assert list(changes.extended) == [thing, other]
    assert not net.changes
    net.link(thing, "near", other)
    net.believe(other, 0.5)
    net.unname(thing, "mary")
    changes = net.take_changes()
    assert (list(changes.extended), list(changes.altered)) == ([thing], [other, thing])
    assert list(changes.words) == ["mary"]
    net.place(other, REMEMBERED)
    net.drop(other)
    changes = net.take_changes()
    assert (list(changes.altered), list(changes.dropped)) == ([thing], [other])


def test_lifting_conclusions_leaves_a_word_that_was_told_meanwhile() -> None:
    net = Net()
    node = net.new("act", "turn")
    net.overlay(node, "rotate", BAND_1)
    net.name(node, "rotate")
    net.lift(node, "rotate", BAND_1)
    assert list(net.with_word("rotate")) == [node]


def test_dropping_a_node_cuts_every_link_to_it() -> None:
    net = Net()
    thing = net.new("obj")
    kind = net.new("ako", "block", ako=thing)
    quality = net.new("hq", "red", hq=thing)
    net.drop(kind)
    net.drop(kind)
    assert list(thing.modifiers("ako")) == []
    assert list(thing.modifiers("hq")) == [quality]
    net.drop(thing)
    assert quality.links == []
    assert list(net) == [quality]


def test_instantiating_makes_what_is_new_and_leaves_what_is_bound_alone() -> None:
    sketch = Sketch()
    thing = sketch.add("obj", "ball")
    kind = sketch.add("ako", "toy", ako=thing)
    net = Net()
    known = net.new("obj", "sphere")
    bound = instantiate(net, sketch.graphlet(kind, thing), {thing: known})
    assert known.words() == {"sphere"}
    assert list(bound[kind].to("ako")) == [known]
    assert len(net) == 2


def test_describing_a_thing_tells_what_modifies_it_and_who_told_is_left_out() -> None:
    net = Net()
    thing = net.new("obj")
    kind = net.new("ako", "block", ako=thing)
    quality = net.new("hq", "close", hq=thing)
    degree = net.new("deg", "very", deg=quality)
    net.new("act", "grab", obj=thing)
    told = describe(thing)
    assert told.main == thing.name
    assert told.names == {thing.name, kind.name, quality.name, degree.name}


def test_a_description_is_bounded_and_whole() -> None:
    net = Net()
    thing = net.new("obj")
    for _ in range(100):
        net.new("hq", "red", hq=thing)
    told = describe(thing, limit=10)
    assert len(told.terms) <= 10
    assert told.mentioned == told.names


@given(st.lists(st.tuples(st.sampled_from(["new", "name", "unname", "overlay", "lift", "drop"]),
                          st.integers(0, 5), st.sampled_from(WORDS)), max_size=40))  # fmt: skip
def test_the_index_is_always_what_a_search_would_find(steps: list[tuple[str, int, str]]) -> None:
    net = Net()
    for what, index, word in steps:
        nodes = list(net)
        node = nodes[index % len(nodes)] if nodes else None
        if what == "new" or node is None:
            net.new("obj", word)
        elif what == "lift":
            net.lift(node, word, BAND_1)
        elif what == "drop":
            net.drop(node)
        elif what == "name":
            net.name(node, word)
        elif what == "unname":
            net.unname(node, word)
        else:
            net.overlay(node, word, BAND_1)
        for each in WORDS:
            assert set(net.with_word(each)) == {n for n in net if each in n.words()}
