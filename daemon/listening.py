"""The ear in a thread and an event loop of its own: trying its alternatives on the parser holds nothing up."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable, Coroutine
from concurrent.futures import Future
from contextlib import suppress
from typing import Any, Final, TypeVar

import numpy as np

from daemon.hearing.choice import Engine
from daemon.hearing.ear import Ear, play
from daemon.hearing.events import HearingEvent
from daemon.hearing.recogniser import RATE_HZ, EngineError, Samples
from daemon.hearing.recogniser_process import PATIENCE_S
from daemon.understanding import understand
from grammars.asking import AskWord
from grammars.language import language
from grammars.vocabulary import Vocabulary
from kernel.memory.meaning import Utterance
from kernel.memory.reply import AskKeep, AskWhich

QUIET_S: Final = 0.1
BEFORE_S: Final = (
    1.0  # of quiet before a recording, which takes no time: the room in which it is said
)
VERDICT_S: Final = 0.02  # a block takes the recogniser a few ms
LONGEST_QUIET_S: Final = 6.0  # more than the longest wait for the rest of a sentence

R = TypeVar("R")


class Listening:
    """An ear that listens from now until `close`.

    Args:
        engine: which recogniser.
        vocabulary: the words it knows at first.
        perceive: called from the ear's thread with everything it reports.
        expecting: called from there for the robot's open question: only then are its answers sentences.
    """

    def __init__(
        self,
        engine: Engine,
        vocabulary: Vocabulary,
        perceive: Callable[[HearingEvent], None],
        expecting: Callable[[], AskWhich | AskKeep | AskWord | None],
    ) -> None:
        self._expecting = expecting
        self._engine, self._vocabulary, self._perceive = engine, vocabulary, perceive
        self._started: Future[tuple[asyncio.AbstractEventLoop, asyncio.Task[None], Ear]] = Future()
        threading.Thread(target=self._main, name="ear", daemon=True).start()

    async def ready(self) -> None:
        """Wait until the recogniser is loaded.

        Raises:
            EngineError: it cannot be used.
        """
        loop, task, ear = await asyncio.wrap_future(self._started)

        async def loaded() -> None:
            waiting = asyncio.create_task(ear.ready.wait())
            await asyncio.wait((waiting, task), return_when=asyncio.FIRST_COMPLETED)
            waiting.cancel()
            if task.done():
                task.result()

        await asyncio.wrap_future(asyncio.run_coroutine_threadsafe(loaded(), loop))

    async def play(self, samples: Samples) -> None:
        """Let it hear a recording at the speed it was spoken, then silence until all of it is decided."""
        quiet = np.zeros(round(QUIET_S * RATE_HZ), np.int16)

        async def until_idle(ear: Ear) -> None:
            async with asyncio.timeout(PATIENCE_S):
                while not ear.idle:  # noqa: ASYNC110 - new words come first: they may be in it
                    await asyncio.sleep(VERDICT_S)
            for _ in range(round(BEFORE_S / QUIET_S)):
                ear.hear(quiet)
            await play(samples, ear)
            for _ in range(round(LONGEST_QUIET_S / QUIET_S)):
                await asyncio.sleep(VERDICT_S)
                if ear.idle:
                    return
                await play(quiet, ear)

        await self._there(until_idle)

    def know(self, vocabulary: Vocabulary) -> None:
        """Other words, as soon as nothing is being said; does not wait."""

        def learn(ear: Ear) -> None:
            self._vocabulary = vocabulary
            ear.set_language(language(vocabulary))

        if self._started.done() and self._started.exception() is None:
            loop, _, ear = self._started.result()
            with suppress(RuntimeError):  # it has ended
                loop.call_soon_threadsafe(learn, ear)

    def close(self) -> None:
        """End it; does not wait."""
        if self._started.done() and self._started.exception() is None:
            loop, task, _ = self._started.result()
            with suppress(RuntimeError):  # it has ended already
                loop.call_soon_threadsafe(task.cancel)

    async def _there(self, do: Callable[[Ear], Coroutine[Any, Any, R]]) -> R:
        loop, _, ear = await asyncio.wrap_future(self._started)
        return await asyncio.wrap_future(asyncio.run_coroutine_threadsafe(do(ear), loop))

    def _main(self) -> None:
        try:
            asyncio.run(self._serve())
        except (EngineError, asyncio.CancelledError):
            pass  # whoever waits for it was told
        except BaseException as error:
            if self._started.done():
                raise
            self._started.set_exception(error)

    async def _serve(self) -> None:
        ear = Ear(self._engine, language(self._vocabulary), self._parses)
        serving = asyncio.create_task(ear.serve())
        self._started.set_result((asyncio.get_running_loop(), serving, ear))
        reporting = asyncio.create_task(self._report(ear))
        try:
            await serving
        finally:
            reporting.cancel()

    async def _report(self, ear: Ear) -> None:
        while True:
            self._perceive(await ear.events.get())

    def _parses(self, text: str) -> bool:
        return understand(Utterance(text), self._vocabulary, self._expecting()).heard is not None
