"""Quotes without quotation marks: where one ends, and whether it is said by people.

What follows "say" is taken as it stands, whatever it is. What somebody is to shout, sing or whisper makes sense.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import groupby, pairwise
from typing import Any, Final

from grammars.errors import BrokenOffError
from grammars.lattice import Token, guessed
from grammars.mentions import FINITE
from grammars.ranking import Leaf, Tree
from grammars.sorts import abstract_words, classes
from grammars.source import set_categories

Derive = Callable[[Sequence[Token], str], Any]

NEVER_SAID: Final = frozenset(
    ("whenever", "unless", "otherwise")
)  # words that a quote hardly ever holds
CONDITIONALS: Final = frozenset("if when whenever unless until while".split())
OCCASIONS: Final = CONDITIONALS | {"after", "before", "once"}
SUBJECTS: Final = frozenset(
    "i you he she it we they someone somebody something anyone anybody anything".split()
)
# How a clause about somebody else begins.
THIRD: Final = frozenset(
    "the a an my his her its their our this that he she it somebody someone something anybody anyone nobody".split()
)
UNBEGUN: Final = ("me", "him", "us", "them", "anytime", "asks", "tells", "says")
# What nobody wants to be told: orders, and where to go.
UNASKED: Final = ("command", "prohibition", "trust", "control", "revision", "dest")
NO_OPENING: Final = frozenset("VERBED VERBING VERBS DIR VERB STATE ADJER ADJEST".split())
OPENING: Final = frozenset(("NOUN", "NOUNS", "PROPER"))
LITERALLY: Final = ("say", "saying")  # after these anything is a quote
# What somebody is to be told; "tell me", though, mostly asks for what the robot knows.
LONGEST: Final = (
    9  # words of a message that is not put in quotation marks; at more length it is gossip
)
MESSAGES: Final = frozenset("tell telling ask asking".split())
RECITING: Final = frozenset("recite reciting".split())
WANTED: Final = frozenset(
    "everything anything all what whatever how who whom where when why whether".split()
)
ASKING_FOR: Final = [["tell", "me"], ["telling", "me"], ["ask", "me"]]


def holds(tree: Tree, derive: Derive) -> bool:
    """Every quote in the derivation ends where it may, and makes sense where it has to."""
    if any(_swallows([token for _, token in words], derive) for words in tree.quotes()):
        return False
    return all(
        _may_be_spoken(before, words, derive)
        for before, words in tree.speeches()
        if before[0] not in LITERALLY
    )


def _may_be_spoken(before: Sequence[str], words: Sequence[Leaf], derive: Derive) -> bool:
    """What follows another verb than "say" makes sense, or is at least begun as a message may be."""
    tokens = [token for _, token in words]
    if before[:2] in ASKING_FOR:
        wanted = tokens[0].piece.text in WANTED
        if wanted and before[0] == "ask":  # "ask me where it is"
            return True
        if wanted or _is_handled(tokens, derive):
            return False
        if any(_derives(tokens, symbol, derive) for symbol in UNASKED):
            return False
    elif before[0] in MESSAGES:
        begun = not _is_no_opening(tokens[0]) or _makes_sense(tokens, derive)
        return begun and len(tokens) <= LONGEST
    too_short = len(words) == 1 and _is_too_short(before, words[0])
    return not too_short and _makes_sense(tokens, derive)


def _is_no_opening(token: Token) -> bool:
    """Hardly anybody begins a message so: "me everything you know", "learned today", "burning says"."""
    if token.piece.text in UNBEGUN:
        return True
    return bool(token.readings.keys() & NO_OPENING) and OPENING.isdisjoint(token.readings)


def _is_handled(tokens: Sequence[Token], derive: Derive) -> bool:
    """A thing that nobody tells: "my sneakers", "the moment of truth", and not "a joke"."""
    if tokens[0].piece.text == "the" and tokens[-1].piece.text not in classes()["texts"]:
        return _derives([_freely(token) for token in tokens], "np", derive)
    told = abstract_words() | classes()["texts"]
    ends = [token.readings for token in (tokens[0], tokens[-1])]
    things = [one.get("NOUN") or one.get("NOUNS", "") for one in ends]
    return any(thing and thing not in told for thing in things) and _derives(tokens, "np", derive)


def _is_too_short(before: Sequence[str], word: Leaf) -> bool:
    """Nothing is recited in one word, and nobody wants to be told "red"; a greeting is told in one."""
    greets = word[1].readings.keys() & set_categories()
    return before[0] in RECITING or (before[:2] in ASKING_FOR and not greets)


def _swallows(tokens: Sequence[Token], derive: Derive) -> bool:
    """It runs on over a condition: "say hi unless Mary is near" says no such thing."""
    return any(
        token.piece.text in NEVER_SAID
        or (token.piece.text in CONDITIONALS and tokens[at - 1].piece.text == "and")
        or (_is_meanwhile(tokens[at:]) and _derives(tokens[at + 2 :], "action", derive))
        or (
            token.piece.text in OCCASIONS
            and (
                _is_broken_off(token, tokens[at + 1 :])
                or _is_of_another(tokens[at + 1 :])
                or _derives(tokens[at + 1 :], "conds", derive)
            )
        )
        for at, token in enumerate(tokens[:-1])
        if at > 0
    )


def _is_meanwhile(tokens: Sequence[Token]) -> bool:
    """ "As you raise the lift"."""
    return len(tokens) > 2 and [token.piece.text for token in tokens[:2]] == ["as", "you"]


def _is_broken_off(occasion: Token, tokens: Sequence[Token]) -> bool:
    """ "When someone", "if it": nothing is said of them yet."""
    before = occasion.piece.text in CONDITIONALS
    return before and len(tokens) == 1 and tokens[0].piece.text in SUBJECTS


def _is_of_another(tokens: Sequence[Token]) -> bool:
    """It begins as a clause about a third person or a thing, whatever that does: "the clock strikes twelve"."""
    about = tokens[0].piece.text in THIRD or "PROPER" in tokens[0].readings
    return about and any(
        token.piece.text in FINITE
        or token.readings.keys() & {"STATES", "VERBS"}
        or ("STATE" in token.readings and "NOUNS" in before.readings)
        for before, token in pairwise(tokens)
    )


def _makes_sense(tokens: Sequence[Token], derive: Derive) -> bool:
    """The words belong together; "row, row, row your boat" is "row your boat"."""
    once = [_freely(next(same)) for _, same in groupby(tokens, key=lambda token: token.piece.text)]
    return _derives(once, "called_out", derive)


def _freely(token: Token) -> Token:
    """The word without the right to be just any word of a quote; a word that nobody taught may be anything."""
    readings = {name: lemma for name, lemma in token.readings.items() if name != "ANYWORD"}
    word = token.piece.text
    if not token.known or readings.keys() <= set_categories():  # "hooray"
        readings |= {**guessed(token.piece), "NOUN": word}
    elif word in abstract_words():
        readings["NOUN"] = word
    return replace(token, readings=readings)


def _derives(tokens: Sequence[Token], symbol: str, derive: Derive) -> bool:
    try:
        derive(tokens, symbol)
    except BrokenOffError:
        return False
    return True
