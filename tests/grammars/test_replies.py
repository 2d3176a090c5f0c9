"""Every reply in English: what is shown and what is spoken."""

from __future__ import annotations

import pkgutil
from typing import get_args

import pytest

from grammars import replies
from grammars.errors import NotUnderstoodError
from grammars.nearest import typical_sentence
from grammars.parse import parse
from grammars.replies import Said, discover, say
from grammars.replies.not_understood import LESSON, ORDER
from kernel.memory.lesson import Lesson, Operator, Rule
from kernel.memory.meaning import Question, Social
from kernel.memory.notation import read
from kernel.memory.reply import (
    Answer,
    AskKeep,
    AskWhich,
    FactTaken,
    Failed,
    FeedbackTaken,
    Forgotten,
    Greeted,
    Halted,
    KnownAlready,
    LessonDropped,
    LessonTaken,
    Met,
    NothingToDo,
    Reason,
    Refused,
    Reply,
    Revised,
    Saw,
    TakenBack,
)
from kernel.net.graphlet import Graphlet, Term


def net(text: str) -> Graphlet:
    """A graphlet from one line of items: "act-1 -lex- grab, -obj-> obj-2"."""
    content = read(text.replace(", ", "\n"))
    assert isinstance(content, Graphlet)
    return content


def operator(text: str) -> Operator:
    content = read(text)
    assert isinstance(content, Operator)
    return content


GRAB_MARY = net("act-1 -lex- grab, -obj-> obj-2, obj-2 -lex- mary")
MARY_IS_A_PERSON = net("ako-1 -lex- person, -ako-> obj-2, obj-2 -lex- mary")
HOLDING = net(
    "act-1 -lex- hold, -agt-> obj-2, -obj-> obj-3, obj-2 -lex- you, ako-4 -lex- block, -ako-> obj-3"
)
CLOSE = net("hq-1 -lex- close, -hq-> obj-2")
THE_BLOCK = net("obj-1 -ref- the, ako-2 -lex- block, -ako-> obj-1")
THE_BLOCK_IS_RED = net("hq-3 -lex- red, -hq-> obj-1, ako-2 -lex- block, -ako-> obj-1")
THE_COLOR = net("hq-3 -hq-> obj-1, ako-4 -lex- color, -ako-> hq-3, ako-2 -lex- block, -ako-> obj-1")
GO = net("act-1 -lex- go, -dest-> obj-2, ako-3 -lex- kitchen, -ako-> obj-2, obj-2 -ref- the")
WIDDERSHINS = net("act-1 -lex- turn, dir-2 -lex- widdershins, -dir-> act-1")
DRIVE = net("act-1 -lex- drive, dir-2 -lex- forward, -dir-> act-1")

PEOPLE = read(
    """if: ako-1 -lex- girl
      -ako-> obj-2
then: ako-3 -lex- person
      -ako-> obj-2
belief: 1.0"""
)
KEEP_IT = "Shall I keep it, or cancel?"

NEVER_GRAB = operator(
    """trig: ANTE[ act-1 -lex- grab
        -obj-> obj-2
  ako-3 -lex- person
        -ako-> obj-2 ]
pref: 1.0
---------------
DO[ act-5 -lex- say
          -obj-> txt-6
    txt-6 -str- I'm not allowed to ]
PUNT[ ]"""
)
SALUTE = operator(
    """trig: DO[ act-1 -lex- salute ]
pref: 1.0
---------------
DO[ act-5 -lex- raise ]"""
)
GIRLS = Rule(
    net("ako-1 -lex- girl, -ako-> obj-2"), net("ako-3 -lex- person, -ako-> obj-2"), belief=0.8
)


@pytest.mark.parametrize(
    ("reply", "shown", "spoken"),
    [
        pytest.param(
            LessonTaken(Lesson(1, "procedure", SALUTE)),
            "Okay. To salute, I will raise.",
            "Okay. I know how to salute.",
            id="a procedure: in full on the screen, its gist aloud",
        ),
        pytest.param(
            LessonTaken(Lesson(1, "prohibition", NEVER_GRAB)),
            'Okay. I will never grab a person, instead I will say "I\'m not allowed to".',
            "Okay. I will never grab a person, instead I will say I'm not allowed to.",
            id="a prohibition: aloud in full",
        ),
        pytest.param(
            LessonTaken(Lesson(1, "rule", GIRLS)),
            "Okay. If something is a girl, it is usually a person.",
            "Okay. Girls are usually people.",
            id="a rule: its gist aloud",
        ),
        pytest.param(
            FactTaken(net("ako-1 -lex- girl, -ako-> obj-2"), (net("obj-2 -lex- mary"),)),
            "Okay. Mary is a girl.",
            "Okay. Mary is a girl.",
            id="a fact about something looked up",
        ),
        pytest.param(
            Refused(
                GRAB_MARY,
                Lesson(1, "prohibition", NEVER_GRAB, "Never grab a person.", "freddy"),
                (MARY_IS_A_PERSON,),
            ),
            'I may not grab Mary: Freddy told me "Never grab a person", and Mary is a person.',
            "I may not grab Mary: Freddy told me Never grab a person.",
            id="refused: by whose words, and what it rests on",
        ),
        pytest.param(
            Refused(GRAB_MARY, Lesson(1, "prohibition", NEVER_GRAB)),
            "I may not grab Mary: I was told \"never grab a person but instead say 'I'm not allowed to'\".",
            "I may not grab Mary: I was told never grab a person but instead say 'I'm not allowed to'.",
            id="refused: words and teacher not known",
        ),
        pytest.param(Met("rick"), "Hello Rick.", "Hello Rick.", id="met"),
        pytest.param(
            Met("pixel", robot=True),
            "Okay, my name is Pixel.",
            "Okay, my name is Pixel.",
            id="named",
        ),
        pytest.param(
            Met(""),
            "Okay, I don't know who you are now.",
            "Okay, I don't know who you are now.",
            id="unmet",
        ),
        pytest.param(Greeted(Social("hello"), "mary"), "Hello Mary.", "Hello Mary.", id="hello"),
        pytest.param(Greeted(Social("thanks")), "You're welcome.", "You're welcome.", id="thanks"),
        pytest.param(Halted(True), "I have stopped.", "I have stopped.", id="halted"),
        pytest.param(Halted(False), "I was doing nothing.", "I was doing nothing.", id="idle"),
        pytest.param(
            AskKeep(
                Lesson(2, "rule", PEOPLE),
                "contradicts",
                Lesson(1, "prohibition", NEVER_GRAB, "never grab a person", "mary"),
            ),
            "That contradicts what Mary taught me: never grab a person."
            " Shall I keep both, replace it, or cancel?",
            "That contradicts what Mary taught me: never grab a person."
            " Shall I keep both, replace it, or cancel?",
            id="a contradiction",
        ),
        *(
            pytest.param(
                AskKeep(Lesson(2, "rule", PEOPLE), why),
                f"{told} {KEEP_IT}",
                f"{told} {KEEP_IT}",
                id=why,
            )
            for why, told in (
                ("both", "That can never happen as it asks for something and its opposite."),
                ("always_excepted", "That can never happen as its exception always holds."),
                ("only_itself", "That would never end."),
            )
        ),
        *(
            pytest.param(reply, said, said, id=said)
            for reply, said in (
                (KnownAlready(Lesson(1, "rule", PEOPLE)), "I know that already."),
                (
                    KnownAlready(Lesson(1, "rule", PEOPLE, "", "mary")),
                    "I know that already from Mary.",
                ),
                (LessonDropped(Lesson(1, "rule", PEOPLE)), "Okay, I will not keep that."),
                (
                    Revised(Lesson(1, "rule", PEOPLE)),
                    "Okay. If something is a girl, it is a person.",
                ),
                (Forgotten((), net("act-1 -lex- salute")), "I don't know how to salute."),
                (
                    Forgotten((Lesson(1, "rule", PEOPLE),), net("act-1 -lex- salute")),
                    "I have forgotten how to salute.",
                ),
                (Forgotten((), net("obj-1 -lex- mary")), "I know nothing about Mary."),
                (
                    Forgotten((Lesson(1, "fact", MARY_IS_A_PERSON),), net("obj-1 -lex- mary")),
                    "I have forgotten what I was told about Mary.",
                ),
                (Forgotten(()), "I never learned that."),
                (
                    Forgotten((Lesson(1, "fact", MARY_IS_A_PERSON),)),
                    "I have forgotten that Mary is a person.",
                ),
                (
                    TakenBack((Lesson(1, "fact", MARY_IS_A_PERSON),)),
                    "I take back: Mary is a person.",
                ),
                (
                    TakenBack((), (Lesson(1, "fact", MARY_IS_A_PERSON),)),
                    "That counts again: Mary is a person.",
                ),
                (
                    TakenBack(
                        (Lesson(1, "rule", PEOPLE),) * 3, (Lesson(1, "fact", MARY_IS_A_PERSON),)
                    ),
                    "I take back 3 lessons. That counts again: Mary is a person.",
                ),
                (TakenBack((Lesson(1, "fact", MARY_IS_A_PERSON),) * 4), "I take back 4 things."),
                (TakenBack(moved=(Lesson(1, "rule", PEOPLE),)), "I take that back."),
                (NothingToDo("undo"), "There is nothing to undo."),
                (NothingToDo("revise"), "I don't know what to change."),
                (NothingToDo("repeat"), "There is nothing to repeat."),
                (NothingToDo("answer"), "I did not ask anything."),
                (NothingToDo("motion"), "I can't undo a motion. Tell me what to do instead."),
                (NothingToDo("inborn"), "I can't forget what my body can do."),
                (FeedbackTaken(True), "Thank you."),
                (FeedbackTaken(False, Lesson(1, "rule", PEOPLE)), "I will do that less often."),
                (FeedbackTaken(False), "I am sorry."),
            )
        ),
    ],
)
def test_reply(reply: Reply, shown: str, spoken: str) -> None:
    assert say(reply) == Said(shown, spoken)


@pytest.mark.parametrize(
    ("failure", "said"),
    [
        (Failed(net("act-1 -lex- salute"), "no_way"), "I don't know how to salute."),
        (Failed(None, "no_way"), "I don't know how to do that."),
        (Failed(None, "not_yours", "mary"), "Only Mary or my owner may change that."),
        (Failed(None, "not_yours"), "Only my owner may change that."),
        (
            Failed(WIDDERSHINS, "not_grounded", "widdershins"),
            "I don't know the direction widdershins.",
        ),
        (Failed(net("act-1 -lex- turn"), "not_grounded", "direction"), "You did not say which way to turn."),
        (Failed(GRAB_MARY, "prohibited"), "I may not grab Mary."),
        (Failed(GO, "nothing_found"), "I don't know where the kitchen is."),
        (
            Failed(
                net("act-1 -lex- grab, -obj-> obj-2"),
                "nothing_found",
                about=(net("obj-2 -ref- the, ako-3 -lex- cup, -ako-> obj-2"),),
            ),
            "I don't know where the cup is.",
        ),
        (Failed(None, "nothing_found", "kitchen"), "I don't know where the kitchen is."),
        (Failed(None, "nothing_found", "mary"), "I don't know where Mary is."),
        (Failed(GRAB_MARY, "no_sense"), "I have no way to see that."),
        (Failed(None, "not_so", about=(THE_BLOCK_IS_RED,)), "The block is not red."),
        (Failed(None, "not_so", about=(CLOSE,)), "Nothing is close."),
        (Failed(None, "not_so"), "That is not so."),
        (
            Failed(None, "not_known", about=(THE_BLOCK_IS_RED,)),
            "I could not find out whether the block is red.",
        ),
        (
            Failed(None, "not_known", about=(THE_COLOR,)),
            "I could not find out what color the block is.",
        ),
        (Failed(None, "not_answered", about=(THE_BLOCK,)), "I don't know which block you mean."),
        (Failed(DRIVE, "too_much", "2 meters"), "I can't drive more than 2 meters at once."),
        (Failed(DRIVE, "link_lost"), "I have lost the robot."),
        (Failed(DRIVE, "stopped"), "I stopped driving forward."),
        (Failed(DRIVE, "recursion"), "I can't drive forward as that would never end."),
        (Failed(DRIVE, "conflict", "wheels"), "I can't do two things with my wheels at the same time."),
    ],
)  # fmt: skip
def test_failure(failure: Failed, said: str) -> None:
    assert say(failure) == Said(said, said)


@pytest.mark.parametrize("reason", get_args(Reason))
@pytest.mark.parametrize("act", [None, GRAB_MARY, net("act-1 -lex- grab, -obj-> obj-2")])
def test_every_reason_has_one_sentence(reason: Reason, act: Graphlet | None) -> None:
    shown = say(Failed(act, reason)).shown
    assert shown[0].isupper()
    assert shown.endswith(".")
    assert "-" not in shown, "a net's name leaked"
    assert "_" not in shown, "a reason's name leaked"


PERSON = Question("yesno", MARY_IS_A_PERSON)


@pytest.mark.parametrize(
    ("reply", "said"),
    [
        (Answer(PERSON, "yes"), "Yes, Mary is a person."),
        (Answer(PERSON, "no"), "No, Mary is not a person."),
        (Answer(PERSON, "unknown"), "I don't know whether Mary is a person."),
        (Answer(Question("yesno", HOLDING), "yes"), "Yes, I hold a block."),
        (Answer(Question("yesno", HOLDING), "no"), "No, I do not hold a block."),
        (
            Answer(Question("yesno", net("act-1 -lex- dance"), topic="know_how"), "yes"),
            "Yes, I know how to dance.",
        ),
        (Answer(Question("yesno", DRIVE, topic="did"), "yes"), "Yes, I drove forward."),
        (Answer(Question("yesno", DRIVE, topic="did"), "no"), "No, I did not drive forward."),
        (
            Answer(Question("who", net("obj-1 -lex- me"), topic="identity"), "unknown"),
            "I don't know who you are.",
        ),
        (
            Answer(
                Question("who", net("obj-1 -lex- me"), topic="identity"),
                "found",
                (net("obj-2 -lex- freddy"),),
            ),
            "You are Freddy.",
        ),
        (
            Answer(Question("what", net("act-1 -ref- that"), topic="doing"), "found"),
            "I am doing nothing.",
        ),
        (
            Answer(Question("what", net("act-1 -ref- that"), topic="doing"), "found", (DRIVE,)),
            "I am driving forward.",
        ),
        (
            Answer(
                Question("where", net("obj-1 -ref- the, ako-2 -lex- block, -ako-> obj-1"), "obj-1"),
                "unknown",
            ),
            "I don't know where the block is.",
        ),
        (
            Answer(Question("who", net("obj-1 -lex- mary"), "obj-1"), "found", (MARY_IS_A_PERSON,)),
            "Mary is a person.",
        ),
        (
            Answer(
                Question("who", net("obj-1 -lex- mary"), "obj-1"),
                "found",
                (
                    net(
                        "obj-1 -lex- mary, ako-2 -lex- girl, -ako-> obj-1, hq-3 -lex- sad, -hq-> obj-1,"
                        " ako-4 -lex- person, -ako-> obj-1"
                    ),
                ),
            ),
            "Mary is a girl, sad and a person.",
        ),
        (
            Answer(
                Question(
                    "what",
                    net("loc-3 -lex- behind, -loc-> obj-1, -wrt-> obj-2, obj-2 -lex- you"),
                    "obj-1",
                ),
                "found",
                (
                    net(
                        "obj-1, ako-2 -lex- block, -ako-> obj-1, hq-3 -lex- red, -hq-> obj-1,"
                        " loc-4 -lex- behind, -loc-> obj-1, -wrt-> self-5, self-5 -lex- you"
                    ),
                ),
            ),
            "A red block.",
        ),
        (
            Answer(
                Question(
                    "where",
                    net("loc-1 -loc-> obj-2, obj-2 -ref- the, ako-3 -lex- block, -ako-> obj-2"),
                    "loc-1",
                ),
                "found",
                (
                    net(
                        "loc-1 -lex- behind, -loc-> obj-2, -wrt-> self-4, ako-3 -lex- block, -ako-> obj-2,"
                        " self-4 -lex- you, obj-2"
                    ),
                ),
            ),
            "The block is behind me.",
        ),
    ],
)
def test_answer(reply: Answer, said: str) -> None:
    assert say(reply) == Said(said, said)


def option(*more: str) -> Graphlet:
    """A block as the mind describes it: its own term first."""
    terms = net(", ".join(("ako-2 -lex- block, -ako-> obj-1", *more))).terms
    own = next((term for term in terms if term.name == "obj-1"), Term("obj-1"))
    return Graphlet((own, *(term for term in terms if term is not own)), "obj-1")


RED, BLUE, HEAVY = (option(f"hq-3 -lex- {word}, -hq-> obj-1") for word in ("red", "blue", "heavy"))


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ((RED, BLUE), "Which block: the red one or the blue one?"),
        ((RED, BLUE, HEAVY), "Which block: the red one, the blue one or the heavy one?"),
        ((RED, option()), "Which block: the red one or the other one?"),
        (
            (
                option("hq-3 -lex- red, -hq-> obj-1, deg-4 -lex- very, -deg-> hq-3"),
                option("hq-3 -lex- red, -hq-> obj-1"),
            ),
            "Which block: the very red one or the red one?",
        ),
        (
            (
                option("loc-3 -lex- left, -loc-> obj-1"),
                option(
                    "loc-3 -lex- behind, -loc-> obj-1, -wrt-> obj-5, ako-6 -lex- wall, -ako-> obj-5"
                ),
            ),
            "Which block: the one on the left or the one behind a wall?",
        ),
        (
            (
                option("hq-3 -lex- red, -hq-> obj-1, hq-4 -lex- big, -hq-> obj-1"),
                option("hq-3 -lex- red, -hq-> obj-1, hq-4 -lex- small, -hq-> obj-1"),
            ),
            "Which block: the big one or the small one?",
        ),
        (
            (option("obj-1 -lex- spot"), option("obj-1 -lex- rover")),
            "Which block: Spot or Rover?",
        ),
    ],
)
def test_ask_which(options: tuple[Graphlet, ...], said: str) -> None:
    assert say(AskWhich(THE_BLOCK, options)) == Said(said, said)


@pytest.mark.parametrize(
    ("reply", "said"),
    [
        (Saw(0.12), "Something is 12 centimeters ahead."),
        (Saw(0.011), "Something is 1 centimeter ahead."),
        (Saw(None), "There is nothing ahead of me."),
        (Saw(None, swept=True), "There is nothing near me."),
        (Saw(0.2, 41.6, True), "Something is 20 centimeters away, 42 degrees to the left."),
        (Saw(0.2, -30.0, True), "Something is 20 centimeters away, 30 degrees to the right."),
        (Saw(0.2, 4.0, True), "Something is 20 centimeters ahead."),
    ],
)
def test_saw(reply: Saw, said: str) -> None:
    assert say(reply) == Said(said, said)


OFFER = 'I take orders, as "drive forward", and lessons, as "to dance, turn left then turn right".'


@pytest.mark.parametrize(
    ("error", "shown", "spoken"),
    [
        (
            NotUnderstoodError("zork", unknown_words=("zork",)),
            f"I don't know the word zork. {OFFER}",
            "I don't know the word zork.",
        ),
        (
            NotUnderstoodError("zork a flib", unknown_words=("zork", "flib")),
            f"I don't know the words zork and flib. {OFFER}",
            "I don't know the words zork and flib.",
        ),
        (
            NotUnderstoodError("drive to of", understood="drive to", nearest="drive forward"),
            'I did not understand. I understood as far as "drive to". Did you mean "drive forward"?',
            "I did not understand. Did you mean: drive forward?",
        ),
        (NotUnderstoodError("of of"), f"I did not understand. {OFFER}", "I did not understand."),
        (
            NotUnderstoodError("If interest rates fall", understood="If"),
            'I did not understand. I understood as far as "If". '
            'Sentences like "If something is a girl it is a person" I understand.',
            "I did not understand.",
        ),
    ],
)
def test_not_understood(error: NotUnderstoodError, shown: str, spoken: str) -> None:
    assert say(error) == Said(shown, spoken)


def test_what_is_offered_is_understood() -> None:
    for sentence in (ORDER, LESSON, *map(typical_sentence, ("if", "to", "who", "before", "never"))):
        assert sentence is not None
        parse(sentence)


def test_every_kind_of_reply_has_a_renderer() -> None:
    assert set(get_args(Reply)) <= set(discover())


def test_every_file_registers_a_renderer() -> None:
    modules = {module.name for module in pkgutil.iter_modules(replies.__path__)}
    registered = {renderer.__module__.rpartition(".")[2] for renderer in discover().values()}
    assert modules == registered
