"""Typed or recognised text into plain words, each of which remembers where in the text it came from.

Contractions are opened, number words become digits, hesitations go, self-repairs are carried out. Quoted speech is
kept as said: a quote is cut out of the text by position, so nothing done here reaches it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final
from unicodedata import normalize

from grammars.numerals import number

TOKEN = re.compile(
    r"""(?P<quote>["“”][^"“”]*["“”])
      | (?P<damaged>[^\W\d_]+\d+[^\W\d_]+)
      | (?P<stray>(?<=\s)[.:;!?](?=[^\W\d_]))  # "drive :forward"
      | (?P<number>\d+(?:\.\d+)?|(?<!\S)\.\d+)
      | (?P<word>[^\W\d_]+(?:['’-][^\W\d_]+)*['’]?)
      | (?P<comma>[,;:–—]|\s-\s)
      | (?P<degree>(?<=[\d\s])°)
      | (?P<end>[.!?…]+)
      | (?P<other>\S)""",
    re.VERBOSE,
)
SIGHS: Final = tuple((word,) for word in "ugh ouch ow wow aw argh phew gosh geez yikes".split())
THINKING: Final = (
    ("you", "know"),
    ("like",),
    ("basically",),
    ("i", "guess"),
    ("i", "repeat"),
    *SIGHS,
)
MODALS: Final = ("could", "can", "would", "will")
OPENERS: Final = frozenset("well so okay oh hey now and robot please alright".split())
FILLERS: Final = frozenset("uh um er erm uhm hmm ah eh mm huh umm uhh uhhh ummm err hm".split())
WHOLE = {
    "can't": "can not",
    "cannot": "can not",
    "won't": "will not",
    "let's": "let us",
    "cant": "can not",
    "wont": "will not",
    "im": "i am",
    "ive": "i have",
    "youre": "you are",
    "whats": "what is",
    "wheres": "where is",
    "whos": "who is",
    "thats": "that is",
    "theres": "there is",
    "gonna": "going to",
    "wanna": "want to",
    "ok": "okay",
    "pls": "please",
    "nevermind": "never mind",
    "d'you": "do you",
    "'em": "them",
    "till": "until",
    "til": "until",
    "firstly": "first",
    "heres": "here is",
    "favour": "favor",
    "favourite": "favorite",
    "colour": "color",
    "colours": "colors",
    "neighbour": "neighbor",
    "hes": "he is",
    "couldnt": "could not",
    "wouldnt": "would not",
}
WHOLE |= {
    f"{verb}nt": f"{verb} not"
    for verb in "do did does is are was were have has had would could should must".split()
}
ENDINGS: Final = {"'m": "am", "'re": "are", "'ve": "have", "'ll": "will", "'d": "would"}
# "it's" and "what's" are never possessives; other words with 's may be.
IS_ONLY: Final = frozenset(
    "it that there he she name what where who how here when why this everything".split()
)
UNFINISHED: Final = frozenset("the a an my your his their our".split())
ABBREVIATED: Final = frozenset("mr mrs ms dr prof deg ft cm mm min mins sec secs".split())
MOST_STAMMERED: Final = 3


@dataclass(frozen=True, slots=True)
class Piece:
    """A word, a number, a comma, a quote in quotation marks, or something that is none of these.

    Attributes:
        kind: word, number, comma, quote, end, other.
        text: normal form: lower case, digits; of a quote, its inside.
        begin: where it starts in the sentence.
        end: one past its last character; a contraction's second half has no width.
        capital: written with a capital although it does not start the sentence.
    """

    kind: str
    text: str
    begin: int
    end: int
    capital: bool = False


def pieces(text: str) -> list[Piece]:
    """The sentence cut up, contractions opened and numbers read."""
    found: list[Piece] = []
    for match in TOKEN.finditer(text):
        kind, raw = match.lastgroup or "other", match.group()
        begin, end = match.span()
        if kind == "quote":
            found.append(Piece("quote", raw[1:-1].strip(), begin, end))
        elif kind == "word" and _is_written(raw):
            found += _word(raw, begin, end, raw[0].isupper() and bool(found))
        elif kind == "degree":
            found.append(Piece("word", "degree", begin, end))
        elif kind != "stray":
            kind = "other" if kind in ("word", "damaged") else kind
            found.append(Piece(kind, "," if kind == "comma" else raw, begin, end))
    while found and found[-1].kind in ("end", "comma"):
        found.pop()
    found = [piece for at, piece in enumerate(found) if not _abbreviates(found[:at], piece)]
    return _numbers(_flowing([piece for piece in found if piece.text not in FILLERS]))


def _flowing(found: Sequence[Piece]) -> list[Piece]:
    """Without commas where a thing has only begun: "go to the, um, kitchen"."""
    made: list[Piece] = []
    for piece in found:
        again = made and (made[-1].text in UNFINISHED or made[-1].kind == "comma")
        if not (piece.kind == "comma" and again):
            made.append(piece)
    return made


def _abbreviates(before: Sequence[Piece], piece: Piece) -> bool:
    """A full stop that ends no sentence: that of "Mr. Ito", "90 deg."."""
    return piece.text == "." and bool(before) and before[-1].text in ABBREVIATED


def _is_written(raw: str) -> bool:
    """Of letters as people type them: no fractions, no wide letters, no capital that is two letters when small."""
    return raw.isascii() or (normalize("NFKC", raw) == raw and len(raw.lower()) == len(raw))


def _word(raw: str, begin: int, end: int, capital: bool) -> list[Piece]:
    """One written word as one or two words."""
    word = raw.replace("’", "'").lower().rstrip("'")
    head, tail = word, ""
    if word in WHOLE:
        head, _, tail = WHOLE[word].partition(" ")
    elif word.endswith("n't") and len(word) > 3:
        head, tail = word[:-3], "not"
    elif word.endswith("'s"):
        head = word[:-2]
        tail = "is" if head in IS_ONLY else "'s"
    else:
        for ending, opened in ENDINGS.items():
            if word.endswith(ending):
                head, tail = word[: -len(ending)], opened
    first = Piece("word", head, begin, end, capital and head != "i")
    return [first, Piece("word", tail, end, end)] if tail else [first]


def _numbers(found: list[Piece]) -> list[Piece]:
    """Runs of number words become one number each. A bare "one" or "a" stays a word."""
    result: list[Piece] = []
    at = 0
    while at < len(found):
        value, after = number([piece.text for piece in found[at : at + 12]])
        if after == 0 or (after == 1 and found[at].text in ("one", "a", "an")):
            result.append(found[at])
            at += 1
            continue
        digits = f"{value:g}"
        result.append(Piece("number", digits, found[at].begin, found[at + after - 1].end))
        at += after
    return result


def without_chat(found: Sequence[Piece]) -> list[Piece]:
    """Sighs and words of thinking left out, at the beginning or beside a comma: "could you, like, turn left"."""
    if (
        texts(found[1:3]) == ["you", "like"]
        and found[0].text in MODALS
        and texts(found[3:4]) != ["to"]
    ):
        found = [*found[:2], *found[3:]]
    for said in THINKING:
        for at in range(len(found) - len(said) + 1):
            end = at + len(said)
            if tuple(texts(found[at:end])) != said:
                continue
            comma = before = at > 0 and found[at - 1].kind == "comma"
            before = before or (
                said == ("you", "know") and texts(found[at - 1 : at]) in (["then"], ["and"])
            )
            opening = all(piece.text in OPENERS for piece in found[:at])
            closing = end == len(found) and said == ("you", "know")
            after = end < len(found) and found[end].kind == "comma"
            if opening or closing or before or after:
                return without_chat([*found[: at - comma], *found[end + after :]])
    return list(found)


def without_emphasis(found: Sequence[Piece]) -> list[Piece]:
    """ "A bad, bad robot" and "very, very good" without the comma between a word and the same word."""
    at = [at for at, piece in enumerate(found[1:-1], 1) if piece.kind == "comma"]
    between = {one for one in at if found[one - 1].text == found[one + 1].text}
    return [piece for place, piece in enumerate(found) if place not in between]


def without_repeats(found: Sequence[Piece]) -> list[Piece]:
    """Stammered words once: "turn turn left", "grab the grab the cup", "three uh three".

    Of two whole sentences the same nothing was broken off: they are said twice.
    """
    result: list[Piece] = []
    for piece in found:
        result.append(piece)
        for size in range(1, MOST_STAMMERED + 1):
            last, before = result[-size:], result[-2 * size : -size]
            broken_off = size == 1 or 2 * size < len(found)
            if broken_off and _is_stammered(before, last) and texts(last) == texts(before):
                del result[-size:]
                break
    return result


def _is_stammered(before: Sequence[Piece], last: Sequence[Piece]) -> bool:
    """Words, or a number that was thought about: "three uh three", and not "5 5"."""
    thought = bool(before) and last[0].begin - before[-1].end > 1
    return last[0].kind == "word" or (last[0].kind == "number" and thought)


def texts(found: Sequence[Piece]) -> list[str]:
    """The words alone."""
    return [piece.text for piece in found]
