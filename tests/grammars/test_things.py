"""What pronouns and repeated descriptions refer to within a sentence."""

from __future__ import annotations

import pytest

from grammars.parse import parse
from kernel.memory.notation import write_meaning


def links_of_last_act(text: str) -> str:
    """The written net, one space between words."""
    return " ".join(" ".join(write_meaning(parse(text).meaning)).split())


@pytest.mark.parametrize(
    ("with_pronoun", "without"),
    [
        (
            "grab the block next to mary then release it",
            "grab the block next to mary then release the block",
        ),
        ("if mary sees a ball grab it", "if mary sees a ball grab the ball"),
        ("if a person is from brazil grab him", "if a person is from brazil grab the person"),
        ("if a child is near a box grab her", "if a child is near a box grab the child"),
    ],
)
def test_a_pronoun_is_the_newest_thing_that_fits(with_pronoun: str, without: str) -> None:
    assert links_of_last_act(with_pronoun) == links_of_last_act(without)


@pytest.mark.parametrize(
    ("with_pronoun", "without"),
    [
        ("if a cup is near a person grab it", "if a cup is near a person grab the cup"),
        ("if a girl is near rick she is happy", "if a girl is near rick the girl is happy"),
        ("if mary sees john say hi to her", "if mary sees john say hi to mary"),
        ("if mary sees john say hi to him", "if mary sees john say hi to john"),
        (
            "if a person is from brazil he likely speaks portuguese",
            "if a person is from brazil the person likely speaks portuguese",
        ),
        (
            "to stack a block drive to the box then release it",
            "to stack a block drive to the box then release the block",
        ),
        ("if a baby is crying rock it", "if a baby is crying rock the baby"),
    ],
)
def test_a_pronoun_is_of_the_right_sort_and_no_landmark(with_pronoun: str, without: str) -> None:
    assert links_of_last_act(with_pronoun) == links_of_last_act(without)


@pytest.mark.parametrize(
    "text",
    [
        "to greet somebody say hi",
        "never grab anybody",
        "before you touch someone say hi",
        "after you touch somebody say hi",
        "if anyone tells you to dance do not",
    ],
)
def test_somebody_in_a_trigger_need_not_be_known_for_a_person(text: str) -> None:
    assert "-ref- somebody" in links_of_last_act(text)
    assert "person" not in links_of_last_act(text)


@pytest.mark.parametrize(
    "text",
    ["when somebody is close say hi", "you may grab someone", "never sing if anyone is asleep"],
)
def test_somebody_elsewhere_is_a_person(text: str) -> None:
    assert "-lex- person" in links_of_last_act(text)
    assert "somebody" not in links_of_last_act(text)


def test_a_pronoun_without_antecedent_is_looked_up() -> None:
    assert "-ref- it" in links_of_last_act("release it")
    assert "-ref- she" in links_of_last_act("her name is janey")


def test_mine_and_yours_are_swapped() -> None:
    assert "-lex- me" in links_of_last_act("never touch my sneakers")
    assert "-lex- you" in links_of_last_act("raise your lift")


def test_a_new_thing_of_a_fact_is_not_looked_up() -> None:
    text = links_of_last_act("Mary has a red hat.")
    assert text.count("FIND[") == 1
    assert text.index("mary") < text.index("hat")


def test_one_is_no_kind_of_thing() -> None:
    assert "one" not in write_meaning(parse("is the red one heavy").meaning)
