"""Qualities of which a thing has one at a time: who says that the light is green says that it is red no longer (ours).

Only what a person would not think worth saying. A thing told to be green may have been told to be red a minute ago;
both were true. Pure.
"""

from __future__ import annotations

from collections.abc import Container, Iterator
from dataclasses import replace
from typing import Final

from kernel.net.graphlet import Graphlet

EXCLUSIVE: Final = tuple(
    frozenset(words.split())
    for words in (
        "red green blue yellow orange purple violet pink brown black white gray grey",
        "open closed shut",
        "on off",
        "empty full",
        "locked unlocked",
        "clean dirty",
        "wet dry",
        "hot cold",
        "heavy light",
        "happy sad",
        "awake asleep",
        "near far",
        "safe dangerous",
    )
)

PAIRS: Final = tuple(group for group in EXCLUSIVE if len(group) == 2)
# Words that are each other's opposite, for whoever asks; where they are qualities a thing may still have both in turn.
OPPOSITE: Final = PAIRS + tuple(
    frozenset(pair.split())
    for pair in (
        "left right",
        "forward backward",
        "clockwise counterclockwise",
        "up down",
        "in out",
        "big small",
        "tall short",
        "long short",
        "fast slow",
        "quickly slowly",
        "loud quiet",
        "hard soft",
        "old new",
        "old young",
        "good bad",
        "open closed",
        "over under",
        "raise lower",
        "open close",
        "grab release",
        "start stop",
        "push pull",
        "hello goodbye",
        "yes no",
    )
)


def opposites(word: str) -> tuple[str, ...]:
    """The words that say the opposite."""
    found = (other for group in OPPOSITE if word in group for other in group - {word})
    return tuple(dict.fromkeys(found))


def ended_by(fact: Graphlet, known: Container[str] = ()) -> Iterator[Graphlet]:
    """What is no longer so once the fact is: its contrary, and other qualities of the group on the same thing.

    Args:
        fact: what was told.
        known: names in it of things that are known. Only of those another quality is taken back; a denial or a
            comparison takes back nothing but its contrary.
    """
    yield fact.denied()
    main = fact.head
    if main is None or main.negated or [role for role, _ in main.links] != ["hq"]:
        return
    if not all(thing in known for _, thing in main.links):
        return
    rest = [t for t in fact if t is not main and fact.main not in dict(t.links).values()]
    for word in sorted(w for group in EXCLUSIVE if main.lex <= group for w in group - main.lex):
        yield Graphlet((replace(main, lex=frozenset((word,))), *rest), fact.main)


def definite(asked: Graphlet) -> set[str]:
    """Names of the things in a question or condition that are called by name or spoken of as known."""
    return {term.name for term in asked if term.lex or term.ref not in ("", "some")}
