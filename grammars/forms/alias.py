"""Aliases: rules that give a node another lexical item."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.build import NoMeaningError
from grammars.registry import sentence_form
from grammars.usage import particles
from grammars.vocabulary import BORN
from kernel.memory.lesson import Rule
from kernel.memory.meaning import Teach
from kernel.net.graphlet import Graphlet, Term

EXAMPLES = (
    "Widdershins means counterclockwise",
    "turn means rotate",
    "snatch means grab",
    "Speedily means quickly.",
    "crimson is the same as red",
)
# Node kind for the category of the known word, the likeliest first where it has several.
NODES: Final = (
    ("DIR", "dir"),
    ("VERB", "act"),
    ("ADV", "mod"),
    ("ADJ", "hq"),
    ("NOUN", "ako"),
    ("PROPER", "obj"),
    ("STATE", "act"),
)


@sentence_form("alias", "alias", EXAMPLES)
def alias(alist: AList) -> Teach:
    """The condition and the conclusion are the same node with two words."""
    new = alist.find("new_word", "new_ing_word")
    old = alist.find("old_word", "old_ing_word")
    if new is None or old is None:
        raise NoMeaningError(str(alist))
    said, meant = (new.value or "").lower(), (old.value or "").lower()
    if _lemma(said) == _lemma(meant):
        raise NoMeaningError("a word that means itself")
    node = f"{_node(said, meant)}-1"
    moving = " " in meant and "DIR" in BORN.readings(meant.rpartition(" ")[2])
    meant, way = particles().get(meant, (meant, ""))
    if way or (moving and meant not in particles()):
        raise NoMeaningError("more than a word")
    return Teach("alias", Rule(_word(node, _lemma(said)), _word(node, _lemma(meant))))


def _node(said: str, meant: str) -> str:
    """Kind of node: what both words can be, else what the known one can be."""
    mine, theirs = BORN.readings(said), BORN.readings(meant.partition(" ")[0])
    both = mine.keys() & theirs.keys()
    return next((node for category, node in NODES if category in (both or theirs)), "x")


def _lemma(word: str) -> str:
    readings = BORN.readings(word)
    return next((readings[c] for c in ("DIR", "NOUNS", "VERBING") if c in readings), word)


def _word(node: str, word: str) -> Graphlet:
    return Graphlet((Term(node, frozenset((word,))),), node)
