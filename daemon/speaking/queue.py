"""The queue in front of a voice: nothing is cut short except by stop, and every ticket's end is reported."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass

from daemon.events import Error, Event, SayEnded, SayStarted
from daemon.speaking.voice import Voice


@dataclass(frozen=True, slots=True)
class _Line:
    text: str
    ticket: int | None
    told: bool


class SpeechQueue:
    """Says one thing after another.

    Args:
        voice: what says it.
        emit: told when each text starts and ends.
    """

    def __init__(self, voice: Voice, emit: Callable[[Event], None]) -> None:
        self._voice = voice
        self._emit = emit
        self._waiting: deque[_Line] = deque()
        self._current: _Line | None = None
        self._ended: set[int] = set()

    @property
    def idle(self) -> bool:
        """Nothing is being said or waits."""
        return self._current is None and not self._waiting

    @property
    def speaking(self) -> bool:
        """Something is being said."""
        return self._current is not None

    def add(self, text: str, ticket: int | None = None, *, told: bool = False) -> None:
        """Queue a text; a ticket is reported by `step` once the text has been said or was cut. told: see SayStarted."""
        self._waiting.append(_Line(text, ticket, told))

    def step(self, now_s: float) -> frozenset[int]:
        """Notice what ended, start what is next; tickets that ended since the last step."""
        while True:
            if self._current is not None and not self._safely(self._voice.busy, now_s):
                self._end(self._current, now_s)
            if self._current is not None or not self._waiting:
                break
            self._current = self._waiting.popleft()
            current = self._current
            self._emit(SayStarted(t=now_s, text=current.text, told=current.told))
            self._safely(self._voice.start, self._current.text, now_s)
        ended, self._ended = frozenset(self._ended), set()
        return ended

    def hush(self, now_s: float) -> None:
        """End speech at once and forget what waits."""
        waiting, self._waiting = self._waiting, deque()
        self._ended.update(line.ticket for line in waiting if line.ticket is not None)
        if self._current is not None:
            try:
                self._voice.interrupt()
            except OSError as error:
                self._emit(Error(t=now_s, part="voice", text=str(error)))
            self._end(self._current, now_s, cut=True)

    def _end(self, line: _Line, now_s: float, *, cut: bool = False) -> None:
        self._current = None
        if line.ticket is not None:
            self._ended.add(line.ticket)
        self._emit(SayEnded(t=now_s, text=line.text, cut=cut))

    def _safely(self, call: Callable[..., bool | None], *arguments: object) -> bool:
        """The call's result; a voice that fails is reported and counts as done: the text was shown."""
        try:
            return bool(call(*arguments))
        except OSError as error:
            now_s = arguments[-1]
            assert isinstance(now_s, float)
            self._emit(Error(t=now_s, part="voice", text=str(error)))
            return False
