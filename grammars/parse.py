"""Sentences into meanings: words with their categories, Earley's parser, ranked readings, association list, net."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from itertools import chain
from typing import Final

from grammars.asking import NO, YES, AskWord, agreed, fits, told
from grammars.chatter import is_chatter
from grammars.earley import grammar
from grammars.errors import NotUnderstoodError
from grammars.lattice import Lexer, variants
from grammars.nearest import nearest_sentence
from grammars.normalise import Piece, pieces
from grammars.reading import Attempts, Parsed, Reader
from grammars.suggesting import Words, rather, respelt
from grammars.vocabulary import BORN, Vocabulary, with_verb
from kernel.memory.reply import AskKeep, AskWhich

MOST_WORDS: Final = 60
MOST_LETTERS: Final = 1000
MOST_READ: Final = 26  # words of all attempts upon a sentence, before another suggestion is tried


def parse(
    text: str, vocabulary: Vocabulary = BORN, expecting: AskWhich | AskKeep | AskWord | None = None
) -> Parsed:
    """What a sentence means.

    Args:
        text: one sentence, typed or recognised.
        vocabulary: the words known.
        expecting: the robot's open question, if any: its answers are understood before anything else, and only now.

    Raises:
        NotUnderstoodError: it means nothing in this language, or is no text.
    """
    found = _pieces(text)
    lexer = Lexer(vocabulary, grammar().literal)
    if isinstance(expecting, AskWord):
        if (meant := _of_word(text, vocabulary, expecting)) is not None:
            return meant
    elif expecting is not None:
        answers = partial(grammar().forest, symbol="expected")
        for reading in Reader(text, lexer, Attempts(answers), grammar().cost).read(found):
            if fits(reading.meaning, expecting):
                return reading
    attempts = Attempts(grammar().forest)
    reader = Reader(text, lexer, attempts, grammar().cost)
    strange = _strange(reader, found)
    for reading in reader.readings(found, strange):
        return reading
    unknown = tuple(dict.fromkeys(found[at].text for at in strange))
    words = Words(grammar().literal, vocabulary.everything)
    works = partial(_works, vocabulary=vocabulary, attempts=attempts)
    asking, near = None, respelt(text, found, strange, words, works)
    new = unknown[0] if len(unknown) == 1 and unknown[0] not in YES | NO else ""
    if new and near is None and _works(text, with_verb(vocabulary, new), attempts):
        asking = AskWord(new, text)
    elif near is None:
        near = rather(text, found, reader.reached, words, works) or nearest_sentence(text)
    raise NotUnderstoodError(text, reader.understood(found), near, unknown, asking)


def understood(text: str, vocabulary: Vocabulary = BORN) -> Parsed | None:
    """What a sentence means, or None: without what `parse` finds out about one that means nothing, which takes most."""
    try:
        found = _pieces(text)
    except NotUnderstoodError:
        return None
    lexer = Lexer(vocabulary, grammar().literal)
    reader = Reader(text, lexer, Attempts(grammar().forest), grammar().cost)
    return next(iter(reader.readings(found, _strange(reader, found))), None)


def _pieces(text: str) -> list[Piece]:
    """The words of what may be a sentence.

    Raises:
        NotUnderstoodError: it is none, whatever the words are.
    """
    if not isinstance(text, str) or not text.isprintable() or len(text) > MOST_LETTERS:
        raise NotUnderstoodError(str(text)[:MOST_LETTERS])
    found = pieces(text)
    if not found or len(found) > MOST_WORDS or is_chatter(tuple(p.text for p in found)):
        raise NotUnderstoodError(text)
    return found


def _strange(reader: Reader, found: Sequence[Piece]) -> list[int]:
    """Places of the words that nobody taught."""
    return [at for at, piece in enumerate(found) if reader.lexer.strange(piece)]


def _works(text: str, vocabulary: Vocabulary, attempts: Attempts) -> bool:
    """It means something as it stands, without a guess and not as a fact, which nearly anything can be taken for; so
    far as that may still be tried."""
    if attempts.words > MOST_READ:
        return False
    reader = Reader(text, Lexer(vocabulary, grammar().literal), attempts, grammar().cost)
    found = pieces(text)
    readings = chain.from_iterable(map(reader.read, variants(found, vocabulary)))
    return any(
        reading.kind != "fact"
        and not reading.unknown_words
        and all(part.name != "quote" for part in reading.alist.walk())
        for reading in readings
    )


def _of_word(text: str, vocabulary: Vocabulary, question: AskWord) -> Parsed | None:
    """What the answer to a question about a word means: where it is something to do, the sentence it stood in."""
    if (agreement := agreed(text)) is None:
        sentence = told(question, text)
        try:
            return None if sentence is None else parse(sentence, vocabulary)
        except NotUnderstoodError:
            return None
    if agreement:
        parsed = parse(question.text, with_verb(vocabulary, question.word))
        return replace(parsed, text=text, taught=question.word)
    denied = replace(question, denied=True)
    raise NotUnderstoodError(text, unknown_words=(question.word,), asking=denied)
