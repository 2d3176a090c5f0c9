"""Words and their forms: what inflection makes, analysis takes back."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grammars.morphology import (
    Category,
    Reading,
    article,
    comparative,
    gerund,
    lemmas,
    participle,
    past,
    plural,
    readings,
    superlative,
    third_person,
    with_article,
)

# Shapes most like trouble: final e, y, doubled and sibilant consonants, hyphens.
_PIECES = [
    "b",
    "dr",
    "ch",
    "sh",
    "st",
    "gl",
    "tw",
    "qu",
    "s",
    "x",
    "a",
    "e",
    "i",
    "o",
    "u",
    "ee",
    "oa",
    "y",
]
_ENDS = [
    "e",
    "y",
    "ay",
    "ie",
    "ss",
    "x",
    "ch",
    "sh",
    "z",
    "ll",
    "p",
    "t",
    "ck",
    "er",
    "le",
    "o",
    "-cha",
    "w",
]
_WORDS = st.builds(
    lambda parts, end: "".join(parts) + end,
    st.lists(st.sampled_from(_PIECES), min_size=1, max_size=4),
    st.sampled_from(_ENDS),
)


@pytest.mark.parametrize(
    ("word", "category", "lemma"),
    [
        ("drives", "verb", "drive"),
        ("driving", "verb", "drive"),
        ("drove", "verb", "drive"),
        ("driven", "verb", "drive"),
        ("turning", "verb", "turn"),
        ("hopping", "verb", "hop"),
        ("hoping", "verb", "hope"),
        ("shimmies", "verb", "shimmy"),
        ("cha-chaing", "verb", "cha-cha"),
        ("twizzling", "verb", "twizzle"),
        ("flibbited", "verb", "flibbit"),
        ("falling", "verb", "fall"),
        ("seeing", "verb", "see"),
        ("gave", "verb", "give"),
        ("is", "verb", "be"),
        ("were", "verb", "be"),
        ("picking up", "verb", "pick up"),
        ("blocks", "noun", "block"),
        ("boxes", "noun", "box"),
        ("people", "noun", "person"),
        ("sneakers", "noun", "sneaker"),
        ("buses", "noun", "bus"),
        ("houses", "noun", "house"),
        ("ladies", "noun", "lady"),
        ("class", "noun", "class"),
        ("feet", "noun", "foot"),
        ("bigger", "adjective", "big"),
        ("biggest", "adjective", "big"),
        ("happier", "adjective", "happy"),
        ("nicer", "adjective", "nice"),
        ("best", "adjective", "good"),
        ("backwards", "adverb", "backward"),
        ("slowly", "adverb", "slowly"),
    ],
)
def test_first_lemma(word: str, category: Category, lemma: str) -> None:
    assert lemmas(word, category)[0] == lemma


def test_a_reading_names_its_form() -> None:
    assert readings("turning", "verb")[0] == Reading("turn", "gerund")
    assert readings("biggest", "adjective")[0] == Reading("big", "superlative")
    assert {reading.form for reading in readings("turned", "verb")} >= {"past", "participle"}
    assert readings("drive", "verb")[0] == Reading("drive", "base")


@pytest.mark.parametrize(
    ("verb", "forms"),
    [
        ("drive", "drives drove driven driving"),
        ("stop", "stops stopped stopped stopping"),
        ("cha-cha", "cha-chas cha-chaed cha-chaed cha-chaing"),
        ("carry", "carries carried carried carrying"),
        ("lie", "lies lay lain lying"),
        ("open", "opens opened opened opening"),
        ("begin", "begins began begun beginning"),
        ("visit", "visits visited visited visiting"),
        ("push", "pushes pushed pushed pushing"),
        ("see", "sees saw seen seeing"),
        ("be", "is was been being"),
    ],
)
def test_forms_of_verbs(verb: str, forms: str) -> None:
    assert f"{third_person(verb)} {past(verb)} {participle(verb)} {gerund(verb)}" == forms


@pytest.mark.parametrize(
    ("adjective", "more", "most"),
    [
        ("tall", "taller", "tallest"),
        ("big", "bigger", "biggest"),
        ("heavy", "heavier", "heaviest"),
        ("large", "larger", "largest"),
        ("dangerous", "more dangerous", "most dangerous"),
        ("good", "better", "best"),
        ("yellow", "yellower", "yellowest"),
    ],
)
def test_degrees(adjective: str, more: str, most: str) -> None:
    assert (comparative(adjective), superlative(adjective)) == (more, most)


@pytest.mark.parametrize(
    ("phrase", "wanted"),
    [
        ("cup", "a cup"),
        ("umbrella", "an umbrella"),
        ("hour", "an hour"),
        ("unicorn", "a unicorn"),
        ("uninteresting box", "an uninteresting box"),
        ("one-armed man", "a one-armed man"),
        ("Advil bottle", "an Advil bottle"),
    ],
)
def test_article(phrase: str, wanted: str) -> None:
    assert with_article(phrase) == wanted


def test_a_compound_is_inflected_on_the_right_word() -> None:
    assert plural("cereal box") == "cereal boxes"
    assert gerund("let go") == "letting go"
    assert third_person("run away") == "runs away"


@given(_WORDS)
def test_what_inflection_makes_analysis_takes_back(word: str) -> None:
    for inflected in (third_person(word), past(word), participle(word), gerund(word)):
        assert word in lemmas(inflected, "verb")
    assert word in lemmas(plural(word), "noun")
    for graded in (comparative(word), superlative(word)):
        assert graded.startswith(("more ", "most ")) or word in lemmas(graded, "adjective")


@given(st.text(max_size=20))
def test_no_text_breaks_it(text: str) -> None:
    for category in ("verb", "noun", "adjective", "adverb"):
        assert text in lemmas(text, category) or text.endswith("wards")
    assert article(text) in ("a", "an")
