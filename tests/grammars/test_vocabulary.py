"""The lexicon, and what lessons add to it."""

from __future__ import annotations

import pytest

from grammars.earley import closed_words
from grammars.parse import parse
from grammars.source import CATEGORIES
from grammars.vocabulary import BORN, extended, from_policy, lines, set_phrases
from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Teach


def taught(*sentences: str) -> list[Lesson]:
    lessons = []
    for ident, sentence in enumerate(sentences, 1):
        meaning = parse(sentence).meaning
        assert isinstance(meaning, Teach)
        lessons.append(Lesson(ident, meaning.kind, meaning.content, sentence))
    return lessons


@pytest.mark.parametrize(
    ("word", "category", "lemma"),
    [
        ("drives", "VERBS", "drive"),
        ("driving", "VERBING", "drive"),
        ("cups", "NOUNS", "cup"),
        ("people", "NOUNS", "person"),
        ("bigger", "ADJER", "big"),
        ("biggest", "ADJEST", "big"),
        ("backwards", "DIR", "backward"),
        ("inches", "UNIT", "inch"),
        ("mary", "PROPER", "mary"),
        ("saw", "VERBED", "see"),
    ],
)
def test_a_word_knows_its_lemma(word: str, category: str, lemma: str) -> None:
    assert BORN.readings(word)[category] == lemma


def test_every_category_is_a_terminal_and_every_word_file_is_lower_case() -> None:
    used = {category for word in BORN.everything for category in BORN.readings(word)}
    assert used <= {*CATEGORIES, *set_phrases()}
    for name in ("verbs", "nouns", "adjectives", "manners", "directions", "names", "phrases"):
        for line in lines(name):
            words = line if name != "phrases" else line.partition("=")[2]
            assert words == words.lower(), line


def test_the_lexicon_is_of_a_useful_size() -> None:
    assert len(BORN.words("NOUN")) > 500
    assert len(BORN.words("ADJ")) > 180
    assert len(BORN.words("VERB")) > 200
    assert len(BORN.words("PROPER")) > 200


def test_words_written_out_in_rules_are_plain() -> None:
    assert all(word == word.lower() for word in closed_words())


def test_a_taught_verb_is_a_command_afterwards() -> None:
    vocabulary = from_policy(taught("to twizzle turn left twice then turn right"))
    assert parse("twizzle", vocabulary).kind == "command"
    assert parse("to frob twizzle then turn left", vocabulary).kind == "procedure"
    assert "twizzle" in vocabulary.words("VERB")
    assert "twizzle" not in BORN.words("VERB")


def test_a_taught_verb_of_two_words_is_a_command_afterwards() -> None:
    vocabulary = from_policy(taught('Whenever I say "make way", back up and say sorry.'))
    parsed = parse("make way", vocabulary)
    assert parsed.kind == "command"
    assert "act=make way" in str(parsed.alist)


def test_a_taught_direction_and_verb_alias_are_known_afterwards() -> None:
    vocabulary = from_policy(
        taught("widdershins means counterclockwise", "zwirl means turn", "ruber means red")
    )
    assert parse("turn widdershins", vocabulary).unknown_words == ()
    assert parse("zwirl to the right slowly", vocabulary).kind == "command"
    assert parse("grab the ruber block", vocabulary).unknown_words == ()


def test_a_new_kind_is_a_noun_afterwards() -> None:
    vocabulary = from_policy(taught("a wug is a person"))
    assert parse("never grab a wug", vocabulary).unknown_words == ()


def test_the_size_of_the_vocabulary_costs_nothing() -> None:
    many = taught(*(f"to blorp{'ab'[i % 2] * (i + 1)} turn left" for i in range(30)))
    assert from_policy(many).born is BORN.born


def test_one_lesson_after_another_teaches_the_words_of_all() -> None:
    lessons = taught(
        "to zork drive forward",
        "widdershins means counterclockwise",
        "snatch means grab",
        "if something is a wug it is a person",
        "to zork a block turn left",
    )
    grown = BORN
    for lesson in lessons:
        grown = extended(grown, [lesson])
    assert grown == from_policy(lessons)
    assert extended(grown, lessons) is grown
    assert not BORN.knows("zork")
