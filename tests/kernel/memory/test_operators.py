"""The operators in force: found by tag and word, also under a word that a rule concludes."""

from collections.abc import Callable

import pytest

from kernel.memory.lesson import Lesson
from kernel.memory.operators import Operators
from kernel.net.node import BAND_1, Net

MakeLesson = Callable[..., Lesson]


def operator(trigger: str) -> str:
    return f"trig: {trigger}; pref: 1.0; ---"


def test_it_is_found_for_its_tag_and_verb_alone(lesson: MakeLesson) -> None:
    operators, net = Operators(), Net()
    dance = lesson(operator("DO[ act-1 -lex- dance ]"))
    operators.add(dance)
    operators.add(lesson(operator("ANTE[ act-1 -lex- dance ]")))
    operators.add(lesson(operator("DO[ act-1 -lex- shimmy ]")))
    assert list(operators.for_node("DO", net.new("act", "dance"), net)) == [dance]


def test_one_about_any_act_is_found_for_every_act(lesson: MakeLesson) -> None:
    operators, net = Operators(), Net()
    anything = lesson(operator("ANTE[ act-1; tell-2 -lex- tell; -cmd-> act-1 ]"))
    operators.add(anything)
    act = net.new("act", "whatever")
    assert list(operators.for_node("ANTE", act, net)) == []  # nobody has told anything
    net.new("input", "tell", cmd=act)
    assert list(operators.for_node("ANTE", act, net)) == [anything]


def test_a_concluded_word_finds_it_too(lesson: MakeLesson) -> None:
    operators, net = Operators(), Net()
    rotate = lesson(operator("DO[ act-1 -lex- rotate ]"))
    operators.add(rotate)
    act = net.new("act", "turn")
    assert list(operators.for_node("DO", act, net)) == []
    net.overlay(act, "rotate", BAND_1)
    assert list(operators.for_node("DO", act, net)) == [rotate]


def test_reactions_are_found_when_their_words_are_in_mind(lesson: MakeLesson) -> None:
    operators, net = Operators(), Net()
    close = lesson(operator("NOTE[ hq-1 -lex- close; -hq-> obj-2 ]"))
    operators.add(close)
    operators.add(lesson(operator("DO[ act-1 -lex- close ]")))
    thing = net.new("obj")
    assert list(operators.for_facts([thing], net)) == []
    noted = net.new("hq", "close", hq=thing)
    assert list(operators.for_facts([noted], net)) == [close]
    other = net.new("hq", "far", hq=net.new("obj"))
    assert list(operators.for_facts([other], net)) == []


def test_a_fact_that_fits_where_no_word_is_asked_for_finds_it_by_its_neighbour(
    lesson: MakeLesson,
) -> None:
    operators, net = Operators(), Net()
    rick = lesson(operator("NOTE[ act-1 -agt-> obj-2; obj-2 -lex- rick ]"))
    operators.add(rick)
    act = net.new("act", "push", agt=net.new("obj", "rick"))
    assert list(operators.for_facts([act], net)) == [rick]


def test_one_without_any_word_is_found_for_every_fact(lesson: MakeLesson) -> None:
    operators, net = Operators(), Net()
    anything = lesson(operator("NOTE[ hq-1 -hq-> obj-2 ]"))
    operators.add(anything)
    assert list(operators.for_facts([net.new("hq", "red", hq=net.new("obj"))], net)) == [anything]


def test_a_retired_one_is_not_found_and_they_are_counted(lesson: MakeLesson) -> None:
    operators, net = Operators(), Net()
    dance = lesson(operator("DO[ act-1 -lex- dance ]"))
    for _ in range(2):
        operators.add(dance)  # the second takes the place of the first
    act = net.new("act", "dance")
    assert list(operators.for_node("DO", act, net)) == [dance]
    assert len(operators) == 1
    for _ in range(2):
        operators.remove(dance)
    assert list(operators.for_node("DO", act, net)) == []
    assert len(operators) == 0


def test_they_come_in_the_order_of_teaching(lesson: MakeLesson) -> None:
    operators, net = Operators(), Net()
    taught = [lesson(operator(f"DO[ act-1 -lex- {word} ]")) for word in ("b", "a", "c")]
    for each in taught:
        operators.add(each)
    assert list(operators.for_node("DO", net.new("act", "a", "b", "c"), net)) == taught


def test_a_rule_is_no_operator(lesson: MakeLesson) -> None:
    with pytest.raises(TypeError):
        Operators().add(lesson("if: ako-1 -lex- girl; then: ako-2 -lex- person; belief: 1.0"))
