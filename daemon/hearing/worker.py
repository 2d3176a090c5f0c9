"""The recogniser's process: an engine and a listener, driven by messages on standard input and output.

Run as `python -m daemon.hearing.worker`. Every message gets one reply. The native engines are imported here and
nowhere else: they hold the interpreter's lock for most of a second, and they can crash.
"""

from __future__ import annotations

import os
import struct
import sys
from typing import BinaryIO

import msgspec
import numpy as np

from daemon.hearing.events import CoreEvent
from daemon.hearing.listener import Listener
from daemon.hearing.recogniser import EngineError, load
from grammars.language import Language

HEADER = struct.Struct("<I")


class SetUp(msgspec.Struct, frozen=True, tag=True):
    """Load an engine and begin to listen, at audio time 0. First message of all; may come again."""

    engine: str
    model: str
    robot_name: str
    language: Language


class SetLanguage(msgspec.Struct, frozen=True, tag=True):
    """Take a new language. It is taken at once when nothing is being said, else as soon as that has ended."""

    language: Language


class Sound(msgspec.Struct, frozen=True, tag=True):
    """Hear some more: 16-bit samples; gated while the robot speaks."""

    samples: bytes
    gated: bool = False


class Ready(msgspec.Struct, frozen=True, tag=True):
    """Reply to SetUp and SetLanguage: the words that cannot be heard."""

    unheard: tuple[str, ...] = ()


class Noticed(msgspec.Struct, frozen=True, tag=True):
    """Reply to Sound: what was noticed, and whether nothing is being said now."""

    events: tuple[CoreEvent, ...]
    idle: bool


class Refused(msgspec.Struct, frozen=True, tag=True):
    """Reply to SetUp: the engine cannot be used, for the reason that stands in message."""

    message: str


Request = SetUp | SetLanguage | Sound
Reply = Ready | Noticed | Refused


class Worker:
    """Answers requests."""

    def __init__(self) -> None:
        self._listener: Listener | None = None
        self._next: Language | None = None

    def answer(self, request: Request) -> Reply:
        """One reply for one request.

        Raises:
            RuntimeError: sound before SetUp.
        """
        if isinstance(request, SetUp):
            try:
                pair = load(request.engine, request.model)
                self._listener = Listener(*pair, request.language, request.robot_name)
            except EngineError as error:
                return Refused(str(error))
            self._next = None
            return Ready(self._listener.unheard)
        if self._listener is None:
            raise RuntimeError(f"{type(request).__name__} before SetUp")
        if isinstance(request, SetLanguage):
            self._next = request.language
            return Ready(self._refresh(self._listener))
        samples = np.frombuffer(request.samples, dtype=np.int16)
        events = tuple(self._listener.hear(samples, request.gated))
        self._refresh(self._listener)
        return Noticed(events, self._listener.idle)

    def _refresh(self, listener: Listener) -> tuple[str, ...]:
        if self._next is not None and listener.idle:
            listener.set_language(self._next)
            self._next = None
        return listener.unheard


def read_message(stream: BinaryIO) -> bytes:
    """Read one framed message; empty at the end of the stream."""
    header = stream.read(HEADER.size)
    if len(header) < HEADER.size:
        return b""
    return stream.read(HEADER.unpack(header)[0])


def framed(message: Request | Reply) -> bytes:
    """A message as bytes, its length first."""
    body = msgspec.msgpack.encode(message)
    return HEADER.pack(len(body)) + body


def main() -> int:
    """Serve until standard input ends. What a native library prints must not get between the replies."""
    replies = os.fdopen(os.dup(1), "wb", buffering=0)
    os.dup2(2, 1)
    requests = sys.stdin.buffer
    decoder = msgspec.msgpack.Decoder(Request)
    worker = Worker()
    while body := read_message(requests):
        replies.write(framed(worker.answer(decoder.decode(body))))
    return 0


if __name__ == "__main__":
    sys.exit(main())
