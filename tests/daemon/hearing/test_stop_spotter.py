"""Finding "stop" in what is being said."""

from __future__ import annotations

import pytest

from daemon.hearing.stop_spotter import STEADY, StopSpotter


@pytest.mark.parametrize("said", ["stop", "halt", "freeze", "robot stop", "stop robot"])
def test_a_stop_word_alone_is_found_as_soon_as_the_voice_pauses(said: str) -> None:
    spotter = StopSpotter()
    assert spotter.heard(said, quiet=False) == ""
    assert spotter.heard(said, quiet=True) in ("stop", "halt", "freeze")


@pytest.mark.parametrize(
    "said", ["", "robot", "stop that", "if you stop", "turn left stop", "robot stop robot"]
)
def test_nothing_else_is(said: str) -> None:
    spotter = StopSpotter()
    assert all(spotter.heard(said, quiet=True) == "" for _ in range(20))


def test_a_steady_hypothesis_needs_no_pause() -> None:
    spotter = StopSpotter()
    found = [spotter.heard("stop", quiet=False) for _ in range(STEADY)]
    assert found == [""] * (STEADY - 1) + ["stop"]


def test_it_is_found_once_an_utterance() -> None:
    spotter = StopSpotter()
    assert [spotter.heard("stop", quiet=True) for _ in range(3)] == ["stop", "", ""]
    spotter.reset()
    assert spotter.heard("stop", quiet=True) == "stop"
