"""Nets read back in English, in both voices, and as a gist."""

from __future__ import annotations

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grammars.parse import parse
from grammars.registry import discover
from grammars.render import gist, render
from kernel.managing import whole
from kernel.memory.meaning import Choice, Fact, Meaning, Teach
from kernel.memory.notation import canonical, read, write_meaning
from kernel.memory.reply import AskWhich
from tests.grammars import nets

PROCEDURES = [
    pytest.param(
        """trig: DO[ act-1 -lex- cha-cha ]
           pref: 1.0
           ---------------
           DO[ act-2 -lex- drive
               dir-3 -lex- forward
                     -dir-> act-2 ]
           DO[ act-4 -lex- drive
               dir-5 -lex- backward
                     -dir-> act-4 ]""",
        "to cha-cha, drive forward then drive backward",
        "to cha-cha, I will drive forward then drive backward",
        "I know how to cha-cha",
        id="a procedure",
    ),
    pytest.param(
        """trig: DO[ act-1 -lex- greet
               -obj-> obj-2 ]
           pref: 1.2
           ---------------
           PLAY{
             DO[ act-3 -lex- say
                 -obj-> txt-4
                 -dest-> obj-2
                 txt-4 -str- good day ]
             DO[ act-5 -lex- turn
                 cnt-6 -str- 2
                       -cnt-> act-5
                 mod-7 -lex- slowly
                       -mod-> act-5
                 deg-8 -lex- very
                       -deg-> mod-7 ]
           }""",
        'to greet something, you must always say "good day" to it and turn very slowly twice',
        'to greet something, I must always say "good day" to it and turn very slowly twice',
        "I know how to greet something",
        id="preference, parallel actions, an argument taken up again",
    ),
    pytest.param(
        """trig: NOTE[ hq-1 -lex- close
                 -hq-> obj-2
                 deg-3 -lex- very
                 -deg-> hq-1 ]
           unless: ako-4 -lex- block
                   -ako-> obj-2
           pref: 0.8
           ---------------
           DO[ act-5 -lex- drive
               dir-6 -lex- backward
                     -dir-> act-5
               amt-7 -lex- inch
                     -str- 10
                     -amt-> act-5 ]""",
        "if something is very close, you could drive backward 10 inches unless it is a block",
        "when something is very close, I could drive backward 10 inches unless it is a block",
        "I will drive then",
        id="a reaction with an exception",
    ),
    pytest.param(
        """trig: POST[ act-1 -lex- turn
               dir-2 -lex- left
                     -dir-> act-1 ]
           pref: 1.0
           ---------------
           DO[ act-3 -lex- wait
               amt-4 -lex- second
                     -str- 1
                     -amt-> act-3 ]""",
        "after you turn left, wait 1 second",
        "after I turn left, I will wait 1 second",
        "I will wait 1 second afterwards",
        id="an after",
    ),
    pytest.param(
        """trig: FIND[ obj-1
               ako-2 -lex- ball
                     -ako-> obj-1 ]
           pref: 0.8
           ---------------
           DO[ act-3 -lex- turn
               dir-4 -lex- left
                     -dir-> act-3 ]""",
        "to find a ball, you could turn left",
        "to find a ball, I could turn left",
        "I know how to find that",
        id="how to find a thing",
    ),
    pytest.param(
        """trig: CHK[ hq-1 -lex- heavy
                    -hq-> obj-2
               ako-3 -lex- block
                     -ako-> obj-2 ]
           pref: 1.0
           ---------------
           DO[ act-4 -lex- lift
                     -obj-> obj-2 ]""",
        "to check whether a block is heavy, lift it",
        "to check whether a block is heavy, I will lift it",
        "I know how to check that",
        id="how to check something",
    ),
    pytest.param(
        """trig: FIND[ ako-1 -ako-> obj-2 ]
           pref: 1.0
           ---------------
           FIND[ hq-3 -hq-> obj-2
                 ako-4 -lex- color
                       -ako-> hq-3 ]""",
        "to find out what something is, find out what color it is",
        "to find out what something is, I will find out what color it is",
        "I know how to find that",
        id="how to find out what something is",
    ),
    pytest.param(
        """trig: NOTE[ act-1 -lex- fail
                     -agt-> obj-2
                     -obj-> act-3
               obj-2 -lex- you
               act-3 -lex- grab
                     -obj-> obj-4 ]
           pref: 1.0
           ---------------
           DO[ act-5 -lex- say
                     -obj-> txt-6
               txt-6 -str- oops ]""",
        'if you fail to grab something, say "oops"',
        'when I fail to grab something, I will say "oops"',
        "I will say that then",
        id="what to do about failing",
    ),
]

PROHIBITIONS = [
    pytest.param(
        """trig: ANTE[ act-1 -lex- grab
               -obj-> obj-2
               ako-3 -lex- person
               -ako-> obj-2 ]
           pref: 1.0
           ---------------
           DO[ act-4 -lex- say
               -obj-> txt-5
               txt-5 -str- I'm not allowed to ]
           PUNT[ ]""",
        'never grab a person but instead say "I\'m not allowed to"',
        'I will never grab a person, instead I will say "I\'m not allowed to"',
        "I will not grab a person",
        id="a prohibition with something to do instead",
    ),
    pytest.param(
        """trig: ANTE[ act-1 -lex- touch
               -obj-> obj-2
               ako-3 -lex- sneaker
               -ako-> obj-2
               own-4 -own-> obj-2
               -of-> obj-5
               obj-5 -lex- me ]
           pref: 1.0
           ---------------
           PUNT[ ]""",
        "never touch my sneaker",
        "I will never touch your sneaker",
        "I will not touch your sneaker",
        id="what belongs to the speaker",
    ),
    pytest.param(
        """trig: ANTE[ act-1
               tell-2 -lex- tell
               -agt-> obj-3
               -dest-> obj-4
               -cmd-> act-1
               obj-3 -lex- rick
               obj-4 -lex- you ]
           pref: 1.0
           ---------------
           DO[ act-5 -lex- complain ]
           PUNT[ ]""",
        "if Rick tells you to do something, do not but instead complain",
        "if Rick tells me to do something, I will not, instead I will complain",
        "I will not always obey Rick",
        id="a veto on a speaker",
    ),
    pytest.param(
        """trig: ALLOW[ act-1 -lex- lift
               -obj-> obj-2
               ako-3 -lex- cup
               -ako-> obj-2 ]
           with: hq-4 -lex- empty
               -hq-> obj-2
           pref: 1.0
           ---------------""",
        "you may lift a cup if it is empty",
        "I may lift a cup if it is empty",
        "I may lift a cup",
        id="a permission under a condition",
    ),
]

RULES = [
    pytest.param(
        """if: ako-1 -lex- girl
               -ako-> obj-2
           then: ako-3 -lex- person
               -ako-> obj-2
           belief: 1.0""",
        "if something is a girl, it is a person",
        "if something is a girl, it is a person",
        "girls are people",
        id="a rule",
    ),
    pytest.param(
        """if: ako-1 -lex- girl
               -ako-> obj-2
           then: hq-3 -lex- female
               -hq-> obj-2
           belief: 0.8""",
        "if something is a girl, it is usually female",
        "if something is a girl, it is usually female",
        "girls are usually female",
        id="a belief",
    ),
    pytest.param(
        """if: dir-1 -lex- widdershins
           then: dir-1 -lex- counterclockwise
           belief: 1.0""",
        "widdershins means counterclockwise",
        "widdershins means counterclockwise",
        "widdershins means counterclockwise",
        id="an alias",
    ),
    pytest.param(
        """act-1 -lex- have
           -agt-> obj-2
           -obj-> obj-3
           obj-2 -lex- mary
           ako-4 -lex- hat
           -ako-> obj-3
           hq-5 -lex- red
           -hq-> obj-3""",
        "Mary has a red hat",
        "Mary has a red hat",
        "Mary has a red hat",
        id="a deed as a fact",
    ),
    pytest.param(
        """hq-1 -lex- tall
           -hq-> obj-2
           -than-> obj-3
           obj-2 -lex- john
           obj-3 -lex- me""",
        "John is taller than me",
        "John is taller than you",
        "John is taller than you",
        id="a comparison with the speaker",
    ),
    pytest.param(
        """loc-1 -lex- behind
           -loc-> obj-2
           -wrt-> obj-3
           -neg- yes
           obj-2 -ref- the
           ako-4 -lex- ball
           -ako-> obj-2
           obj-3 -lex- you""",
        "the ball is not behind you",
        "the ball is not behind me",
        "the ball is not behind me",
        id="a denied place",
    ),
]


@pytest.mark.parametrize(
    ("notation", "teacher", "robot", "heart"), [*PROCEDURES, *PROHIBITIONS, *RULES]
)
def test_read_back(notation: str, teacher: str, robot: str, heart: str) -> None:
    content = read(notation)
    assert render(content, "teacher") == teacher
    assert render(content, "robot") == robot
    assert gist(content) == heart
    assert len(heart.split()) <= 6


def same(text: str, kind: str, meaning: Meaning) -> None:
    """The text parses to that kind and to an equal net."""
    back = parse(text)
    assert back.kind == kind, text
    assert write_meaning(back.meaning) == write_meaning(meaning), text


PAPER = """
drive forward; turn right; go to the kitchen; find the cereal box; pick up the block; please dance; grab Mary
drive forward and turn right; to cha-cha drive forward then drive backwards; to shimmy turn left then turn right
to dance cha-cha then shimmy; to turn left rotate left; to complain say I don't take orders from you
to get to Tim's office, go out the door, turn left, then enter the third door on your right
to run away, you could drive backward; if something is very close then drive backwards
close the door whenever you see Mom coming; never touch my sneakers
you should never grab a person but instead say I'm not allowed to
do not show Janey where my phone is but instead tell the squirt to get lost
if Rick tells you to do something don't but instead complain; if something is a girl it is a person
a girl is a person; girls are usually female; widdershins means counterclockwise; turn means rotate
the bottle to the left of the green box is Advil; there is something very close; Mary is a girl; hey, stop that!
"""
SENTENCES = [s.strip() for line in PAPER.strip().splitlines() for s in line.split(";")]
EXAMPLES = [e for form in discover().values() if not form.expected for e in form.examples]


@pytest.mark.parametrize("sentence", dict.fromkeys([*SENTENCES, *EXAMPLES]))
def test_the_teachers_voice_parses_back_to_the_same_net(sentence: str) -> None:
    parsed = parse(sentence)
    same(render(parsed.meaning, "teacher"), parsed.kind, parsed.meaning)


@pytest.mark.parametrize("sentence", dict.fromkeys(EXAMPLES))
def test_the_robots_voice_has_words_for_every_form(sentence: str) -> None:
    said = render(parse(sentence).meaning, "robot")
    assert said
    assert not re.search(r"\b[a-z]+-\d|  |[\[\]{}]", said), "a net's name or a gap leaked"


@pytest.mark.parametrize(
    "sentence",
    [
        "drive faster",
        "turn left more quickly",
        "find the one on the left",
        "grab the red one",
        "grab the dog that is asleep",
        "if something is not red, dance",
        "if nothing is red, dance",
        "if some block is not close, turn left",
        "if no block is close, turn left",
        "if somebody does not answer, beep",
        "if nobody answers, beep",
        "if somebody near the door is not happy, dance",
        "drive until nothing red is close",
        "if a block is close, stop, otherwise drive forward",
        "if no cup is on the table, beep, otherwise dance",
        "why is nothing red",
        "this slipper is my brother's",
        "those slippers are my wife's",
        "this slipper is his",
        "is nothing close",
        "is something not close",
        "do you dance when I sing",
        "are you allowed to touch the vase when nobody watches",
    ],
)
def test_it_is_read_back_in_the_same_words(sentence: str) -> None:
    assert render(parse(sentence).meaning, "teacher") == sentence


@settings(max_examples=25, deadline=None)
@given(st.one_of(nets.commands, nets.inquiries, nets.going_on))
def test_any_command(meaning: Meaning) -> None:
    same(render(meaning, "teacher"), "command", meaning)


@settings(max_examples=60, deadline=None)
@given(
    st.one_of(
        *(nets.procedures, nets.arounds, nets.reactions, nets.reached),
        *(nets.prohibitions, nets.permissions, nets.trusts),
        *(nets.findings, nets.failings, nets.trustings, nets.onlies, nets.aliases),
    )
)
def test_any_operator(meaning: Teach) -> None:
    same(render(meaning, "teacher"), meaning.kind, meaning)


@settings(max_examples=40, deadline=None)
@given(st.one_of(nets.procedures, nets.arounds, nets.reactions, nets.prohibitions))
def test_any_operator_as_it_is_stored(meaning: Teach) -> None:
    """The store keeps the canonical form, in which what has no order is sorted."""
    same(render(canonical(meaning.content), "teacher"), meaning.kind, meaning)


def test_things_are_mentioned_in_the_order_they_are_looked_up() -> None:
    meaning = parse("to zorp, push Mary and grab Rick").meaning
    assert isinstance(meaning, Teach)
    said = render(canonical(meaning.content), "teacher")
    assert said == "to zorp, push Mary and grab Rick"


@settings(max_examples=25, deadline=None)
@given(nets.rules)
def test_any_rule(meaning: Teach) -> None:
    same(render(meaning, "teacher"), "rule", meaning)


@settings(max_examples=25, deadline=None)
@given(st.one_of(nets.facts, nets.news))
def test_any_fact(meaning: Meaning) -> None:
    same(render(meaning, "teacher"), "fact", meaning)


@pytest.mark.parametrize(
    "sentence",
    [
        "the red block is called Bob",
        "this block is called Tim",
        "Mary's cat is called Tom",
        "Ken's wife's bottle is called Poppy",
        "the big red block is heavy",
        "Mary is Rick's sister",
    ],
)
def test_a_fact_as_it_is_kept(sentence: str) -> None:
    """One graphlet, with the descriptions of what it is about."""
    fact = parse(sentence).meaning
    assert isinstance(fact, Fact)
    kept = render(whole(fact), "teacher")
    assert kept == sentence
    again = parse(kept).meaning
    assert isinstance(again, Fact)
    assert whole(again) == whole(fact)


@given(st.one_of(nets.procedures, nets.reactions, nets.prohibitions, nets.permissions, nets.rules))
def test_any_lesson_has_a_gist(meaning: Teach) -> None:
    heart = gist(meaning.content)
    assert 0 < len(heart.split()) <= 6
    assert render(meaning, "robot")


@settings(max_examples=25, deadline=None)
@given(nets.revisions)
def test_any_revision(meaning: Meaning) -> None:
    same(render(meaning, "teacher"), "revision", meaning)


@settings(max_examples=25, deadline=None)
@given(nets.controls)
def test_any_control(meaning: Meaning) -> None:
    same(render(meaning, "teacher"), "control", meaning)


@settings(max_examples=25, deadline=None)
@given(nets.questions)
def test_any_question_whether_something_is_so(meaning: Meaning) -> None:
    same(render(meaning, "teacher"), "question", meaning)


@settings(max_examples=25, deadline=None)
@given(nets.choices)
def test_any_choice(meaning: Choice) -> None:
    """Understood only while the robot asks."""
    asked = AskWhich(meaning.described, (meaning.described,))
    back = parse(render(meaning, "teacher"), expecting=asked)
    assert write_meaning(back.meaning) == write_meaning(meaning)


# Each form with the nets that are drawn for it; social, identity, naming, feedback and refusal have no nets.
DRAWN = {
    "after": nets.arounds,
    "alias": nets.aliases,
    "before": nets.arounds,
    "choice": nets.choices,
    "command": nets.commands,
    "control": nets.controls,
    "fact": nets.facts,
    "finding": nets.findings,
    "permission": nets.permissions,
    "procedure": nets.procedures,
    "prohibition": nets.prohibitions,
    "question": nets.questions,
    "reaction": nets.reactions,
    "revision": nets.revisions,
    "rule": nets.rules,
    "trust": nets.trusts,
}


def test_every_form_with_nets_has_some_drawn() -> None:
    without = {"social", "identity", "naming", "feedback", "refusal"}
    assert set(discover()) - set(DRAWN) == without
