"""What may be said, as the recognisers get it."""

from __future__ import annotations

import pytest

from grammars.drawn import Deal, Draw, words
from grammars.heard import SILENT, kind
from grammars.language import OF_EACH_WORD, Language, language
from grammars.registry import discover
from grammars.vocabulary import BORN, Vocabulary

TAUGHT = Vocabulary(BORN.born, {"zork": {"VERB": "zork"}, "blick": {"NOUN": "blick"}})


@pytest.fixture(scope="module")
def born() -> Language:
    return language()


def test_every_word_that_is_listened_for_is_likely(born: Language) -> None:
    """A recogniser that learns from phrases hears no other words."""
    likely = {word for said in (*born.typical, *born.likely) for word in said.split()}
    assert not {word for word in born.listed.words - likely if "'" not in word}
    assert len(likely) > 5_000


def test_likely_sentences_are_the_same_every_time(born: Language) -> None:
    assert language(Vocabulary(BORN.born)) == born


@pytest.mark.parametrize("word", ["zork", "blick"])
def test_a_taught_word_is_likely(born: Language, word: str) -> None:
    likely = [said for said in language(TAUGHT).likely if word in said.split()]
    assert 5 <= len(likely) <= OF_EACH_WORD
    assert not any(word in said.split() for said in born.likely)
    assert any(language(TAUGHT).reads(said) for said in likely)


def test_more_is_read_than_is_listened_for(born: Language) -> None:
    said = "could you polish the wooden table"
    assert not born.lists(said)
    assert born.reads(said)
    assert kind(said) == "command"
    assert born.lists("drive forward")
    assert not born.reads("table the polish could")


@pytest.mark.parametrize("form", sorted(n for n, form in discover().items() if not form.expected))
def test_every_sentence_of_a_form_is_one_that_the_ears_know(born: Language, form: str) -> None:
    """What is drawn from the grammar and means something is accepted, and has no word that cannot be heard."""
    draw, deal = Draw(words(), seed=5), Deal(words(), seed=5)
    shapes = [tuple(part for part in draw.of(form, 7) if part not in SILENT) for _ in range(60)]
    read = [text for text in map(deal.said, shapes) if kind(text)]
    assert len(read) >= 3
    for text in read:
        assert born.reads(text)
        assert born.words.issuperset(word.removesuffix("'s") for word in text.split()), text


def test_a_taught_word_is_read(born: Language) -> None:
    assert language(TAUGHT).reads("zork the wooden blick twice")
    assert not born.reads("the wooden blick means zork it")
