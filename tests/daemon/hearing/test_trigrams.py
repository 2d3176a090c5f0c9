"""A model of which words follow which."""

from __future__ import annotations

from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from daemon.hearing.trigrams import BEGIN, END, arpa

WORDS = ("grab", "lift", "the", "box")


def table(text: str) -> dict[tuple[str, ...], tuple[float, float]]:
    """Each row's share and what is left to what was never seen after it."""
    rows = dict[tuple[str, ...], tuple[float, float]]()
    for order, section in enumerate(text.split("-grams:\n")[1:], 1):
        for line in section.split("\n\n")[0].splitlines():
            share, *words = line.split()
            rows[*words[:order],] = (10 ** float(share), 10 ** float((*words, "0")[order]))
    return rows


def share(rows: dict[tuple[str, ...], tuple[float, float]], gram: tuple[str, ...]) -> float:
    """As an engine reads the model."""
    if gram in rows:
        return rows[gram][0]
    before = rows.get(gram[:-1])
    return (1.0 if before is None else before[1]) * share(rows, gram[1:])


@given(st.lists(st.lists(st.sampled_from(WORDS), min_size=1).map(" ".join), min_size=1))
def test_after_any_two_words_something_follows(phrases: list[str]) -> None:
    rows = table(arpa(phrases))
    known = {word for said in phrases for word in said.split()}
    for before in product((BEGIN, *known), known):
        follows = sum(share(rows, (*before, word)) for word in (*known, END))
        assert follows == pytest.approx(1.0, abs=0.01)


def test_what_was_seen_oftener_is_likelier_and_what_never_was_still_possible() -> None:
    rows = table(arpa(["grab the box", "grab the box", "grab the lift"]))
    seen, seldom, never = (share(rows, ("grab", "the", last)) for last in ("box", "lift", "grab"))
    assert seen > seldom > never > 0.0


def test_the_head_says_how_many_rows_there_are() -> None:
    text = arpa(["grab the box", "lift the box"])
    sizes = [sum(len(row) == order for row in table(text)) for order in (1, 2, 3)]
    assert [f"ngram {order}={size}" in text for order, size in enumerate(sizes, 1)] == [True] * 3
