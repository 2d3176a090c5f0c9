"""What the daemon hears: sound files, on request or as its source, at the pace they were spoken; typed lines."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Final

from daemon.aside import Aside
from daemon.clock import Clock
from daemon.config import Hearing, model_folders
from daemon.hearing.events import Heard, HearingEvent, NotHeard, StopWord
from daemon.hearing.typed import typed
from daemon.loop import Cycle
from kernel.memory.meaning import Utterance

if TYPE_CHECKING:
    from daemon.hearing.recogniser import Samples
    from daemon.listening import Listening

LONGEST_LINE: Final = 4096  # bytes

Submit = Callable[[Utterance, str], asyncio.Future[None]]


@dataclass(slots=True)
class _Playing:
    """A recording being heard."""

    speaker: str
    source: str
    utterances: int = 0
    taken: list[asyncio.Future[None]] = field(default_factory=list)


class Ears:
    """One recogniser, started with the first sound.

    Args:
        hearing: which engine, which source.
        cycle: stopped by stop words, told what was not clear.
        submit: takes utterances.
    """

    def __init__(self, hearing: Hearing, cycle: Cycle, submit: Submit) -> None:
        self._hearing, self._cycle, self._submit = hearing, cycle, submit
        self._loop = asyncio.get_running_loop()
        self._aside = Aside("files")
        self._listening: Listening | None = None
        self._known = cycle.vocabulary
        self._playing = _Playing("", "heard")
        self._one_at_a_time = asyncio.Lock()

    async def serve(self) -> None:
        """Hear the configured source to its end; typed: the lines of the standard input; "": only what is played."""
        if self._hearing.source == "typed":
            await self._read_lines()
        elif self._hearing.source:
            await self.play(Path(self._hearing.source), "", "heard")

    async def _read_lines(self) -> None:
        self._playing = _Playing("", "typed")
        keyboard = Aside("keyboard")  # a terminal cannot be waited for like a socket
        try:
            while line := await keyboard.run(sys.stdin.buffer.readline, LONGEST_LINE):
                for event in typed(line.decode(errors="replace"), self._loop.time()):
                    self._perceive(event)
                self._playing.taken.clear()
        finally:
            keyboard.close()

    async def play(self, path: Path, speaker: str, source: str) -> None:
        """Hear a file; ends when nothing of it is left to be decided.

        Raises:
            ValueError: the file cannot be heard, or the recogniser cannot be used.
        """
        samples = await self._aside.run(_read, path)
        async with self._one_at_a_time:
            listening = await self._ready()
            self._playing = playing = _Playing(speaker, source)
            await listening.play(samples)
            await asyncio.gather(*playing.taken)
            if playing.utterances == 0:
                self._cycle.unclear("", "noise")

    def refresh(self) -> None:
        """Hand words that were learned to the recogniser; it takes them between two utterances."""
        if self._listening is not None and self._cycle.vocabulary != self._known:
            self._known = self._cycle.vocabulary
            self._listening.know(self._known)

    def close(self) -> None:
        """End the recogniser; does not wait for it."""
        self._aside.close()
        if self._listening is not None:
            self._listening.close()

    async def _ready(self) -> Listening:
        from daemon.hearing.choice import choose_engine
        from daemon.hearing.recogniser import EngineError
        from daemon.listening import Listening

        try:
            if self._listening is None:
                engine = choose_engine(self._hearing.engine, self._hearing.model, model_folders())
                self._known = self._cycle.vocabulary
                self._listening = Listening(
                    engine, self._known, self._from_the_ear, lambda: self._cycle.expecting
                )
            await self._listening.ready()
            self.refresh()
        except EngineError as error:
            self._listening = None
            raise ValueError(str(error)) from error
        return self._listening

    def _from_the_ear(self, event: HearingEvent) -> None:
        self._loop.call_soon_threadsafe(self._perceive, event)

    def _perceive(self, event: HearingEvent) -> None:
        playing = self._playing
        match event:
            case StopWord():
                self._cycle.stop("spotted")
            case Heard(text=text, confidence=confidence):
                utterance = Utterance(text, playing.speaker, Clock.wall_s(), confidence)
                playing.utterances += 1
                playing.taken.append(self._submit(utterance, playing.source))
            case NotHeard(text=text, reason=reason):
                self._cycle.unclear(text, reason)
                playing.utterances += 1


def _read(path: Path) -> Samples:
    from daemon.hearing import recording

    try:
        return recording.read(path)
    except recording.RecordingError as error:
        raise ValueError(str(error)) from error
