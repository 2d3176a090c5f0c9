"""The console of `sayso talk`: a prompt below, what happens above it. The one door to prompt_toolkit.

It is a client of the control socket; where no daemon runs, one of its own answers there, with a simulated robot.
"""

from __future__ import annotations

import asyncio
import logging
import signal
from collections.abc import AsyncIterator, Callable, Coroutine, Iterable
from contextlib import asynccontextmanager, suppress
from typing import Any, Final

from msgspec.structs import replace
from prompt_toolkit import PromptSession
from prompt_toolkit.completion import CompleteEvent, Completer, Completion
from prompt_toolkit.document import Document
from prompt_toolkit.history import FileHistory
from prompt_toolkit.key_binding import KeyBindings, KeyPressEvent
from prompt_toolkit.patch_stdout import patch_stdout

from daemon.app import App
from daemon.config import Config, socket_path, state_dir, store_path
from daemon.control import messages
from daemon.control.common import clean
from daemon.control.completing import Words
from daemon.control.reach import Reach, reach
from daemon.control.report import line
from daemon.control.talking import HELP, slash
from daemon.store import Store
from grammars.knowledge import born
from grammars.vocabulary import BORN, Vocabulary, from_policy

HISTORY: Final = "talk_history"
WATCH, STATUS, FIRST = 1, 2, 3  # numbers of requests; those from FIRST on are for what is said
LONGEST_ANSWER: Final = 1 << 20


async def converse(config: Config, speaker: str) -> int:
    """Talk until Ctrl-D, or until the daemon ends; the exit status.

    Raises:
        StoreError, ConfigError, OSError: there is no daemon, and none can be made here.
    """
    async with _answering(config) as ended:
        reader, writer = await asyncio.open_unix_connection(
            str(socket_path(config)), limit=LONGEST_ANSWER
        )
        console = Console(config, speaker, writer)
        with patch_stdout():
            tasks = {
                asyncio.create_task(console.prompt()),
                asyncio.create_task(console.listen(reader)),
                asyncio.create_task(console.learn_words()),
                asyncio.create_task(ended()),
            }
            done, rest = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
            for task in rest:
                task.cancel()
            await asyncio.gather(*rest, return_exceptions=True)
        writer.close()
        return max(task.result() for task in done)


class Console:
    """One conversation.

    Args:
        config: where the daemon and the history are.
        speaker: who is speaking.
        writer: the connection to the daemon.
    """

    def __init__(self, config: Config, speaker: str, writer: asyncio.StreamWriter) -> None:
        self._config, self._speaker, self._writer = config, speaker, writer
        self._number = FIRST
        self._pose: dict[str, Any] = {}
        self._link = "?"
        self._words = Words(BORN)
        self._new_words = asyncio.Event()
        self._new_words.set()
        folder = state_dir(config)
        folder.mkdir(parents=True, exist_ok=True)
        self._session: PromptSession[str] = PromptSession(
            "> ",
            history=FileHistory(str(folder / HISTORY)),
            completer=_Completer(lambda: self._words),
            complete_while_typing=True,
            bottom_toolbar=self._toolbar,
            key_bindings=self._keys(),
            reserve_space_for_menu=5,
        )

    async def prompt(self) -> int:
        """Take lines until the person leaves."""
        asyncio.get_running_loop().add_signal_handler(signal.SIGINT, self.stop)
        self._send(messages.Watch(v=1, id=WATCH))
        self._send(messages.Status(v=1, id=STATUS))
        while True:
            try:
                text = (await self._session.prompt_async(handle_sigint=False)).strip()
            except EOFError:
                return 0
            if text == "/quit":
                return 0
            await self._take(text)

    async def listen(self, reader: asyncio.StreamReader) -> int:
        """Show what happens until the daemon ends."""
        while raw := await reader.readline():
            match messages.read_answer(raw):
                case messages.Happened(id=number, event=event) if number == WATCH:
                    self._happened(event)
                case messages.Told(id=number, facts=facts) if number == STATUS:
                    self._pose, self._link = facts["pose"], facts["link"]
                case messages.Wrong(error=error):
                    print(f"not done: {error}")
            self._session.app.invalidate()
        print("the daemon ended")
        return 1

    async def learn_words(self) -> int:
        """Keep the completion up with what was taught; does not end."""
        while True:
            await self._new_words.wait()
            self._new_words.clear()
            self._words = await asyncio.to_thread(self._known_words)

    def stop(self) -> None:
        """Emergency stop."""
        self._send(messages.Stop(v=1, id=self._next()))

    async def _take(self, text: str) -> None:
        command, _, rest = text.partition(" ")
        if not text:
            return
        if command == "/speaker":
            self._speaker = rest.strip()[: messages.NAME_LENGTH]
        elif command == "/stop":
            self.stop()
        elif command == "/help":
            print(HELP)
        elif command.startswith("/"):
            await asyncio.to_thread(self._slash, command, rest)
        elif len(text) > messages.TEXT_LENGTH:
            print(f"not said: a sentence has at most {messages.TEXT_LENGTH} characters")
        else:
            self._send(messages.Say(v=1, id=self._next(), text=clean(text), speaker=self._speaker))

    def _slash(self, command: str, rest: str) -> None:
        """In a thread: it waits for the daemon."""
        with reach(self._config) as robot:
            slash(robot, command, rest, self._speaker, show=lambda _event: None)

    def _happened(self, event: dict[str, Any]) -> None:
        match event:
            case {"event": "pose"}:
                self._pose = event
            case {"event": "link", "up": up}:
                self._link = "up" if up else "down"
            case {"event": "lesson" | "retracted"}:
                self._new_words.set()
        if (shown := line(event)) is not None:
            print(shown)

    def _known_words(self) -> Words:
        with reach(self._config) as robot:
            words = Words(_vocabulary(robot))
        words.warm_up()
        return words

    def _toolbar(self) -> str:
        pose = self._pose
        where = (
            f"x {pose['x_cm']:.0f} cm, y {pose['y_cm']:.0f} cm, heading {pose['heading_deg']:.0f}°"
            if pose
            else "where: ?"
        )
        return f" {where}  |  link {self._link}  |  speaker {self._speaker or '-'}  |  Ctrl-C stops, /help "

    def _keys(self) -> KeyBindings:
        keys = KeyBindings()

        @keys.add("c-c")
        def _(event: KeyPressEvent) -> None:
            self.stop()
            event.current_buffer.reset()

        return keys

    def _send(self, request: messages.Request) -> None:
        self._writer.write(messages.line(request))

    def _next(self) -> int:
        self._number += 1
        return self._number


class _Completer(Completer):
    """The words that may come next."""

    def __init__(self, words: Callable[[], Words]) -> None:
        self._words = words

    def get_completions(
        self, document: Document, complete_event: CompleteEvent
    ) -> Iterable[Completion]:
        text = document.text_before_cursor
        for word in self._words().after(text):
            yield Completion(word, start_position=-len(Words.begun(text)))


def _vocabulary(robot: Reach) -> Vocabulary:
    return from_policy([*born(), *(row.lesson for row in robot.lessons() if row.counts)])


@asynccontextmanager
async def _answering(config: Config) -> AsyncIterator[Callable[[], Coroutine[Any, Any, int]]]:
    """A daemon answers at the socket meanwhile. Yields what waits for the end of one of our own."""
    with suppress(FileNotFoundError, ConnectionRefusedError):
        _, writer = await asyncio.open_unix_connection(str(socket_path(config)))
        writer.close()
        yield _never
        return
    logging.getLogger("sayso").addHandler(logging.NullHandler())  # it is all on the screen already
    ready = asyncio.Event()
    app = App(_simulated(config), Store.open(store_path(config)), lambda _line: ready.set())
    serving = asyncio.create_task(app.run())
    waiting = asyncio.create_task(ready.wait())
    try:
        await asyncio.wait((serving, waiting), return_when=asyncio.FIRST_COMPLETED)
        if serving.done():
            await serving
        print("no daemon runs: this is a simulated robot, until you leave")

        async def ended() -> int:
            return await asyncio.shield(serving)

        yield ended
    finally:
        waiting.cancel()
        app.close()
        await serving


async def _never() -> int:
    await asyncio.Event().wait()
    return 0


def _simulated(config: Config) -> Config:
    """As configured, but without a real robot, and without ears: the console has the keyboard."""
    simulated = config.robot.uri.startswith("sim://")
    robot = config.robot if simulated else replace(config.robot, uri="sim://forklift")
    return replace(config, robot=robot, hearing=replace(config.hearing, source=""))
