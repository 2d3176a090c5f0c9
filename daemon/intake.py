"""Utterances on their way to the mind: parsed one after another beside the loop, and logged."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from dataclasses import dataclass

from daemon.aside import Aside
from daemon.loop import Cycle
from daemon.understanding import Understanding, understand, warm_up
from daemon.writer import Writer
from kernel.memory.meaning import Utterance


@dataclass(frozen=True, slots=True)
class _Waiting:
    """An utterance on its way to the parser. meant: its meaning, where it was not given in English."""

    utterance: Utterance
    source: str
    epoch: int
    taken: asyncio.Future[None]
    meant: Understanding | None


class Intake:
    """The parser's queue.

    Args:
        cycle: takes the meanings.
        writer: logs the utterances.
        wake: called when something is there for the cycle.
    """

    def __init__(self, cycle: Cycle, writer: Writer, wake: Callable[[], None]) -> None:
        self._cycle, self._writer, self._wake = cycle, writer, wake
        self._utterances: asyncio.Queue[_Waiting] = asyncio.Queue()
        self._parser = Aside("parser")

    def submit(
        self, utterance: Utterance, source: str, meant: Understanding | None = None
    ) -> asyncio.Future[None]:
        """Into the parser's queue; a stop word acts now. The result is there once the meaning is on its way."""
        epoch = self._cycle.begin(utterance, source)
        taken: asyncio.Future[None] = asyncio.get_running_loop().create_future()
        self._utterances.put_nowait(_Waiting(utterance, source, epoch, taken, meant))
        self._wake()
        return taken

    async def serve(self) -> None:
        """Parse one utterance after another until cancelled."""
        while True:
            waiting = await self._utterances.get()
            utterance, understanding = waiting.utterance, waiting.meant
            if understanding is None:
                understanding = await self._understand(utterance)
            self._cycle.take(understanding, waiting.epoch, waiting.source)
            at_s, text, speaker = utterance.at_s, utterance.text, utterance.speaker
            self._writer.log(at_s, text, speaker, waiting.source, understanding.kind)
            if not waiting.taken.done():
                waiting.taken.set_result(None)
            self._wake()

    async def warm_up(self) -> None:
        """Compile the grammar before the first sentence comes; raises whatever is wrong with it."""
        await self._parser.run(warm_up, self._cycle.vocabulary)

    def close(self) -> None:
        """End the parser's thread; does not wait."""
        self._parser.close()

    async def _understand(self, utterance: Utterance) -> Understanding:
        try:
            words, asked = self._cycle.vocabulary, self._cycle.expecting
            return await self._parser.run(understand, utterance, words, asked)
        except Exception as error:  # one sentence that breaks the parser must not end hearing
            return self._cycle.puzzled(utterance, error)
