"""Near words and near sentences."""

from __future__ import annotations

from grammars.nearest import near_words, nearest_sentence

WORDS = ("turn", "run", "lift", "left", "raise", "what", "wait", "hat", "the")


def test_the_likeliest_slip_comes_first() -> None:
    assert near_words("trun", WORDS)[0] == "turn"
    assert near_words("lfit", WORDS)[0] == "lift"
    assert near_words("wat", WORDS)[0] in ("what", "wait")


def test_short_and_far_words_have_no_neighbours() -> None:
    assert near_words("xy", WORDS) == []
    assert near_words("elephant", WORDS) == []


def test_the_nearest_sentence_is_an_example_or_nothing() -> None:
    assert nearest_sentence("drive forwards now") == "drive forward"
    assert nearest_sentence("colourless green ideas sleep furiously") is None
