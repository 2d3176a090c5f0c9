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
    assert list(operators.for_node("DO", net.new("act", "dance"))) == [dance]


def test_one_about_any_act_is_found_for_every_act(lesson: MakeLesson) -> None:
    operators, net = Operators(), Net()
    anything = lesson(operator("ANTE[ act-1; tell-2 -lex- tell; -cmd-> act-1 ]"))
    operators.add(anything)
    assert list(operators.for_node("ANTE", net.new("act", "whatever"))) == [anything]


def test_a_concluded_word_finds_it_too(lesson: MakeLesson) -> None:
    operators, net = Operators(), Net()
    rotate = lesson(operator("DO[ act-1 -lex- rotate ]"))
    operators.add(rotate)
    act = net.new("act", "turn")
    assert list(operators.for_node("DO", act)) == []
    net.overlay(act, "rotate", BAND_1)
    assert list(operators.for_node("DO", act)) == [rotate]


def test_reactions_are_found_when_their_words_are_in_mind(lesson: MakeLesson) -> None:
    operators, net = Operators(), Net()
    close = lesson(operator("NOTE[ hq-1 -lex- close; -hq-> obj-2 ]"))
    operators.add(close)
    operators.add(lesson(operator("DO[ act-1 -lex- close ]")))
    assert list(operators.for_fact(net)) == []
    net.new("hq", "close")
    assert list(operators.for_fact(net)) == [close]


def test_a_rule_is_no_operator(lesson: MakeLesson) -> None:
    with pytest.raises(TypeError):
        Operators().add(lesson("if: ako-1 -lex- girl; then: ako-2 -lex- person; belief: 1.0"))
