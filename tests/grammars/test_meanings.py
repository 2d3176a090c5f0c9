"""The paper's sentences and the conventions of docs/net.md, net for net."""

from __future__ import annotations

import re

import pytest

from grammars.parse import parse
from kernel.memory.notation import write_meaning


def net(text: str) -> str:
    return re.sub(" +", " ", "\n".join(write_meaning(parse(text).meaning)))


def test_cha_cha_is_the_papers_operator() -> None:
    text = net("To cha-cha drive forward then drive backwards")
    assert text == net("to cha-cha means to drive forward and then drive backward")
    for piece in ("trig: DO[", "-lex- cha-cha", "pref: 1.0", "-lex- forward", "-lex- backward"):
        assert piece in text
    assert text.index("forward") < text.index("backward")


def test_the_prohibition_is_the_papers_operator() -> None:
    text = net("You should never grab a person but instead say I'm not allowed to.")
    for piece in (
        "trig: ANTE[",
        "-lex- grab",
        "-lex- person",
        "-str- I'm not allowed to",
        "PUNT[ ]",
    ):
        assert piece in text
    assert "FIND[" not in text


def test_the_veto_on_rick_matches_any_act_he_orders() -> None:
    text = net("If Rick tells you to do something don't but instead complain.")
    for piece in (
        "trig: ANTE[",
        "-cmd->",
        "-lex- tell",
        "-lex- rick",
        "-lex- you",
        "-lex- complain",
    ):
        assert piece in text
    assert "-lex- do" not in text


def test_the_rule_about_girls_is_the_papers_rule() -> None:
    text = net("If something is a girl it is a person.")
    assert "if:" in text
    assert "then:" in text
    assert text.index("girl") < text.index("person")


SAME = [
    ("Please drive forward.", "drive forward"),
    ("could you please turn left ninety degrees", "turn left 90 degrees"),
    ("back up thirty cm", "drive backward 30 centimeters"),
    ("turn clockwise a hundred and eighty degrees", "turn clockwise 180 degrees"),
    ("pick up the ball", "pick the ball up"),
    ("grab the block that is red", "grab the red block"),
    ("turn a little to the left", "turn left a little"),
    ('say "watch out"', "say watch out"),
    ("uh turn turn left", "turn left"),
    ("turn left i mean right", "turn right"),
    ("Rasie the gripper slwoly.", "raise the gripper slowly"),
    ("if something is very close, back up", "back up if something is very close"),
    ("say bless you when someone sneezes", "when someone sneezes say bless you"),
    ("before driving forward say beep beep", "before you drive forward say beep beep"),
    ("back up after you release the ball", "after you release the ball, back up"),
    ("never grab Mary", "don't ever grab Mary"),
    ("if something is close, don't raise the lift", "don't raise the lift if something is close"),
    ("a girl is a person", "if something is a girl it is a person"),
    ("heavy things are dangerous", "if something is heavy it is dangerous"),
    ("Freddy is Janey's brother.", "freddy is the brother of janey"),
    ("Mary isn't a robot.", "Mary is not a robot"),
    ("only mary may tell you to turn left", "only mary can order you to turn left"),
]


@pytest.mark.parametrize(("one", "other"), SAME)
def test_these_mean_the_same(one: str, other: str) -> None:
    assert net(one) == net(other)
    assert parse(one).kind == parse(other).kind


DIFFERENT = [
    ("drive forward and turn right", "drive forward then turn right"),
    ("before you grab a block open the gripper", "after you grab a block open the gripper"),
    ("never touch a block", "never touch the block"),
    ("don't raise the lift if Mary is near", "don't raise the lift unless Mary is near"),
    ("drive forward slowly then turn left", "drive forward then turn left slowly"),
    ("grab the block next to the cup", "grab the cup next to the block"),
    ("turn toward the ball on the left", "turn left toward the ball"),
    ("To run away, you could drive backward.", "To run away, you must always drive backward."),
    ("cups are sometimes fragile", "cups are usually fragile"),
    ("if something is a toy it is small", "if something is small it is a toy"),
    ("why did you grab Mary", "why didn't you grab Mary"),
    ("where is my cup", "where is your cup"),
    ("john is taller than mary", "mary is taller than john"),
    ("lift the biggest block", "lift the big block"),
    ("say drive forward", "drive forward"),
    ("nothing is close", "something is close"),
]


@pytest.mark.parametrize(("one", "other"), DIFFERENT)
def test_these_mean_something_else(one: str, other: str) -> None:
    assert (parse(one).kind, net(one)) != (parse(other).kind, net(other))


def test_what_is_described_is_looked_up_before_it_is_used() -> None:
    text = net("grab the red block then release it")
    assert text.count("FIND[") == 1
    assert text.index("FIND[") < text.index("grab") < text.index("release")


def test_the_landmark_is_looked_up_first() -> None:
    text = net("grab the block next to the wall")
    assert text.index("wall") < text.index("block")


def test_you_and_me_are_never_looked_up() -> None:
    text = net("turn toward me")
    assert "FIND[" not in text
    assert "-lex- me" in text


def test_and_is_one_play_and_then_binds_looser() -> None:
    text = net("drive forward and raise the lift then turn left")
    assert text.count("PLAY{") == 1
    assert text.index("PLAY{") < text.index("-lex- turn")


@pytest.mark.parametrize(
    ("text", "quote"),
    [
        ("say i am a little teapot short and stout", "i am a little teapot short and stout"),
        ("To complain say I don't take orders from you", "I don't take orders from you"),
        ("say hello there and drive forward", "hello there"),
        ("Say coming through as you drive forward.", "coming through"),
        ("say thank you after you release the ball", "thank you"),
        ('tell mary "lunch is ready".', "lunch is ready"),
        (
            "say to janey the truck will be here in ten minutes",
            "the truck will be here in ten minutes",
        ),
    ],
)
def test_quoted_speech_is_taken_as_said(text: str, quote: str) -> None:
    assert f"-str- {quote}\n" in net(text) + "\n" or f"-str- {quote} ]" in net(text)


def test_what_a_quality_regards_keeps_its_word() -> None:
    assert "-lex- of" in net("Mary is afraid of dogs")
    assert "-lex- to" in net("Peter is married to Gwen")
    assert "-lex- at" in net("Tom is good at chess")
