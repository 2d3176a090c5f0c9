"""Slots, values and brackets."""

from __future__ import annotations

import pytest

from grammars.alist import AList

ACTION = AList("action", (AList("act", value="drive"), AList("dir", value="forward")))


def test_it_is_written_as_in_the_papers_figure() -> None:
    assert str(AList("play", (ACTION,))) == "play( action( act=drive dir=forward ) )"
    assert str(AList("neg")) == "neg()"


def test_parts_are_found_by_name() -> None:
    assert ACTION.slot("dir") == "forward"
    assert ACTION.slot("deg", "none") == "none"
    assert ACTION.has("act")
    assert [part.value for part in ACTION.all("act", "dir")] == ["drive", "forward"]
    assert [part.name for part in AList("play", (ACTION,)).walk()] == [
        "play",
        "action",
        "act",
        "dir",
    ]
    with pytest.raises(KeyError):
        ACTION.first("np")
