"""Nets read back in English, in both voices, and as a gist."""

from __future__ import annotations

import pytest

from grammars.render import gist, render
from kernel.memory.notation import read

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
        "I will watch for that",
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
        "I will remember that",
        id="an after",
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
        "I will remember that",
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
        "I will remember that",
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
