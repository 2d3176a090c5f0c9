"""The ear in real time: the recogniser's process fed from a source, without ever holding up the event loop."""

from __future__ import annotations

import asyncio
from contextlib import suppress

import msgspec

from daemon.hearing.choice import Engine
from daemon.hearing.events import Ended, HearingEvent, NotHeard
from daemon.hearing.recogniser import RATE_HZ, EngineError, Samples
from daemon.hearing.recogniser_process import COMMAND, PATIENCE_S
from daemon.hearing.recording import blocks
from daemon.hearing.trust import Parses, choose
from daemon.hearing.worker import (
    HEADER,
    Noticed,
    Refused,
    Reply,
    Request,
    SetLanguage,
    SetUp,
    Sound,
    framed,
)
from grammars.language import Language

MOST_BLOCKS = 50
"""Blocks that may wait for the recogniser: 5 s. Beyond that the oldest are dropped, and counted."""
GATE_AFTER_S = 0.3
"""The robot's own voice hangs in the room a little longer than it speaks."""
RESTART_S = 0.5
"""Wait before a dead recogniser is started again, doubled each time it dies without having heard anything."""
LONGEST_RESTART_S = 10.0


class Ear:
    """Hears until cancelled; restarts the recogniser when it dies, and reports what was lost.

    `serve` runs it; `hear` takes sound from any source; `events` are to be taken from the queue of that name.
    """

    def __init__(
        self, engine: Engine, language: Language, parses: Parses, robot_name: str = "robot"
    ) -> None:
        self._engine, self._language, self._name = engine, language, robot_name
        self.parses = parses
        self.events: asyncio.Queue[HearingEvent] = asyncio.Queue()
        self.ready = asyncio.Event()
        self.dropped = 0
        self.restarts = 0
        self.unheard: tuple[str, ...] = ()
        self._process: asyncio.subprocess.Process | None = None
        self._blocks: asyncio.Queue[Sound] = asyncio.Queue(MOST_BLOCKS)
        self._fresh: Language | None = None
        self._heard_s = 0.0
        self._base_s = 0.0
        self._gate_s = -GATE_AFTER_S
        self._speaking = False
        self._idle = True

    @property
    def idle(self) -> bool:
        """All sound so far has been heard, nothing is being said, and no new language is being taken."""
        return self._idle

    @property
    def pid(self) -> int | None:
        """Process id of the recogniser; None while there is none."""
        return self._process.pid if self._process else None

    def kill(self) -> None:
        """End the recogniser at once, as a hang or a crash would; it is started again."""
        if self._process:
            self.ready.clear()
            self._process.kill()

    def hear(self, samples: Samples) -> None:
        """Take a block of sound; never waits."""
        if self._blocks.full():
            self._blocks.get_nowait()
            self.dropped += 1
        if self._speaking:
            self._gate_s = self._heard_s
        gated = self._speaking or self._heard_s - self._gate_s < GATE_AFTER_S
        self._blocks.put_nowait(Sound(samples.tobytes(), gated))
        self._idle = False
        self._heard_s += len(samples) / RATE_HZ

    def speaking(self, now: bool) -> None:
        """Tell the ear that the robot begins or ends to speak: meanwhile only a stop word counts."""
        if self._speaking and not now:
            self._gate_s = self._heard_s
        self._speaking = now

    def set_language(self, language: Language) -> None:
        """Take a new language as soon as nothing is being said, not only when the next sound comes."""
        self._language = self._fresh = language
        self._idle = False
        if not self._blocks.full():
            self._blocks.put_nowait(Sound(b""))

    async def serve(self) -> None:
        """Run the recogniser until cancelled.

        Raises:
            EngineError: the engine cannot be used; says why.
        """
        wait_s = RESTART_S
        while True:
            began_s = self._base_s
            try:
                await self._run()
            except (OSError, asyncio.IncompleteReadError, msgspec.DecodeError):
                self.ready.clear()
                self.restarts += 1
                heard_s = self._base_s
                self.events.put_nowait(NotHeard(began_s, heard_s, heard_s, "lost"))
                await asyncio.sleep(wait_s)
                fruitless = self._base_s - began_s < RESTART_S
                wait_s = min(wait_s * 2, LONGEST_RESTART_S) if fruitless else RESTART_S

    async def _run(self) -> None:
        """One process, from start to death."""
        process = await asyncio.create_subprocess_exec(
            *COMMAND, stdin=asyncio.subprocess.PIPE, stdout=asyncio.subprocess.PIPE
        )
        self._process = process
        assert process.stdin is not None
        assert process.stdout is not None
        channel = _Channel(process.stdin, process.stdout)
        began_s = self._base_s
        try:
            self._fresh = None
            await self._ask_ready(
                channel,
                SetUp(self._engine.name, self._engine.model, self._name, self._language),
            )
            self.ready.set()
            while True:
                block = await self._blocks.get()
                if self._fresh is not None:
                    language, self._fresh = self._fresh, None
                    await self._ask_ready(channel, SetLanguage(language))
                self._base_s += len(block.samples) / 2 / RATE_HZ
                reply = await channel.ask(block)
                if isinstance(reply, Noticed):
                    for event in reply.events:
                        shifted = event.shifted(began_s)
                        if isinstance(shifted, Ended):
                            self.events.put_nowait(
                                choose(shifted, self.parses, self._engine.thresholds)
                            )
                        else:
                            self.events.put_nowait(shifted)
                    self._idle = reply.idle and self._blocks.empty()
        finally:
            with suppress(ProcessLookupError):
                process.kill()
            await process.wait()
            self._process = None

    async def _ask_ready(self, channel: _Channel, request: SetUp | SetLanguage) -> None:
        reply = await channel.ask(request)
        if isinstance(reply, Refused):
            raise EngineError(reply.message)
        if not isinstance(reply, Noticed):
            self.unheard = reply.unheard


class _Channel:
    """Requests and replies over the pipes of a process."""

    def __init__(self, to: asyncio.StreamWriter, back: asyncio.StreamReader) -> None:
        self._to, self._back = to, back
        self._decoder: msgspec.msgpack.Decoder[Reply] = msgspec.msgpack.Decoder(Reply)

    async def ask(self, request: Request) -> Reply:
        async with asyncio.timeout(PATIENCE_S):
            self._to.write(framed(request))
            await self._to.drain()
            (length,) = HEADER.unpack(await self._back.readexactly(HEADER.size))
            return self._decoder.decode(await self._back.readexactly(length))


async def play(samples: Samples, ear: Ear) -> None:
    """Feed an ear a recording at the speed it was spoken."""
    loop = asyncio.get_running_loop()
    due_s = loop.time()
    for block in blocks(samples):
        due_s += len(block) / RATE_HZ
        await asyncio.sleep(due_s - loop.time())
        ear.hear(block)
