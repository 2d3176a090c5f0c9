"""The plain data of a parse (service.md)."""

from __future__ import annotations

from grammars.describe import describe
from grammars.parse import parse


def test_a_procedure() -> None:
    told = describe(parse("To cha-cha drive forward then drive backwards"))
    assert told["kind"] == "procedure"
    assert {"cha-cha", "drive", "forward", "backward"} <= set(told["words"])
    assert (told["steps"], told["parallel"], told["preference"]) == (2, False, 1.0)
    assert told["trigger"] == ["cha-cha"]
    assert told["belief"] is None


def test_numbers_are_digits_and_look_ups_are_no_steps() -> None:
    told = describe(parse("grab the red block then back up thirty centimeters"))
    assert {"30", "centimeter", "red", "block"} <= set(told["words"])
    assert told["steps"] == 2


def test_polarity_question_and_unknown_words() -> None:
    assert describe(parse("the blue block is not heavy"))["negated"] is True
    assert describe(parse("are you holding a block"))["ask"] == "yesno"
    assert describe(parse("grab the flibbit"))["unknown_words"] == ["flibbit"]
    assert describe(parse("never touch my sneakers"))["negated"] is False


def test_a_word_that_stands_for_a_sentence_lists_itself_alone() -> None:
    assert describe(parse("forward"))["words"] == ["forward"]
