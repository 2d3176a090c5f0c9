"""Verbs are taken for something said only as people use them."""

from __future__ import annotations

import pytest

from grammars.earley import closed_words
from grammars.errors import NotUnderstoodError
from grammars.nearest import english
from grammars.parse import parse
from grammars.vocabulary import BORN, lines, with_verb


@pytest.mark.parametrize(
    "text",
    [
        "sulk puddles",
        "apologize all old men",
        "go the kitchen",
        "yawn outside potato",
        "drive hamster",
        "turn thunders",
        "drive Greta",
        "drive forward block",
        "drive forward a vehicle",
        "thank left",
        "close the gripper clockwise",
        "find forward",
        "turn left right",
        "turn left twice three times",
        "avoid that positions",
        "grab those block",
        "see bluer close fast basement",
        "drop the attitude",
        "stop Ireland",
        "watch nothing",
        "ask no cup who is there",
        "speak Greta",
        "make a person",
        "get",
        "turn left everything in the box",
        "leave out down",
        "find out what sandwich the wall is",
        "grab nobody",
        "drive to no wall",
        "pick the up block",
        "make Freddy",
        "grab each lesson",
        "wait until name is Freddy",
        "shout leaky tomato good",
        "close the door whenever no thanks",
        "repeat the kettle",
        "repeat every cup",
        "free kitchen",
        "meet",
        "find behind the sofa",
        "press on the left",
        "release on",
        "grab around",
        "observe Mary around",
        "halt from the kitchen",
        "turn back up",
        "turn to kettles",
        "go to the last lesson",
        "read walls big letters",
        "hear it faster",
        "see a spoon in an hour",
        "grab the cup that introduces",
        "move red bowl Rosie saw",
        "while the kettle is Elaine turn left",
        "keep glove up until something is close",
        "take the opportunity",
        "in",
        "here",
        "Rick knows the drill",
        "you have a point",
        "it's a small world",
        "the weather may order you around",
        "gravity may order you around",
        "traffic told you to wait",
    ],
)
def test_what_stands_together_by_chance_is_not_understood(text: str) -> None:
    with pytest.raises(NotUnderstoodError):
        parse(text)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("grab block", {"grab", "block"}),
        ("pick up red block", {"pick", "up", "red", "block"}),
        ("grab the cup with nothing in it", {"grab", "cup", "nothing"}),
        ("press the up button", {"press", "up", "button"}),
        ("shout help is on the way", {"help is on the way"}),
        ("go on dancing", {"dance"}),
        ("speak Portuguese", {"speak", "portuguese"}),
        ("could you back up a little robot", {"back", "up", "a little"}),
        ("find out what shape the block is", {"shape", "block"}),
        ("turn right now", {"turn", "right"}),
        ("leave Ireland", {"leave", "ireland"}),
        ("grab Advil", {"grab", "advil"}),
        ("read the letter", {"read", "letter"}),
        ("repeat the song", {"repeat", "song"}),
        ("free the dog", {"free", "dog"}),
        ("observe the kettle", {"observe", "kettle"}),
        ("release it on the table", {"release", "on", "table"}),
        ("turn down the street", {"turn", "down", "street"}),
        ("give people flowers", {"give", "person", "flower"}),
        ("pick up toys Mary dropped", {"pick", "up", "toy"}),
        ("wait until the dog is Rick", {"dog", "rick"}),
        ("put cup on table", {"put", "cup", "on", "table"}),
        ("go to kitchen", {"go", "kitchen"}),
        ("go out the door", {"go", "out", "door"}),
        ("turn the key", {"turn", "key"}),
        ("turn around the chair", {"turn", "around", "chair"}),
        ("push forward the chair", {"push", "forward", "chair"}),
        ("press the on button", {"press", "on", "button"}),
        ("whisper good night to Mary", {"good night", "mary"}),
        ("turn left left", {"turn", "left"}),
        ("back up the truck", {"back", "truck"}),
    ],
)
def test_what_people_say_is(text: str, words: set[str]) -> None:
    assert words <= {part.value for part in parse(text).alist.walk()}


def test_a_taught_verb_is_used_in_any_way() -> None:
    known = with_verb(BORN, "zork")
    for text in ("zork", "zork hamster", "zork Greta left", "zork forward the block"):
        assert parse(text, known).kind == "command"


def test_the_classes_are_of_words_that_are_known_or_written_out() -> None:
    verbs = {verb for line in lines("usage") for verb in line.partition("=")[2].split()}
    assert not {verb for verb in verbs if not BORN.knows(verb)} - closed_words() - english()


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("if it is raining close the window", "reaction"),
        ("you may dance unless my daughter is practicing", "permission"),
        ("the door is ajar", "fact"),
        ("when you are idle say i am bored", "reaction"),
        ("Rick is practicing", "fact"),
    ],
)
def test_what_one_is_or_is_doing_may_be_a_word_that_nobody_taught(text: str, kind: str) -> None:
    assert parse(text).kind == kind


@pytest.mark.parametrize(
    "text", ["that's life", "you are toothless", "i am walrus", "call me later"]
)
def test_a_common_word_is_no_name(text: str) -> None:
    with pytest.raises(NotUnderstoodError):
        parse(text)


@pytest.mark.parametrize(
    "text", ["back up right now", "close the door right now", "raise the lift right now"]
)
def test_right_now_is_no_way(text: str) -> None:
    assert parse(text).meaning == parse(text.removesuffix(" right now")).meaning
