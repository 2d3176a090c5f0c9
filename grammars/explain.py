"""Why a sentence was taken as it was, for people who extend the language: each reading with its rank, and what decided.

The ranks are those the reader itself decided by; nothing is ranked again here.
"""

from __future__ import annotations

from collections.abc import Iterator

from grammars.earley import grammar
from grammars.reading import Parsed


def explain(parsed: Parsed) -> Iterator[str]:
    """Lines: what was repaired, the readings that mean something, best first, and why the first won."""
    for typed, meant in parsed.repaired:
        yield f"typo: {typed!r} taken for {meant!r}"
    charged = [list(tree.charges(grammar().cost)) for tree in parsed.trees]
    ranks = [sum(cost for cost, _ in charges) for charges in charged]
    readings = zip((parsed.alist, *parsed.others), charged, ranks, strict=True)
    for place, (alist, charges, rank) in enumerate(readings, start=1):
        told = "; ".join(f"{what} {cost:+d}" for cost, what in charges)
        yield f"{place}. cost {rank}" + (f" = {told}" if told else "")
        yield f"   {alist}"
    if len(ranks) == 1:
        yield "The first wins: no other reading means anything."
    elif ranks[0] < ranks[1]:
        yield f"The first wins: it costs {ranks[1] - ranks[0]} less than the second."
    else:
        yield "The first wins: it costs as much as the second, and stands earlier in the grammar files."
