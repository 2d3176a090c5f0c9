"""Word to systemd, where it is there (sd_notify(3)): a datagram of one line."""

from __future__ import annotations

import os
import socket
from collections.abc import Mapping
from contextlib import suppress


class Notifier:
    """Tells the service manager; without NOTIFY_SOCKET it does nothing.

    Attributes:
        watchdog_s: how often a sign of life is due at least, half of what systemd waits; None where none is wanted.
    """

    def __init__(self, environ: Mapping[str, str] = os.environ) -> None:
        self._address = environ.get("NOTIFY_SOCKET", "")
        wait_us = environ.get("WATCHDOG_USEC", "")
        for_us = environ.get("WATCHDOG_PID", str(os.getpid())) == str(os.getpid())
        self.watchdog_s = int(wait_us) / 2e6 if wait_us.isdigit() and for_us else None
        self._patted_s = float("-inf")

    def ready(self, status: str) -> None:
        """Able to listen."""
        self._tell(f"READY=1\nSTATUS={status}")

    def stopping(self) -> None:
        """On the way out."""
        self._tell("STOPPING=1")

    def advanced(self, now_s: float) -> None:
        """The control loop made a step that worked; passed on when it is due."""
        if self.watchdog_s is not None and now_s - self._patted_s >= self.watchdog_s:
            self._patted_s = now_s
            self._tell("WATCHDOG=1")

    def _tell(self, text: str) -> None:
        if not self._address:
            return
        address = "\0" + self._address[1:] if self._address.startswith("@") else self._address
        # A manager that went away is no reason to stop driving well.
        with suppress(OSError), socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as out:
            out.setblocking(False)
            out.sendto(text.encode(), address)
