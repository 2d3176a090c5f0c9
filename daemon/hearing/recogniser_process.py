"""The recogniser's process seen from outside, without an event loop: for recordings in virtual time."""

from __future__ import annotations

import selectors
import subprocess
import sys
from typing import BinaryIO

import msgspec

from daemon.closing import Closing
from daemon.hearing.recogniser import EngineError
from daemon.hearing.worker import HEADER, Refused, Reply, Request, framed

COMMAND = (sys.executable, "-m", "daemon.hearing.worker")
PATIENCE_S = 30.0
"""A reply takes milliseconds, loading a big model seconds. After this the process counts as hung and is killed."""


class RecogniserLostError(Exception):
    """The recogniser's process died or hung."""


class RecogniserProcess(Closing):
    """One process, from start to close. Starting another after a loss is the caller's business."""

    def __init__(self) -> None:
        self._process = subprocess.Popen(
            COMMAND, stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0
        )
        self._decoder: msgspec.msgpack.Decoder[Reply] = msgspec.msgpack.Decoder(Reply)
        self._waiting = selectors.DefaultSelector()
        self._waiting.register(self._out, selectors.EVENT_READ)

    @property
    def pid(self) -> int:
        """Its process id."""
        return self._process.pid

    def ask(self, request: Request) -> Reply:
        """Send a request and wait for its reply.

        Raises:
            EngineError: the engine refuses the request; says why.
            RecogniserLostError: the process died, or gave no reply in time.
        """
        try:
            self._in.write(framed(request))
            (length,) = HEADER.unpack(self._read(HEADER.size))
            reply = self._decoder.decode(self._read(length))
        except (OSError, msgspec.DecodeError) as error:
            raise RecogniserLostError(str(error)) from error
        if isinstance(reply, Refused):
            raise EngineError(reply.message)
        return reply

    def _read(self, length: int) -> bytes:
        got = b""
        while len(got) < length:
            if not self._waiting.select(PATIENCE_S):
                self._process.kill()
                raise RecogniserLostError(f"no reply within {PATIENCE_S:.0f} s")
            more = self._out.read(length - len(got))
            if not more:
                raise RecogniserLostError("the recogniser's process has died")
            got += more
        return got

    def close(self) -> None:
        """End the process."""
        self._waiting.close()
        self._in.close()
        try:
            self._process.wait(2.0)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._out.close()

    @property
    def _in(self) -> BinaryIO:
        assert self._process.stdin is not None
        return self._process.stdin  # type: ignore[return-value]

    @property
    def _out(self) -> BinaryIO:
        assert self._process.stdout is not None
        return self._process.stdout  # type: ignore[return-value]
