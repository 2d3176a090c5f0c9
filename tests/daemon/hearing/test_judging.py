"""Which hypotheses are sentences, and how far they are to be trusted."""

from __future__ import annotations

import pytest

from daemon.hearing.judging import JUDGED, Judge

JUDGE = Judge(listed=2.0, middle=0.0, spread=1.0)
LISTED = {"grab the box"}
SENTENCES = {*LISTED, "grab the cox"}


def found(*scored: tuple[str, float]) -> list[tuple[str, float]]:
    trusted = JUDGE.trusted(list(scored), LISTED.__contains__, SENTENCES.__contains__)
    return [(text, round(confidence, 2)) for text, confidence in trusted]


@pytest.mark.parametrize(
    ("scored", "best"),
    [
        ((("grab the cox", 5.0), ("grab the box", 4.0)), "grab the box"),
        ((("grab the cox", 5.0), ("grab the box", 2.0)), "grab the cox"),
        ((("grab a the", 5.0), ("grab the cox", 4.0)), "grab the cox"),
        ((("grab a the", 5.0), ("a the", 4.0)), "grab a the"),
    ],
)
def test_the_likeliest_sentence_comes_first(scored: tuple[tuple[str, float]], best: str) -> None:
    assert found(*scored)[0][0] == best


def test_confidence_is_the_margin_over_what_is_no_sentence() -> None:
    assert found(("grab the cox", 5.0), ("a the", 5.0)) == [("grab the cox", 0.5)]
    assert found(("grab the cox", 5.0), ("a the", 4.0)) == [("grab the cox", 0.73)]
    assert found(("grab the cox", 5.0)) == [("grab the cox", 1.0)]
    assert found(("grab the cox", 5.0), ("a the", 9000.0)) == [("grab the cox", 0.0)]
    assert found(("a the", 5.0)) == [("a the", 0.0)]
    assert found() == []


def test_only_the_best_are_judged() -> None:
    salad = [(f"the {at}", 100.0 - at) for at in range(JUDGED)]
    assert found(*salad, ("grab the box", 1.0)) == [("the 0", 0.0)]
