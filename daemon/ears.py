"""What the daemon hears: sound files, on request or as its source, played at their own pace."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from daemon.aside import Aside
from daemon.clock import Clock
from daemon.config import Hearing
from daemon.hearing.events import Heard, HearingEvent, NotHeard, StopWord
from daemon.loop import Cycle
from kernel.memory.meaning import Utterance

if TYPE_CHECKING:
    from daemon.virtual_ear import Recorded, VirtualEar

Submit = Callable[[Utterance, str], asyncio.Future[None]]


class Ears:
    """One recogniser, started with the first sound.

    Args:
        hearing: which engine, which source.
        cycle: stopped by stop words, told what was not clear.
        submit: takes utterances.
    """

    def __init__(self, hearing: Hearing, cycle: Cycle, submit: Submit) -> None:
        self._hearing, self._cycle, self._submit = hearing, cycle, submit
        self._ear: VirtualEar | None = None
        self._one_at_a_time = asyncio.Lock()
        self._aside = Aside("ears")

    async def serve(self) -> None:
        """Hear the configured source to its end; typed: there is nothing to hear."""
        if self._hearing.source != "typed":
            await self.play(Path(self._hearing.source), "", "heard")

    async def play(self, path: Path, speaker: str, source: str) -> None:
        """Hear a file; what is in it happens at the time its sound has.

        Raises:
            ValueError: the file cannot be heard, or the recogniser cannot be used.
        """
        async with self._one_at_a_time:
            began_s = asyncio.get_running_loop().time()
            recorded = await self._aside.run(self._transcribe, path)
            if not recorded.said:
                self._cycle.unclear("", "noise")
            for known_s, event in recorded.events:
                late_s = asyncio.get_running_loop().time() - began_s - known_s
                await asyncio.sleep(max(0.0, -late_s))
                await self._perceive(event, speaker, source)

    def close(self) -> None:
        """End the recogniser; does not wait for it."""
        self._aside.run(self._end)
        self._aside.close()

    def _end(self) -> None:
        if self._ear is not None:
            self._ear.close()

    def _transcribe(self, path: Path) -> Recorded:
        from daemon.hearing.recogniser import EngineError
        from daemon.hearing.recording import RecordingError
        from daemon.virtual_ear import VirtualEar

        try:
            if self._ear is None:
                self._ear = VirtualEar(self._hearing.engine, self._hearing.model)
            return self._ear.hear(path, self._cycle.vocabulary)
        except (RecordingError, EngineError) as error:
            raise ValueError(str(error)) from error

    async def _perceive(self, event: HearingEvent, speaker: str, source: str) -> None:
        match event:
            case StopWord():
                self._cycle.stop("spotted")
            case Heard(text=text, confidence=confidence):
                await self._submit(Utterance(text, speaker, Clock.wall_s(), confidence), source)
            case NotHeard(text=text, reason=reason):
                self._cycle.unclear(text, reason)
