"""Graphlets and the sketches they are cut from."""

import pytest

from kernel.net.graphlet import Graphlet, Sketch, Term


def test_a_sketch_hands_out_names_that_are_never_the_same() -> None:
    sketch = Sketch()
    names = [sketch.add("act"), sketch.add("obj"), sketch.add("act")]
    assert len(set(names)) == 3
    assert [name.rpartition("-")[0] for name in names] == ["act", "obj", "act"]


def test_links_may_lead_to_several_nodes_and_are_sorted() -> None:
    sketch = Sketch()
    one, two = sketch.add("obj"), sketch.add("obj")
    act = sketch.add("act", "carry", obj=[two, one])
    sketch.link(act, "agt", one)
    sketch.link(act, "agt", one)
    assert sketch.terms[act].links == (("agt", one), ("obj", one), ("obj", two))


def test_a_role_that_is_a_keyword_is_written_with_an_underscore() -> None:
    sketch = Sketch()
    thing = sketch.add("obj")
    assert sketch.terms[sketch.add("own", of_=thing)].links == (("of", thing),)


def test_cutting_keeps_order_and_takes_each_term_once() -> None:
    sketch = Sketch()
    act = sketch.add("act", "drive")
    way = sketch.add("dir", "forward", dir=act)
    cut = sketch.graphlet(act, way, act)
    assert [term.name for term in cut] == [act, way]
    assert cut.words() == {"drive", "forward"}


def test_a_graphlet_knows_what_it_describes_and_what_it_only_mentions() -> None:
    graphlet = Graphlet((Term("dir-2", frozenset({"left"}), links=(("dir", "act-1"),)),), "act-1")
    assert graphlet.names == {"dir-2"}
    assert graphlet.mentioned == {"act-1", "dir-2"}
    assert graphlet.term("dir-2").kind == "dir"
    with pytest.raises(KeyError):
        graphlet.term("act-1")


def test_denying_turns_the_main_term_alone_and_twice_is_nothing() -> None:
    sketch = Sketch()
    thing = sketch.add("obj", "mary")
    quality = sketch.add("hq", "tall", hq=thing)
    graphlet = sketch.graphlet(quality, thing)
    denied = graphlet.denied()
    assert denied.term(quality).negated
    assert not denied.term(thing).negated
    assert denied.denied() == graphlet


def test_renaming_reaches_links_and_the_main_name() -> None:
    sketch = Sketch()
    act = sketch.add("act", "drive")
    way = sketch.add("dir", "left", dir=act)
    renamed = sketch.graphlet(act, way).renamed({act: "act-7"})
    assert renamed.main == "act-7"
    assert renamed.term(way).links == (("dir", "act-7"),)
