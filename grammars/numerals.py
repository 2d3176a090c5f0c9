"""Numbers in words: "two and a half", "a hundred and twenty-five", "a couple of"."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

SMALL: Final = {
    word: value
    for value, word in enumerate(
        "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen"
        " fifteen sixteen seventeen eighteen nineteen".split()
    )
}
PARTS: Final = {"and a half": 0.5, "and a quarter": 0.25, "and three quarters": 0.75}
TENS: Final = {
    word: 10 * value
    for value, word in enumerate(
        "twenty thirty forty fifty sixty seventy eighty ninety".split(), start=2
    )
}


def number(words: Sequence[str]) -> tuple[float, int]:
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
    if at and (more := PARTS.get(" ".join(words[at : at + 3]))):
        return total + current + more, at + 3
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
