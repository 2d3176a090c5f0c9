"""Variants of every form, in words of our own: each is read as its kind."""

from __future__ import annotations

from pathlib import Path

import pytest

from grammars.parse import parse
from grammars.render import render
from kernel.memory.notation import write_meaning

ROWS = [
    tuple(line.split("\t"))
    for line in (Path(__file__).parent / "sentences.tsv").read_text(encoding="utf8").splitlines()
    if line and not line.startswith("#")
]
READ_BACK = "command procedure reaction before after prohibition permission rule alias fact".split()


@pytest.mark.parametrize(("kind", "sentence"), ROWS)
def test_it_is_read_as_its_kind(kind: str, sentence: str) -> None:
    assert parse(sentence).kind == kind


@pytest.mark.parametrize("sentence", [said for kind, said in ROWS if kind in READ_BACK])
def test_it_reads_back_as_the_same_net(sentence: str) -> None:
    meaning = parse(sentence).meaning
    again = parse(render(meaning, "teacher")).meaning
    assert write_meaning(again) == write_meaning(meaning)
