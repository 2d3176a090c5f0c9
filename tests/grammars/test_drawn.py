"""Sentences drawn from the grammar itself: many are understood, and none breaks a builder."""

from __future__ import annotations

import random
from functools import cache

import pytest

from grammars.describe import describe
from grammars.earley import productions
from grammars.errors import NotUnderstoodError
from grammars.parse import parse
from grammars.registry import discover
from grammars.vocabulary import BORN
from kernel.memory.notation import write_meaning

EACH = 40  # sentences of each form: about a fifth is understood, by chance alone seldom less than an eighth
FIXED = {
    "NUM": ("3", "10"),
    "STRANGE": ("blorp",),
    "NEWNAME": ("blorp",),
    "UNK": ("blorp",),
    "UNKNAME": ("blorp",),
    "UNKADJ": ("awkward",),
    "NEWING": ("blorping",),
    "QUOTED": ('"hi there"',),
    "ANYWORD": ("hello", "red"),
    "NAMELIKE": ("fluffy",),
    "OPENWORD": ("wave", "cup"),
    "_COMMA": (",",),
}
ENDLESS = 10**6


@cache
def rules() -> dict[str, list[tuple[str, ...]]]:
    found: dict[str, list[tuple[str, ...]]] = {}
    for rule in productions():
        found.setdefault(rule.origin, []).append(rule.symbols)
    return found


@cache
def depths() -> dict[str, int]:
    """The least depth of a derivation of each rule."""
    depth: dict[str, int] = {}
    changed = True
    while changed:
        changed = False
        for origin, ways in rules().items():
            least = min(deep(way, depth) for way in ways)
            if least < depth.get(origin, ENDLESS):
                depth[origin], changed = least, True
    return depth


def deep(way: tuple[str, ...], depth: dict[str, int]) -> int:
    return 1 + max(depth.get(symbol, ENDLESS) if symbol in rules() else 0 for symbol in way)


@cache
def words(category: str) -> tuple[str, ...]:
    return FIXED.get(category) or tuple(sorted(w for w in BORN.words(category) if " " not in w))


def draw(symbol: str, budget: int, chance: random.Random) -> list[str]:
    if symbol.startswith('"'):
        return [symbol.strip('"')]
    if symbol not in rules():
        return [chance.choice(words(symbol))]
    ways = rules()[symbol]
    fitting = [way for way in ways if deep(way, depths()) <= budget]
    way = chance.choice(fitting or [min(ways, key=lambda w: deep(w, depths()))])
    return [word for part in way for word in draw(part, budget - 1, chance)]


@pytest.mark.parametrize("form", sorted(n for n, f in discover().items() if not f.expected))
def test_sentences_of_a_form(form: str) -> None:
    chance = random.Random(form)
    drawn = (draw(form, chance.choice((6, 8, 10)), chance) for _ in range(6 * EACH))
    short = [said for said in drawn if len(said) <= 20][:EACH]
    understood = 0
    for said in short:
        text = " ".join(said).replace(" 's", "'s")
        try:
            parsed = parse(text)
        except NotUnderstoodError:
            continue
        understood += 1
        assert write_meaning(parsed.meaning)
        assert describe(parsed)["kind"] == parsed.kind
    assert understood >= len(short) // 8 > 0
