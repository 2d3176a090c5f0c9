"""The other end of the control socket: plain and blocking, for the command line."""

from __future__ import annotations

import socket
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

    def ask(self, request: messages.Request) -> Iterator[messages.AnyAnswer]:
        """Send a request; the answers up to and including the last.

        Raises:
            ControlError: refused, or the daemon went away.
        """
        self._socket.sendall(messages.line(request))
        for line in self._lines:
            answer = messages.read_answer(line)
            if isinstance(answer, messages.Wrong):
                raise ControlError(answer.error)
            yield answer
            if not isinstance(answer, messages.Happened):
                return
        raise ControlError("the daemon went away")

    def close(self) -> None:
        """Hang up."""
        self._lines.close()
        self._socket.close()
