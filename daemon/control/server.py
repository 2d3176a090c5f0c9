"""The control socket: bounded in size, rate and number; a malformed request changes nothing."""

from __future__ import annotations

import asyncio
import os
import socket
import sqlite3
import struct
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Final, Protocol

from daemon import events
from daemon.control import messages
from daemon.control.messages import Done, Happened, OutcomeWord, Told, Wrong
from daemon.lessons import Row
from daemon.logbook import Entry

MODE_MASK: Final = 0o117  # the socket is 0660
CONNECTIONS: Final = 16
AT_ONCE: Final = 8  # requests of one connection that may run side by side
Slow = (
    messages.Say
    | messages.Hear
    | messages.Forget
    | messages.Lessons
    | messages.Log
    | messages.Watch
)
BACKLOG_BYTES: Final = (
    1 << 20
)  # what a client that does not read may leave unread before it is let go


class Reader(Protocol):
    """What clients may read."""

    async def lessons(self, after: int, most: int) -> tuple[Row, ...]:
        """Lessons with a greater number, at most so many."""

    async def log(self, last: int) -> tuple[Entry, ...]:
        """The last entries of the log."""


class Desk(Protocol):
    """What the daemon does for a client."""

    def subscribe(self, see: Callable[[events.Event], None]) -> Callable[[], None]:
        """Be told of every event; call the result to end it."""

    @property
    def book(self) -> Reader:
        """What it was taught and told."""

    async def say(self, text: str, speaker: str, source: str, aloud: bool = True) -> OutcomeWord:
        """Take a typed utterance and wait for what it comes to."""

    async def forget(self, numbers: tuple[int, ...], speaker: str, source: str) -> OutcomeWord:
        """Take lessons back by their numbers and wait for what it comes to."""

    async def hear(self, path: Path, speaker: str, source: str) -> OutcomeWord:
        """Take what a WAV file says and wait for what it comes to."""

    def stop(self, source: str) -> int:
        """Stop; the new epoch."""

    def status(self) -> dict[str, object]:
        """State of hearing, mind and link."""


class SocketTakenError(Exception):
    """Another daemon answers at this path."""

    def __init__(self, path: Path) -> None:
        super().__init__(f"{path}: another sayso answers there; set SAYSO_RUNTIME_DIR")
        self.path = path


class ControlServer:
    """Serves the socket until cancelled."""

    def __init__(self, path: Path, desk: Desk) -> None:
        self._path, self._desk = path, desk
        self._connections = 0
        self._bound: socket.socket | None = None

    def bind(self) -> None:
        """Make the socket; a stale file of a daemon that is gone is replaced.

        Raises:
            SocketTakenError: somebody answers there.
            OSError: no right, or the path is longer than the system allows.
        """
        self._path.parent.mkdir(parents=True, exist_ok=True, mode=0o750)
        if self._path.exists():
            with suppress(OSError), socket.socket(socket.AF_UNIX) as probe:
                probe.connect(str(self._path))
                raise SocketTakenError(self._path)
            self._path.unlink()
        bound = socket.socket(socket.AF_UNIX)
        before = os.umask(MODE_MASK)
        try:
            bound.bind(str(self._path))
            bound.listen()
        except OSError:
            bound.close()
            raise
        finally:
            os.umask(before)
        self._bound = bound

    async def serve(self) -> None:
        """Answer until cancelled; then remove the socket. Binds where that has not been done."""
        if self._bound is None:
            self.bind()
        bound, self._bound = self._bound, None
        server = await asyncio.start_unix_server(
            self._connected, sock=bound, limit=messages.LINE_BYTES
        )
        try:
            async with server:
                await server.serve_forever()
        finally:
            self._path.unlink(missing_ok=True)

    async def _connected(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        talk = _Talk(self._desk, reader, writer)
        self._connections += 1
        try:
            if self._connections > CONNECTIONS:
                talk.answer(Wrong(error="too many connections"))
            else:
                await talk.run()
        except (ConnectionError, asyncio.CancelledError):
            pass  # the client or the daemon went away; either way this talk is over
        finally:
            self._connections -= 1
            writer.close()


class _Talk:
    """One connection."""

    def __init__(
        self, desk: Desk, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        self._desk, self._reader, self._writer = desk, reader, writer
        self._source = f"control uid={_peer_uid(writer)}"
        self._running: set[asyncio.Task[None]] = set()
        self._allowance = float(messages.BURST)
        self._counted_s = asyncio.get_running_loop().time()

    def answer(self, message: messages.Answer) -> None:
        """Send one line; a client that does not read is let go."""
        if self._writer.is_closing():
            return
        if self._writer.transport.get_write_buffer_size() > BACKLOG_BYTES:
            self._writer.transport.abort()
            return
        self._writer.write(messages.line(message))

    async def run(self) -> None:
        """Until the client closes or says too much at once."""
        try:
            while line := await self._line():
                self._handle(line)
        finally:
            for task in self._running:
                task.cancel()

    async def _line(self) -> bytes:
        try:
            return await self._reader.readuntil(b"\n")
        except asyncio.IncompleteReadError as rest:
            if rest.partial:
                self.answer(Wrong(error="a request ends with a newline"))
            return b""
        except asyncio.LimitOverrunError:
            self.answer(Wrong(error=f"a request has at most {messages.LINE_BYTES} bytes"))
            return b""

    def _handle(self, line: bytes) -> None:
        try:
            request = messages.read_request(line)
        except ValueError as error:
            self.answer(Wrong(error=str(error)))
            return
        if isinstance(request, messages.Stop):  # never refused
            self.answer(Told(id=request.id, facts={"epoch": self._desk.stop(self._source)}))
            return
        if not self._may():
            self.answer(Wrong(id=request.id, error="too many requests; wait a second"))
            return
        if isinstance(request, messages.Status):
            self.answer(Told(id=request.id, facts=self._desk.status()))
            return
        if len(self._running) >= AT_ONCE:
            self.answer(Wrong(id=request.id, error=f"at most {AT_ONCE} requests at a time"))
            return
        task = asyncio.create_task(self._run(request))
        self._running.add(task)
        task.add_done_callback(self._running.discard)

    async def _run(self, request: Slow) -> None:
        def tell(event: events.Event) -> None:
            self.answer(Happened(id=request.id, event=events.as_dict(event)))

        reads = isinstance(request, messages.Lessons | messages.Log)
        unsubscribe = None if reads else self._desk.subscribe(tell)
        try:
            self.answer(await self._answered(request))
        except (OSError, ValueError, sqlite3.Error) as error:
            self.answer(Wrong(id=request.id, error=str(error)))
        finally:
            if unsubscribe is not None:
                unsubscribe()

    async def _answered(self, request: Slow) -> messages.Answer:
        desk, ident = self._desk, request.id
        match request:
            case messages.Say(text=text, speaker=speaker, aloud=aloud):
                outcome = await desk.say(text, speaker, self._source, aloud)
            case messages.Hear(path=path, speaker=speaker):
                outcome = await desk.hear(Path(path), speaker, self._source)
            case messages.Forget(lessons=numbers, speaker=speaker):
                outcome = await desk.forget(numbers, speaker, self._source)
            case messages.Lessons(after=after, most=most):
                found = await desk.book.lessons(after, most + 1)
                facts = {"lessons": found[:most], "more": len(found) > most}
                return Told(id=ident, facts=facts)
            case messages.Log(last=last):
                return Told(id=ident, facts={"entries": await desk.book.log(last)})
            case messages.Watch():
                await asyncio.get_running_loop().create_future()
        return Done(id=ident, outcome=outcome)

    def _may(self) -> bool:
        now_s = asyncio.get_running_loop().time()
        gained = (now_s - self._counted_s) * messages.REQUESTS_A_SECOND
        self._allowance = min(self._allowance + gained, messages.BURST)
        self._counted_s = now_s
        if self._allowance < 1:
            return False
        self._allowance -= 1
        return True


def _peer_uid(writer: asyncio.StreamWriter) -> int:
    """The user at the other end (SO_PEERCRED)."""
    connection = writer.get_extra_info("socket")
    raw = connection.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, struct.calcsize("3i"))
    _, uid, _ = struct.unpack("3i", raw)
    return int(uid)
