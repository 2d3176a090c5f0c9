"""Words with all their categories, in a row: what the parser reads. And the ways a sentence may be meant to be cut up:
set phrases, taught verbs of several words, stammering, the speaker's own corrections.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Final
from unicodedata import normalize

from grammars.morphology import readings as inflected
from grammars.nearest import english
from grammars.normalise import Piece, without_chat, without_emphasis, without_repeats
from grammars.repairing import repaired_by_speaker
from grammars.sorts import HERE
from grammars.source import set_categories
from grammars.vocabulary import OPEN, Vocabulary, set_phrases

# Words around a set phrase that are no part of it.
ADDRESS: Final = frozenset(
    "hey okay robot now please well so alright listen kindly for me then thanks could can would will you".split()
)
MOST_PHRASE_WORDS: Final = 6
# Words after a name: whose something is, what persons do to the robot, of what kind somebody is.
OWN: Final = ("his", "her", "their")
ORDERING: Final = [[verb] for verb in "told asked taught ordered tells asks orders".split()]
MAY_ORDER: Final = [
    [may, more] for may in ("may", "can") for more in ("tell", "ask", "order", "boss")
]
CALLING: Final = ("called", "named")
CALLS: Final = ("call", "calls")
CALLED: Final = [["him"], ["her"], ["it"], ["me"]]
NAMED: Final = [["name", "is"], ["nickname", "is"]]
ARTICLES: Final = frozenset("a an the my our your his her their".split())
PETS: Final = frozenset(
    "dog puppy spaniel poodle terrier beagle cat kitten hamster rabbit parrot horse pony".split()
)

# A word as people make it up: "flibbit", "x-ray", "café".
PLAIN: Final = re.compile("[a-z]?(-?[a-z]{2,})+")

# What no rule of the grammar asks for. (lark names the terminal of a word written out in a rule after the word.)
NO_TERMINAL: Final = "-"


@dataclass(frozen=True, slots=True)
class Token:
    """A word in the lattice.

    Attributes:
        index: place in the sentence.
        piece: the word as it stands in the text.
        readings: terminal of the grammar to lemma.
        known: it is in some category, or written out in some rule.
    """

    index: int
    piece: Piece
    readings: Mapping[str, str] = field(hash=False)
    known: bool = True


@dataclass(frozen=True, slots=True)
class Lexer:
    """Turns words into tokens.

    Attributes:
        vocabulary: the words known.
        literal: words written out in rules, to their terminals.
    """

    vocabulary: Vocabulary
    literal: Mapping[str, str]

    def strange(self, piece: Piece) -> bool:
        """A word in no category and in no rule."""
        known = self.vocabulary.knows(piece.text) or piece.text in self.literal
        return piece.kind == "word" and not known

    def tokens(self, found: Sequence[Piece], guessing: bool) -> list[Token]:
        """The lattice; guessing lets the position of a strange word decide what it is."""
        tokens = [self._token(at, piece, guessing) for at, piece in enumerate(found)]
        for at, token in enumerate(tokens):
            if _may_be_name(token, found[max(0, at - 2) : at], tokens[at + 1 : at + 8]):
                tokens[at] = replace(
                    token, readings={**token.readings, "NAMELIKE": token.piece.text}
                )
        return tokens

    def _token(self, at: int, piece: Piece, guessing: bool) -> Token:
        match piece.kind:
            case "comma":
                return Token(at, piece, {"_COMMA": ","})
            case "end" if piece.text == ".":  # "let me teach you how to limbo. lower the lift"
                return Token(at, piece, {"_COMMA": ","})
            case "quote":
                return Token(at, piece, {"QUOTED": piece.text})
            case "number":
                return Token(at, piece, {"NUM": piece.text, "ANYWORD": piece.text})
            case "word":
                return self._word(at, piece, guessing)
            case _:
                return Token(at, piece, {NO_TERMINAL: piece.text})

    def _word(self, at: int, piece: Piece, guessing: bool) -> Token:
        readings = self.vocabulary.readings(piece.text)
        strange = self.strange(piece)
        if strange:
            readings |= _strange(piece, guessing)
        if readings.keys() & {"STRANGE", *OPEN}:
            readings["OPENWORD"] = piece.text
        if piece.text == "one":
            readings["NUM"] = "1"
        if literal := self.literal.get(piece.text):
            readings[literal] = piece.text
        readings["ANYWORD"] = piece.text
        return Token(at, piece, readings, not strange)


def _unaccented(word: str) -> str:
    """Its letters without their accents; a loose accent stays."""
    return "".join(normalize("NFKD", letter)[0] for letter in word)


def guessed(piece: Piece) -> dict[str, str]:
    """Whatever a word may be that nobody taught."""
    return _strange(piece, guessing=True)


def _strange(piece: Piece, guessing: bool) -> dict[str, str]:
    """What an unknown word may be: something new being named, a name if it has a capital; anything when guessing.
    Damaged letters are no word."""
    if not (PLAIN.fullmatch(_unaccented(piece.text)) or (piece.capital and "'" in piece.text)):
        return {}
    readings = {"STRANGE": piece.text}
    for reading in inflected(piece.text, "verb"):
        if reading.form == "gerund":
            readings.setdefault("NEWING", reading.lemma)
    name = piece.capital or piece.text not in english()
    if name:
        readings["NEWNAME"] = piece.text
    if piece.capital:
        readings["PROPER"] = piece.text
    if guessing:
        manner = piece.text.endswith("ly") and len(piece.text) > len("early")
        if manner or not piece.capital:  # "the BBC" is no kind of thing
            readings["ADV" if manner else "UNK"] = piece.text
        if not manner:
            readings["UNKNAME" if name else "UNKADJ"] = piece.text
    return readings


def _may_be_name(token: Token, before: Sequence[Piece], after: Sequence[Token]) -> bool:
    """A word that stands where a name does: written as one, told as one ("called Spot", "the name is Spot"), or a
    quality that is said to be of some kind ("Fluffy is a kitten"); an unknown word before what persons do to the robot.
    """
    words = [next_.piece.text for next_ in after[:4]]
    if not before and "NEWNAME" in token.readings:
        ordering = (words[:1] in ORDERING and words[1:2] == ["you"]) or words[:2] in MAY_ORDER
        return ordering or (words[2:3] == ["than"] and words[-1] in OWN)
    if not before:
        if words[1:2] == ["not"]:
            after, words = [after[0], *after[2:]], [words[0], *words[2:]]
        kinds = [next_.piece.text for next_ in after[2:] if not _describes(next_)]
        pet = not PETS.isdisjoint((*kinds[:1], *kinds[-1:]))  # "Biscuit is the neighbor's dog"
        noun = not token.readings.keys().isdisjoint(("NOUN", "NOUNS"))
        if words[:1] not in (["is"], ["'s"]) or token.piece.text in HERE:
            return False
        quality = "ADJ" in token.readings and words[1:2] in (["a"], ["an"])
        return quality or (noun and pet and not ARTICLES.isdisjoint(words[1:2]))
    said = [piece.text for piece in before]
    told = said[-1] in CALLING or said[-2:] in NAMED or _is_calling(said)
    if not told and token.readings.keys() & set_categories():  # "Bad robot"
        return False
    new = said[-1] in (*CALLING, "me") or said == ["name", "is"]
    if _is_calling(said) and "ADDRESSEE" in token.readings:  # "everyone calls him Buddy"
        return True
    if told and new and token.piece.capital and "VERB" in token.readings:  # "they call me Buzz"
        return True
    nameable = ("ADJ", "NOUN", "NOUNS", *(("STRANGE", "VERBS") if told else ()))
    return (told or token.piece.capital) and not token.readings.keys().isdisjoint(nameable)


def _is_calling(said: Sequence[str]) -> bool:
    """ "Everyone calls him Buddy"."""
    return said[0] in CALLS and said[1:] in CALLED


def _describes(token: Token) -> bool:
    """A word that may stand before what something is: "a very small dog"."""
    return not token.readings.keys().isdisjoint(("ADJ", "DEG")) and token.piece.text not in PETS


def variants(found: list[Piece], vocabulary: Vocabulary) -> Iterator[list[Piece]]:
    """The sentence with set phrases made one word, as said, without stammering, with the speaker's own corrections
    carried out, and without words said while thinking."""
    seen: list[list[Piece]] = []
    once = without_repeats(found)
    for variant in (
        _as_phrase(found, vocabulary),
        _as_phrase(once, vocabulary),
        _with_phrases(found, vocabulary),
        found,
        without_emphasis(found),
        once,
        repaired_by_speaker(once, vocabulary.readings),
        without_repeats(without_chat(once)),
        _with_set_phrases(without_chat(once)),
    ):
        if variant and variant not in seen:
            seen.append(variant)
            yield variant


def _as_phrase(found: list[Piece], vocabulary: Vocabulary) -> list[Piece]:
    """The sentence with the set phrase that it consists of made one word; empty if it is none."""
    words = [piece for piece in found if piece.kind != "comma"]
    starts = [at for at in range(len(words)) if all(p.text in ADDRESS for p in words[:at])]
    ends = [at for at in range(len(words) + 1) if all(p.text in ADDRESS for p in words[at:])]
    for begin in starts:
        for end in reversed(ends):
            text = " ".join(piece.text for piece in words[begin:end])
            if begin < end and vocabulary.readings(text).keys() & set_categories():
                return [*words[:begin], _merged(words[begin:end]), *words[end:]]
    return []


def _with_set_phrases(found: list[Piece]) -> list[Piece]:
    """Every set phrase of several words made one word, the longest first: "good night robot, see you soon"."""
    said = _several_words()
    made: list[Piece] = []
    at = 0
    while at < len(found):
        ends = range(min(len(found), at + MOST_PHRASE_WORDS), at + 1, -1)
        end = next((e for e in ends if tuple(p.text for p in found[at:e]) in said), at + 1)
        made.append(found[at] if end == at + 1 else _merged(found[at:end]))
        at = end
    return made


@cache
def _several_words() -> frozenset[tuple[str, ...]]:
    phrases = (tuple(phrase.split()) for said in set_phrases().values() for phrase in said)
    return frozenset(words for words in phrases if 1 < len(words) <= MOST_PHRASE_WORDS)


def _with_phrases(found: list[Piece], vocabulary: Vocabulary) -> list[Piece]:
    """The sentence with taught verbs of several words made one word each; empty if there are none."""
    result, at = list(found), 0
    while at < len(result):
        for words in vocabulary.taught_phrases:
            run = result[at : at + len(words)]
            if tuple(piece.text for piece in run) == words:
                result[at : at + len(words)] = [_merged(run)]
                break
        at += 1
    return result if len(result) < len(found) else []


def _merged(run: Sequence[Piece]) -> Piece:
    return Piece("word", " ".join(piece.text for piece in run), run[0].begin, run[-1].end)
