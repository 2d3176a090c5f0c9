"""Sentences drawn from the grammar itself: many are understood, and none breaks a builder."""

from __future__ import annotations

import json
from importlib.resources import files

import pytest

from grammars import drawn
from grammars.describe import describe
from grammars.drawn import COMPILED, Deal, Draw, example_shapes, words
from grammars.errors import NotUnderstoodError
from grammars.heard import kind
from grammars.parse import parse
from grammars.registry import discover
from kernel.memory.notation import write_meaning

EACH = 40  # sentences of each form: about a fifth is understood, by chance alone seldom less than an eighth
STRIDE = 7
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
FORMS = {name: form for name, form in discover().items() if not form.expected}


@pytest.mark.parametrize("form", sorted(FORMS))
def test_sentences_of_a_form(form: str) -> None:
    known = {**words(), **FIXED}
    draw, deal = Draw(known, seed=1), Deal(known, seed=1)
    shapes = (tuple(draw.of(form, 6 + 2 * (turn % 3))) for turn in range(6 * EACH))
    short = [deal.said(shape) for shape in shapes if len(shape) <= 20][:EACH]
    understood = 0
    for text in short:
        try:
            parsed = parse(text)
        except NotUnderstoodError:
            continue
        understood += 1
        assert write_meaning(parsed.meaning)
        assert describe(parsed)["kind"] == parsed.kind
    assert understood >= len(short) // 8 > 0


def test_a_sentence_is_drawn_for_each_rule_and_none_breaks_a_builder() -> None:
    """Of them all, compiling asks: `scripts/compile_grammar.py` would end in the builder's error."""
    deal = Deal(words())
    every = list(Draw(words(), seed=0).of_each_rule())
    assert len(every) > 4_000
    for _, shapes in every[::STRIDE]:
        kind(deal.said(shapes[0]))


def test_what_was_drawn_for_the_rules_is_read() -> None:
    deal = Deal(words())
    said = [deal.said(shape) for shape in drawn.drawn().rules[::STRIDE]]
    assert len(said) > 500
    # With the words they got now, which nobody may put so.
    assert sum(bool(kind(text)) for text in said) > 0.8 * len(said)


def test_typical_sentences_are_those_of_their_forms() -> None:
    examples = [form for form in FORMS.values() for _ in form.examples]
    assert 0.9 * len(examples) < len(drawn.drawn().typical) <= len(examples)


def test_the_compiled_shapes_are_fresh() -> None:
    """python scripts/compile_grammar.py"""
    kept = json.loads(files("grammars").joinpath(COMPILED).read_text("utf8"))
    assert kept["source"] == drawn.source()
    assert kept["examples"] == json.loads(json.dumps(list(example_shapes())))


def test_every_word_has_its_turn() -> None:
    deal = Deal({"ADJ": ("red", "big", "tall")})
    said = [deal.said(('"the"', "ADJ", '"one"')) for _ in range(3)]
    assert sorted(said) == ["the big one", "the red one", "the tall one"]


def test_short_forms_are_said() -> None:
    deal = Deal({"NAME": ("mary",)})
    shape = ('"do"', '"not"', '"grab"', "NAME", '"\'s"', '"cup"')
    assert deal.said(shape) == "don't grab mary's cup"
