"""Nothing is cut short except by stop; every ticket's end is reported once."""

from __future__ import annotations

from daemon.events import Error, Event, SayEnded, SayStarted
from daemon.speaking.queue import SpeechQueue
from daemon.speaking.silent import SilentVoice


class BrokenVoice:
    def start(self, text: str, now_s: float) -> None:
        raise OSError("no loudspeaker")

    def busy(self, now_s: float) -> bool:
        return False

    def interrupt(self) -> None:
        raise OSError("no loudspeaker")


def spans(told: list[Event]) -> list[tuple[str, float, float]]:
    starts = [e for e in told if isinstance(e, SayStarted)]
    ends = [e for e in told if isinstance(e, SayEnded)]
    return [(a.text, a.t, round(b.t, 3)) for a, b in zip(starts, ends, strict=True)]


def test_one_after_another_each_as_long_as_its_words_take() -> None:
    told: list[Event] = []
    queue = SpeechQueue(SilentVoice(), told.append)
    queue.add("one two", ticket=7)
    queue.add("three")
    ended = {round(tick * 0.05, 2): queue.step(tick * 0.05) for tick in range(40)}
    assert spans(told) == [("one two", 0.0, 0.7), ("three", 0.7000000000000001, 1.05)]
    assert [tickets for tickets in ended.values() if tickets] == [frozenset({7})]
    assert queue.idle


def test_stop_ends_it_at_once_and_reports_every_ticket() -> None:
    told: list[Event] = []
    queue = SpeechQueue(SilentVoice(), told.append)
    for ticket in (1, 2, 3):
        queue.add("a long story indeed", ticket)
    queue.step(0.0)
    queue.hush(0.1)
    assert queue.idle
    assert queue.step(0.2) == frozenset({1, 2, 3})
    assert told == [
        SayStarted(t=0.0, text="a long story indeed"),
        SayEnded(t=0.1, text="a long story indeed", cut=True),
    ]


def test_a_voice_that_fails_is_told_and_does_not_hold_anything_up() -> None:
    told: list[Event] = []
    queue = SpeechQueue(BrokenVoice(), told.append)
    queue.add("hello", ticket=4)
    assert queue.step(0.0) | queue.step(0.1) == frozenset({4})
    assert Error(t=0.0, part="voice", text="no loudspeaker") in told
    assert queue.idle


def test_an_empty_text_ends_in_the_step_it_starts() -> None:
    queue = SpeechQueue(SilentVoice(), [].append)
    queue.add("", ticket=1)
    assert queue.step(0.0) | queue.step(0.0) == frozenset({1})
