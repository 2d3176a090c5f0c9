"""What the service manager is told, over a real datagram socket."""

from __future__ import annotations

import os
import socket
from collections.abc import Iterator
from pathlib import Path

import pytest

from daemon.notify import Notifier


@pytest.fixture
def manager(tmp_path: Path) -> Iterator[socket.socket]:
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as end:
        end.bind(str(tmp_path / "notify"))
        end.setblocking(False)
        yield end


def told(manager: socket.socket) -> list[str]:
    texts = []
    try:
        while True:
            texts.append(manager.recv(1000).decode())
    except BlockingIOError:
        return texts


def test_ready_and_stopping(manager: socket.socket) -> None:
    notifier = Notifier({"NOTIFY_SOCKET": manager.getsockname()})
    notifier.ready("listening")
    notifier.stopping()
    assert told(manager) == ["READY=1\nSTATUS=listening", "STOPPING=1"]


def test_the_watchdog_is_patted_when_due_and_only_when_the_loop_advances(
    manager: socket.socket,
) -> None:
    notifier = Notifier({"NOTIFY_SOCKET": manager.getsockname(), "WATCHDOG_USEC": "2000000"})
    for tick in range(100):
        notifier.advanced(tick / 30)
    assert told(manager) == ["WATCHDOG=1"] * 4  # at 0, 1, 2 and 3 s


@pytest.mark.parametrize(
    "environ",
    [
        {},
        {"NOTIFY_SOCKET": "/nowhere/at/all", "WATCHDOG_USEC": "1000"},
        {"NOTIFY_SOCKET": "", "WATCHDOG_USEC": "soon"},
    ],
)
def test_without_a_manager_it_says_nothing_and_does_not_mind(environ: dict[str, str]) -> None:
    notifier = Notifier(environ)
    notifier.ready("listening")
    notifier.advanced(0.0)
    notifier.stopping()


def test_a_watchdog_meant_for_another_process_is_not_ours() -> None:
    environ = {"NOTIFY_SOCKET": "/x", "WATCHDOG_USEC": "1000", "WATCHDOG_PID": str(os.getpid() + 1)}
    assert Notifier(environ).watchdog_s is None
