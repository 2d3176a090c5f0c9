"""Variants of every form, in words of our own: each is read as its kind."""

from __future__ import annotations

from pathlib import Path

import pytest

from grammars.parse import parse

ROWS = [
    tuple(line.split("\t"))
    for line in (Path(__file__).parent / "sentences.tsv").read_text(encoding="utf8").splitlines()
    if line and not line.startswith("#")
]


@pytest.mark.parametrize(("kind", "sentence"), ROWS)
def test_it_is_read_as_its_kind(kind: str, sentence: str) -> None:
    assert parse(sentence).kind == kind
