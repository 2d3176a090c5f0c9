"""Typed or recognised text into plain words, each of which remembers where in the text it came from.

Contractions are opened, number words become digits, hesitations go, self-repairs are carried out. Quoted speech is
kept as said: a quote is cut out of the text by position, so nothing done here reaches it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Container, Sequence
from dataclasses import dataclass
from typing import Final

TOKEN = re.compile(
    r"""(?P<quote>["“”][^"“”]*["“”])
      | (?P<number>\d+(?:\.\d+)?)
      | (?P<word>[^\W\d_]+(?:['’-][^\W\d_]+)*['’]?)
      | (?P<comma>[,;:–—]|\s-\s)
      | (?P<degree>°)
      | (?P<end>[.!?…]+)
      | (?P<other>\S)""",
    re.VERBOSE,
)
THINKING: Final = (("you", "know"), ("like",), ("basically",), ("i", "guess"))
FILLERS: Final = frozenset("uh um er erm uhm hmm ah eh mm huh umm uhh uhhh ummm err hm".split())
WHOLE: Final = {
    "can't": "can not",
    "cannot": "can not",
    "won't": "will not",
    "let's": "let us",
    "dont": "do not",
    "cant": "can not",
    "wont": "will not",
    "didnt": "did not",
    "doesnt": "does not",
    "isnt": "is not",
    "arent": "are not",
    "shouldnt": "should not",
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
    "'em": "them",
    "till": "until",
    "til": "until",
    "firstly": "first",
}
ENDINGS: Final = {"'m": "am", "'re": "are", "'ve": "have", "'ll": "will", "'d": "would"}
# "it's" and "what's" are never possessives; other words with 's may be.
IS_ONLY: Final = frozenset(
    "it that there he she name what where who how here when why this everything".split()
)
SMALL: Final = {
    word: value
    for value, word in enumerate(
        "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen"
        " fifteen sixteen seventeen eighteen nineteen".split()
    )
}
TENS: Final = {
    word: 10 * value
    for value, word in enumerate(
        "twenty thirty forty fifty sixty seventy eighty ninety".split(), start=2
    )
}
# Categories whose words are put right one for one: "turn left no right". A verb takes all after it along.
REPAIRABLE: Final = ("DIR", "ADV", "UNIT", "ADJ", "NOUN", "PROPER", "VERB")


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
        kind, raw, begin, end = (
            match.lastgroup or "other",
            match.group(),
            match.start(),
            match.end(),
        )
        if kind == "quote":
            found.append(Piece("quote", raw[1:-1].strip(), begin, end))
        elif kind == "word":
            found += _word(raw, begin, end, raw[0].isupper() and bool(found))
        elif kind == "degree":
            found.append(Piece("word", "degree", begin, end))
        else:
            found.append(Piece(kind, "," if kind == "comma" else raw, begin, end))
    while found and found[-1].kind in ("end", "comma"):
        found.pop()
    return _numbers([piece for piece in found if piece.text not in FILLERS])


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
        value, after = _number([piece.text for piece in found[at : at + 12]])
        if after == 0 or (after == 1 and found[at].text in ("one", "a", "an")):
            result.append(found[at])
            at += 1
            continue
        digits = f"{value:g}"
        result.append(Piece("number", digits, found[at].begin, found[at + after - 1].end))
        at += after
    return result


def _number(words: Sequence[str]) -> tuple[float, int]:
    """Value of the number the words start with and how many words it takes; 0 words for none."""
    special = _fraction(words)
    if special[1]:
        return special
    total, current, at, hundred = 0.0, 0.0, 0, False
    if words[:1] and words[0] in ("a", "an") and words[1:2] in (["hundred"], ["thousand"]):
        current, at = 1.0, 1
    while at < len(words):
        word = words[at]
        if word in SMALL and current % 10 == 0 and (current % 100 == 0 or SMALL[word] < 10):
            current += SMALL[word]
        elif word in TENS and current % 100 == 0:
            current += TENS[word]
        elif "-" in word and _hyphen(word) and current % 100 == 0:
            current += _hyphen(word)
        elif word == "hundred" and 0 < current < 10:
            current, hundred = current * 100, True
        elif word == "thousand" and 0 < current < 1000:
            total, current = total + current * 1000, 0.0
        elif word == "and" and hundred and words[at + 1 : at + 2] and _starts(words[at + 1]):
            pass
        else:
            break
        at += 1
    if at and list(words[at : at + 3]) == ["and", "a", "half"]:
        return total + current + 0.5, at + 3
    if words[at : at + 1] == ["point"] and words[at + 1 : at + 2]:
        tenth = SMALL.get(words[at + 1], 10)
        if tenth < 10:
            return total + current + tenth / 10, at + 2
    return total + current, at


def _starts(word: str) -> bool:
    return word in SMALL or word in TENS or bool(_hyphen(word))


def _hyphen(word: str) -> float:
    ten, _, one = word.partition("-")
    return TENS[ten] + SMALL[one] if ten in TENS and SMALL.get(one, 10) < 10 else 0.0


def _fraction(words: Sequence[str]) -> tuple[float, int]:
    for phrase, value in (
        ("three quarters of a", 0.75),
        ("half a", 0.5),
        ("half an", 0.5),
        ("a half", 0.5),
        ("a quarter of a", 0.25),
        ("quarter of a", 0.25),
        ("a couple of", 2.0),
        ("a couple", 2.0),
        ("a dozen", 12.0),
    ):
        count = len(phrase.split())
        if list(words[:count]) == phrase.split():
            return value, count
    return 0.0, 0


def without_chat(found: Sequence[Piece]) -> list[Piece]:
    """Words said while thinking left out, at the beginning or beside a comma: "could you, like, turn left"."""
    for said in THINKING:
        for at in range(len(found) - len(said) + 1):
            end = at + len(said)
            if tuple(_texts(found[at:end])) != said:
                continue
            before = at > 0 and found[at - 1].kind == "comma"
            after = end < len(found) and found[end].kind == "comma"
            if at == 0 or before or after:
                return without_chat([*found[: at - before], *found[end + after :]])
    return list(found)


def without_repeats(found: Sequence[Piece]) -> list[Piece]:
    """Stammered words once: "turn turn left", "grab the grab the cup".

    Of two whole sentences the same nothing was broken off: they are said twice.
    """
    result: list[Piece] = []
    for piece in found:
        result.append(piece)
        for size in range(1, MOST_STAMMERED + 1):
            last, before = result[-size:], result[-2 * size : -size]
            broken_off = size == 1 or 2 * size < len(found)
            if broken_off and last[0].kind == "word" and _texts(last) == _texts(before):
                del result[-size:]
                break
    return result


def _texts(found: Sequence[Piece]) -> list[str]:
    return [piece.text for piece in found]


def repaired_by_speaker(
    found: Sequence[Piece], sorts: Callable[[str], Container[str]] = lambda _: ()
) -> list[Piece]:
    """Self-repair carried out: "turn left i mean right" is "turn right", "five no six inches" is "6 inches".

    sorts: the categories of a word; the correction takes the place of what is of its sort.
    """
    texts = _texts(found)
    for marker in (
        ["no", "i", "mean"],
        ["make", "that"],
        ["i", "mean"],
        ["no", "wait"],
        ["or", "rather"],
        ["sorry"],
        ["no"],
    ):
        for at in range(1, len(texts) - len(marker)):
            if texts[at : at + len(marker)] != marker:
                continue
            before = [piece for piece in found[:at] if piece.kind != "comma"]
            after = [piece for piece in found[at + len(marker) :] if piece.kind != "comma"]
            return _put_right(before, after, sorts) if after else before
    return list(found)


def _put_right(
    before: list[Piece], after: list[Piece], sorts: Callable[[str], Container[str]]
) -> list[Piece]:
    """The correction in the place of the same word, else of a word of its sort, else of as many words; what followed a
    single word that was corrected stays."""
    new = after[0]
    sort = [name for name in REPAIRABLE if name in sorts(new.text)]
    same = [at for at, piece in enumerate(before) if piece.text == new.text]
    number = [at for at, piece in enumerate(before) if piece.kind == new.kind == "number"]
    alike = [
        at for at, piece in enumerate(before) if any(name in sorts(piece.text) for name in sort)
    ]
    places = same or number or alike
    again = places[-1] if places else max(0, len(before) - len(after))
    stays = bool(places) and len(after) == 1 and sort != ["VERB"]
    return [*before[:again], *after, *(before[again + 1 :] if stays else ())]
