"""The daemon: one TaskGroup in which link, hearing, control socket and the control loop run side by side.

The loop makes a step `tick_hz` times a second, and at once when something arrives. Nothing in it waits: sentences are
parsed and lessons stored in threads of their own.
"""

from __future__ import annotations

import asyncio
import logging
import signal
import sys
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Final

from daemon import config as configuration
from daemon import events
from daemon.book import Book
from daemon.clock import Clock, process_age_s
from daemon.config import Config
from daemon.control.messages import OutcomeWord
from daemon.control.server import ControlServer
from daemon.ears import Ears
from daemon.intake import Intake
from daemon.journal import journal
from daemon.lessons import missing
from daemon.link import Link
from daemon.loop import Cycle
from daemon.notify import Notifier
from daemon.outcome import Following
from daemon.parts import assemble
from daemon.store import Store
from daemon.supervise import supervise
from daemon.understanding import Understanding, forgetting
from daemon.writer import Writer
from kernel.memory.meaning import Utterance

AFTERMATH_S: Final = 1.0  # what an utterance still brings about after its end: a complaint, say
SETTLE_S: Final = 60.0  # how long a client is kept waiting for an utterance to come to an end


def main(config: Config, *, verbose: bool = False) -> int:
    """Run the daemon until it is told to end; the exit status.

    Raises:
        StoreError, SocketTakenError, PortError, NoVoiceError, OSError: it cannot start.
    """
    logging.basicConfig(
        level=logging.DEBUG if verbose else logging.INFO,
        format="%(levelname).1s %(message)s",
        stream=sys.stderr,
    )
    store = Store.open(configuration.store_path(config))
    return asyncio.run(_run(config, store))


async def _run(config: Config, store: Store) -> int:
    try:
        app = App(config, store, lambda line: print(line, flush=True))
    except BaseException:
        store.close()
        raise
    return await app.run()


class App:
    """The running daemon, and what it does for clients of the control socket.

    Args:
        config: what to run.
        store: open; closed by `run`.
        announce: called once with a line for a person when it is ready.
    """

    def __init__(self, config: Config, store: Store, announce: Callable[[str], None]) -> None:
        self._config, self._announce = config, announce
        self._clock = Clock()
        self._loop = asyncio.get_running_loop()
        self._awake = asyncio.Event()
        self._closing = asyncio.Event()
        self._watchers: list[Callable[[events.Event], None]] = [journal]
        self._settling: list[tuple[Following, asyncio.Future[None]]] = []
        self._notifier = Notifier()
        self._store = store
        self._writer = Writer(store, self._wake_from_thread, self._store_failed)
        self._parts = assemble(config, store, self._writer, self._emit)
        self._cycle = self._parts.cycle
        self._parts.link.on_arrival = self._awake.set
        self.book = Book(lambda: self._cycle.mind.history, self._parts.loaded.resting, self._writer)
        self._intake = Intake(self._cycle, self._writer, self._awake.set)
        self._ears = Ears(config.hearing, self._cycle, self._intake.submit)

    async def run(self) -> int:
        """Serve until SIGTERM or SIGINT; the exit status."""
        for number in (signal.SIGTERM, signal.SIGINT):  # first: who sees the socket may send one
            self._loop.add_signal_handler(number, self.close)
        server = ControlServer(configuration.socket_path(self._config), self)
        server.bind()
        try:
            async with asyncio.TaskGroup() as group:
                tasks = [
                    group.create_task(part, name=name)
                    for name, part in {
                        "link": supervise("link", self._parts.link.serve, self._failed),
                        "control": supervise("control", server.serve, self._failed),
                        "understanding": self._intake.serve(),
                        "loop": self._turn(),
                        "warming up": self._warm_up(),
                        "hearing": supervise("hearing", self._ears.serve, self._failed),
                    }.items()
                ]
                await self._closing.wait()
                self._notifier.stopping()
                self._cycle.stop(
                    "closing"
                )  # the link says it again, and waits a moment for the answer
                for task in tasks:
                    task.cancel()
        finally:
            self._ears.close()
            self._intake.close()
            self.book.close()
            self._writer.close()
            self._store.close()
        return 0

    # For whoever runs it in his own process (daemon.demo.live).

    @property
    def cycle(self) -> Cycle:
        """For looking: idle, vocabulary, pose."""
        return self._cycle

    @property
    def link(self) -> Link:
        """The link to the robot."""
        return self._parts.link

    @property
    def now_s(self) -> float:
        """The time its events carry, s."""
        return self._clock.now_s()

    def close(self) -> None:
        """End `run` as SIGTERM does."""
        self._closing.set()

    # What clients may ask for (daemon.control.server.Desk).

    def subscribe(self, see: Callable[[events.Event], None]) -> Callable[[], None]:
        """Be told of every event; call the result to end it."""
        self._watchers.append(see)
        return lambda: self._watchers.remove(see)

    async def say(self, text: str, speaker: str, source: str, aloud: bool = True) -> OutcomeWord:
        """Take a typed utterance and wait for what it comes to. aloud: lessons are acknowledged by voice."""
        self._cycle.hushing += not aloud
        try:
            return await self._follow(Utterance(text, speaker, self._clock.wall_s()), source)
        finally:
            self._cycle.hushing -= not aloud

    async def forget(self, numbers: tuple[int, ...], speaker: str, source: str) -> OutcomeWord:
        """Take lessons back by their numbers and wait for what it comes to.

        Raises:
            ValueError: one of them is not in force.
        """
        if wrong := missing(numbers, await self.book.lessons()):
            raise ValueError("; ".join(wrong))
        meant = forgetting(numbers, speaker, self._clock.wall_s())
        return await self._follow(meant.utterance, source, meant)

    async def hear(self, path: Path, speaker: str, source: str) -> OutcomeWord:
        """Take what a sound file says, at the times its own sound has, and wait for what it comes to.

        Raises:
            ValueError: the file cannot be heard, or the recogniser cannot be used.
        """
        following = Following()
        unsubscribe = self.subscribe(following.see)
        try:
            await self._ears.play(path, speaker, source)
            return await self._settled(following)
        finally:
            unsubscribe()

    def stop(self, source: str) -> int:
        """STOP, at once; the new epoch."""
        epoch = self._cycle.stop(source)
        self._awake.set()
        return epoch

    def status(self) -> dict[str, object]:
        """State of hearing, mind and link."""
        return {
            "uptime_s": round(self._clock.now_s(), 1),
            "robot": self._config.robot.uri,
            "link": "up" if self._parts.link.connected else self._parts.link.detail,
            "hearing": self._config.hearing.source,
            "lessons": sum(lesson.ident > 0 for lesson in self._cycle.mind.policy),
            "resting": len(self._parts.loaded.resting),
            "speaker": self._cycle.mind.speaker,
            "busy": not self._cycle.settled,
            "stop_epoch": self._parts.link.stop_epoch,
            "pose": events.as_dict(self._cycle.pose),
        }

    # The parts.

    async def _turn(self) -> None:
        """The control loop."""
        period_s = 1 / self._config.mind.tick_hz
        while True:
            self._awake.clear()
            now_s = self._clock.now_s()
            self._cycle.step(now_s)
            if self._cycle.failures == 0:
                self._notifier.advanced(now_s)
            self._ears.refresh()
            self._settle(now_s)
            with suppress(TimeoutError):
                async with asyncio.timeout(now_s + period_s - self._clock.now_s()):
                    await self._awake.wait()

    async def _follow(
        self, utterance: Utterance, source: str, meant: Understanding | None = None
    ) -> OutcomeWord:
        following = Following(utterance.text)
        unsubscribe = self.subscribe(following.see)
        try:
            await self._intake.submit(utterance, source, meant)
            return await self._settled(following)
        finally:
            unsubscribe()

    def _settle(self, now_s: float) -> None:
        """Let go of those who wait: nothing goes on, or what they said is over, though something endless is not."""
        waiting, self._settling = self._settling, []
        for following, future in waiting:
            if self._cycle.settled or following.over_for(AFTERMATH_S, now_s):
                if not future.done():
                    future.set_result(None)
            else:
                self._settling.append((following, future))

    async def _settled(self, following: Following) -> OutcomeWord:
        settled: asyncio.Future[None] = self._loop.create_future()
        self._settling.append((following, settled))
        try:
            async with asyncio.timeout(SETTLE_S):
                await settled
        except TimeoutError:
            return "running"
        return following.outcome

    async def _warm_up(self) -> None:
        """Compile the grammar before the first sentence comes: ready means able to listen."""
        try:
            await self._intake.warm_up()
        except Exception as error:  # told now, not at the first sentence
            self._failed("understanding", f"{type(error).__name__}: {error}")
        self._ready()

    def _ready(self) -> None:
        loaded = self._parts.loaded
        known = f"{len(loaded.lessons)} lessons"
        resting = f", {len(loaded.resting)} lessons rest" if loaded.resting else ""
        for lesson in loaded.resting:
            self._failed("store", f"lesson {lesson.ident} rests: {lesson.words}: {lesson.why}")
        line = f"ready after {process_age_s():.2f} s: {self._config.robot.uri}, {known}{resting}"
        self._announce(line)
        self._notifier.ready(line)

    def _emit(self, event: events.Event) -> None:
        for see in tuple(self._watchers):
            see(event)

    def _failed(self, part: str, reason: str) -> None:
        self._emit(events.Error(t=self._clock.now_s(), part=part, text=reason))

    def _store_failed(self, reason: str) -> None:
        self._loop.call_soon_threadsafe(self._failed, "store", reason)

    def _wake_from_thread(self) -> None:
        with suppress(RuntimeError):  # the loop is closed: nobody is left to wake
            self._loop.call_soon_threadsafe(self._awake.set)
