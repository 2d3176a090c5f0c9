from __future__ import annotations

from daemon.hearing.events import Heard, StopWord
from daemon.hearing.typed import typed


def test_a_line_is_heard_as_typed() -> None:
    assert typed(" Mary is a girl ", 2.0) == [Heard(2.0, 2.0, 2.0, "Mary is a girl", 1.0)]


def test_an_empty_line_is_nothing() -> None:
    assert typed("  ", 0.0) == []


def test_a_typed_stop_stops() -> None:
    assert [type(event) for event in typed("Stop!", 1.0)] == [StopWord, Heard]
    assert typed("Robot, stop.", 1.0)[0] == StopWord(1.0, "stop")
    assert [type(event) for event in typed("stop that", 1.0)] == [Heard]
