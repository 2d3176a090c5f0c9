"""The other end of the control socket: plain and blocking, for the command line."""

from __future__ import annotations

import socket
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from daemon.closing import Closing
from daemon.control import messages

ANSWER_S: Final = 90.0  # longer than the daemon waits for an utterance to settle


class ControlError(Exception):
    """The daemon did not do it; the message says why."""


class Client(Closing):
    """One connection to a running daemon. answer_s: how long an answer may take; None: for ever.

    Raises:
        FileNotFoundError, ConnectionRefusedError: none runs.
        OSError: it cannot be reached.
    """

    def __init__(self, path: Path, answer_s: float | None = ANSWER_S) -> None:
        self._socket = socket.socket(socket.AF_UNIX)
        self._socket.settimeout(answer_s)
        try:
            self._socket.connect(str(path))
        except OSError:
            self._socket.close()
            raise
        self._lines = self._socket.makefile("rb")
        self._allowance = (
            messages.BURST - 1.0
        )  # the daemon's own count is never lower than this one
        self._counted_s = time.monotonic()

    def ask(self, request: messages.Request) -> Iterator[messages.AnyAnswer]:
        """Send a request, not faster than the daemon takes them; the answers up to and including the last.

        Raises:
            ControlError: refused, or the daemon went away.
        """
        if not isinstance(request, messages.Stop):  # never refused
            self._pace()
        try:
            self._socket.sendall(messages.line(request))
        except ConnectionError as error:  # click would end without a word on a broken pipe
            raise ControlError("the daemon went away") from error
        for line in self._lines:
            answer = messages.read_answer(line)
            if isinstance(answer, messages.Wrong):
                raise ControlError(answer.error)
            yield answer
            if not isinstance(answer, messages.Happened):
                return
        raise ControlError("the daemon went away")

    def _pace(self) -> None:
        now_s = time.monotonic()
        gained = (now_s - self._counted_s) * messages.REQUESTS_A_SECOND
        self._allowance = min(self._allowance + gained, messages.BURST - 1.0)
        self._counted_s = now_s
        if self._allowance < 1:
            time.sleep((1 - self._allowance) / messages.REQUESTS_A_SECOND)
        self._allowance -= 1

    def close(self) -> None:
        """Hang up."""
        self._lines.close()
        self._socket.close()
