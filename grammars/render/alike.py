"""Phrases that are alike but for a thing, as one: "the stove or the oven is hot"."""

from __future__ import annotations

from typing import Final

# How a noun phrase begins; and words that none has inside.
_BEGIN: Final = frozenset("a an the my your his her its our their this that something".split())
_NOT_INSIDE: Final = frozenset(
    """
    is are am has have may tells tell asks says not that who which it they to in on under near of for with from if
    unless and then by
    """.split()
)


def either(phrases: list[str]) -> str:
    """All of them with "or" between; what stands before and after the things they differ in only once."""
    words = [phrase.split() for phrase in phrases]
    least = min(map(len, words))
    before = next((n for n in range(least) if len({w[n] for w in words}) > 1), least)
    if words[0][:before][-2:] == ["you", "to"]:  # "Rick tells you to turn or stop"
        return " ".join([*words[0][:before], " or ".join(" ".join(w[before:]) for w in words)])
    while before and words[0][before - 1] in _BEGIN:
        before -= 1
    after = next((n for n in range(least - before) if len({w[-1 - n] for w in words}) > 1), 0)
    for end in range(after, -1, -1):
        things = [w[before : len(w) - end] for w in words]
        rest = words[0][len(words[0]) - end :]
        whole = not rest or rest[0] in _NOT_INSIDE
        if (before or end) and whole and all(map(_is_thing, things)):
            return " ".join([*words[0][:before], " or ".join(map(" ".join, things)), *rest])
    return " or ".join(phrases)


def _is_thing(words: list[str]) -> bool:
    """A noun phrase without anything behind its noun."""
    named = len(words) == 1 and words[0][:1].isupper()
    plain = len(words) > 1 and words[0] in _BEGIN and _NOT_INSIDE.isdisjoint(words[1:])
    return named or plain
