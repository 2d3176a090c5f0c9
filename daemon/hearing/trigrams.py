"""How likely a word is after the two before it, learned from phrases and written as speech engines read it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import chain
from typing import Any, Final

import numpy as np
import numpy.typing as npt

BEGIN, END = "<s>", "</s>"
DISCOUNT: Final = 0.7
"""Taken from every count of two words or three, for those that were never seen together."""
NEVER: Final = 1e-99

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]


@dataclass(frozen=True)
class _Table:
    """Words in a row, as many for each: a row of the arrays for each.

    Attributes:
        words: their numbers, one column for each word.
        share: how likely the last is after the others.
        at: for each word of the phrases, the row of those that end with it.
    """

    words: Ints
    share: Floats
    at: Ints


def arpa(phrases: Iterable[str]) -> str:
    """The model in ARPA's format, by absolute discounting with interpolation (Ney, Essen and Kneser 1994).

    Args:
        phrases: their words with single spaces between; one that is there twice counts twice.
    """
    counted = {tuple(said.split()): times for said, times in Counter(phrases).items()}
    names = [BEGIN, END, *sorted(set(chain.from_iterable(counted)))]
    number = {word: at for at, word in enumerate(names)}
    said = np.array([number[w] for words in counted for w in (BEGIN, *words, END)])
    lengths = np.array([len(words) + 2 for words in counted])
    place = np.concatenate([np.arange(length) for length in lengths])
    times = np.repeat(np.array([*counted.values()], dtype=float), lengths)
    count = np.bincount(said[place > 0], times[place > 0], minlength=len(names))
    tables = [_Table(np.arange(len(names))[:, None], count / count.sum(), said)]
    backoffs = list[Floats]()
    for before in (1, 2):
        table, left = _longer(tables[-1], said, times, np.flatnonzero(place >= before))
        tables.append(table)
        backoffs.append(left)
    return "\n".join(_lines(tables, backoffs, np.array(names, dtype=object)))


def _longer(fewer: _Table, said: Ints, times: Floats, ends: Ints) -> tuple[_Table, Floats]:
    """Rows of one word more, ending at these places; and what each of the shorter leaves to words never seen after."""
    size = len(fewer.share)
    key = fewer.at[ends - 1] * (1 + said.max()) + said[ends]
    _, first, row = np.unique(key, return_index=True, return_inverse=True)
    count = np.bincount(row, times[ends])
    end = ends[first]
    context = fewer.at[end - 1]
    total = np.bincount(context, count, minlength=size)
    left = DISCOUNT * np.bincount(context, minlength=size) / np.maximum(total, 1.0)
    share = (count - DISCOUNT) / total[context] + left[context] * fewer.share[fewer.at[end]]
    at = np.zeros(len(said), np.int64)
    at[ends] = row
    words = np.column_stack([fewer.words[context], said[end]])
    return _Table(words, share, at), left


def _lines(tables: list[_Table], backoffs: list[Floats], names: npt.NDArray[Any]) -> Iterator[str]:
    """Rows: a logarithm to base 10, the words, and that of what is left to those never seen after them."""
    yield "\\data\\"
    for length, table in enumerate(tables, 1):
        yield f"ngram {length}={len(table.share)}"
    for length, table in enumerate(tables, 1):
        yield f"\n\\{length}-grams:"
        columns = [_logarithms(table.share), *names[table.words].T.tolist()]
        columns += [_logarithms(left) for left in backoffs[length - 1 : length]]
        yield from map(" ".join, zip(*columns, strict=True))
    yield "\n\\end\\\n"


def _logarithms(values: Floats) -> list[str]:
    return [f"{value:.4f}" for value in np.log10(np.maximum(values, NEVER)).tolist()]
