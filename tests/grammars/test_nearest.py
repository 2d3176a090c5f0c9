"""Near words and near sentences."""

from __future__ import annotations

from grammars.nearest import near_words, nearest_sentence

WORDS = ("turn", "run", "lift", "left", "raise", "what", "wait", "hat", "the")


def test_the_likeliest_slip_comes_first() -> None:
    assert near_words("trun", WORDS) == ["turn"]
    assert near_words("lfit", WORDS) == ["lift"]
    assert near_words("rasie", WORDS) == ["raise"]


def test_a_very_short_word_may_only_be_one_that_builds_sentences() -> None:
    assert near_words("wat", WORDS, {"what"}) == ["what"]
    assert near_words("tur", WORDS) == []


def test_a_wrong_letter_is_as_likely_another_word() -> None:
    assert near_words("zork", ("work",)) == near_words("zork", ("work",), likely=False) == []
    assert near_words("tail", ("nail",), likely=False) == []
    assert near_words("drife", ("drive",)) == []
    assert near_words("drife", ("drive", "drove"), likely=False) == ["drive"]
    assert near_words("pencill", ("pencil",)) == ["pencil"]


def test_a_word_of_english_is_no_typo() -> None:
    for word in ("hurts", "fro"):
        assert near_words(word, ("hurls", "for"), {"for"}) == []
        assert near_words(word, ("hurls", "for"), likely=False) == []


def test_however_short_what_has_no_vowel_or_one_letter_of_two_is_a_typo() -> None:
    assert near_words("grb", ("grab", "crab")) == ["grab"]
    assert near_words("bal", ("ball", "bail")) == ["ball"]
    assert near_words("lef", ("left",)) == []


def test_short_and_far_words_have_no_neighbours() -> None:
    assert near_words("xy", WORDS) == []
    assert near_words("elephant", WORDS) == []


def test_the_nearest_sentence_is_an_example_or_nothing() -> None:
    assert nearest_sentence("drive forwards now") == "drive forward"
    assert nearest_sentence("colourless green ideas sleep furiously") is None
