"""`sayso talk`, on a real pseudo-terminal and from a pipe. What it waits for, it waits for no longer than it must."""

from __future__ import annotations

import fcntl
import os
import re
import select
import struct
import subprocess
import sys
import tempfile
import termios
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Final

import pytest
from click.testing import CliRunner

from daemon.control.cli import cli

SAYSO: Final = (sys.executable, "-m", "daemon.control.cli")
WHERE_IS_THE_CURSOR: Final = b"\x1b[6n"
PATIENCE_S: Final = 20.0


@pytest.fixture
def folder() -> Iterator[Path]:
    with tempfile.TemporaryDirectory(prefix="sayso-", ignore_cleanup_errors=True) as name:
        yield Path(name)


def environment(folder: Path) -> dict[str, str]:
    return {**os.environ, "SAYSO_STATE_DIR": str(folder), "TERM": "xterm", "PYTHONUNBUFFERED": "1"}


class Terminal:
    """A terminal of 30 lines with `sayso talk` in it."""

    def __init__(self, folder: Path, *arguments: str) -> None:
        self.screen, end = os.openpty()
        fcntl.ioctl(end, termios.TIOCSWINSZ, struct.pack("HHHH", 30, 120, 0, 0))
        self.process = subprocess.Popen(
            [*SAYSO, "talk", *arguments],
            stdin=end,
            stdout=end,
            stderr=end,
            env=environment(folder),
            start_new_session=True,
            # Its own terminal: while something is printed, Ctrl-C arrives as a signal.
            preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0),
        )
        os.close(end)
        self.shown = b""

    def type(self, keys: str) -> None:
        os.write(self.screen, keys.encode())

    def until(self, pattern: str) -> str:
        """Wait for it to be shown; all that was shown up to then, and is forgotten."""
        end_s = time.monotonic() + PATIENCE_S
        while (found := re.search(pattern.encode(), self.shown, re.DOTALL)) is None:
            assert time.monotonic() < end_s, f"no {pattern!r} in {self.shown[-2000:]!r}"
            self._read()
        before, self.shown = self.shown[: found.end()], self.shown[found.end() :]
        return before.decode(errors="replace")

    def ready(self, text: str) -> str:
        """Wait for it, and then until keys are taken again: while something is printed the line is not raw."""
        return self.until(f"{text}.*Ctrl-C stops")

    def type_until_offered(self, keys: str, word: str) -> None:
        """The words of a lesson are known to the completion a moment after it: type again until then."""
        end_s = time.monotonic() + PATIENCE_S
        while word.encode() not in self.shown:
            assert time.monotonic() < end_s, f"{word} is not offered: {self.shown[-2000:]!r}"
            self.type("\x15" + keys)  # ctrl-u clears the line
            self._read_for(0.5)
        self.shown = b""

    def ended(self) -> int:
        """Wait for its end; the exit status."""
        end_s = time.monotonic() + PATIENCE_S
        while self.process.poll() is None:
            assert time.monotonic() < end_s, f"still there: {self.shown[-2000:]!r}"
            self._read()
        return self.process.returncode

    def close(self) -> None:
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        os.close(self.screen)

    def _read_for(self, seconds: float) -> None:
        end_s = time.monotonic() + seconds
        while time.monotonic() < end_s:
            self._read()

    def _read(self) -> None:
        if select.select([self.screen], [], [], 0.1)[0]:
            with suppress(OSError):  # the other end is closed
                read = os.read(self.screen, 65536)
                for _ in range(read.count(WHERE_IS_THE_CURSOR)):
                    os.write(self.screen, b"\x1b[20;1R")
                self.shown += read


@contextmanager
def terminal(folder: Path, *arguments: str) -> Iterator[Terminal]:
    there = Terminal(folder, *arguments)
    try:
        yield there
    finally:
        there.close()


@contextmanager
def daemon(folder: Path) -> Iterator[subprocess.Popen[str]]:
    with subprocess.Popen(
        [*SAYSO, "run"],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        env=environment(folder),
    ) as process:
        try:
            assert process.stdout is not None
            assert process.stdout.readline().startswith("ready after")
            yield process
        finally:
            process.kill()


def test_a_conversation_with_a_robot_of_its_own(folder: Path) -> None:
    with terminal(folder, "--speaker", "Mary") as there:
        there.until("no daemon runs: this is a simulated robot")
        there.ready("link up .*speaker Mary")
        there.type("to zorp, turn left then drive forward 1 m\r")
        there.ready("said +Okay. To zorp, I will turn left")
        there.type_until_offered("zo", "zorp")
        there.type("\t")
        there.until("rp")
        there.type("\r")
        there.until("doing +turn left")
        there.until("doing +drive forward")
        there.type("\x03")
        there.until("drive forward 1 meter: stopped")
        assert re.search("heading (8[5-9]|9[0-5])°", there.ready("I have stopped"))
        there.type("/lessons\r")
        there.ready("1  procedure  to zorp")
        there.type("/speaker Rick\r")
        there.ready("speaker Rick")
        there.type("/forget 1\r")
        there.ready("forgotten +1: to zorp")
        there.type("/dance\r")
        there.ready("no such command")
        there.type("/help\r")
        there.ready("emergency stop")
        began_s = time.monotonic()
        there.type("\x04")
        assert there.ended() == 0
        assert time.monotonic() - began_s < 5
    assert "+to zorp, turn left" in (folder / "talk_history").read_text()
    assert not (folder / "control.sock").exists()


def test_a_conversation_with_a_running_daemon(folder: Path) -> None:
    with daemon(folder) as process:
        with terminal(folder) as there:
            there.ready("link up")
            there.type("to zorp, turn left\r")
            there.ready("said +Okay")
            there.type("\x04")
            assert there.ended() == 0
        assert process.poll() is None, "the daemon goes on"
        with terminal(folder) as there:
            there.ready("link up")
            there.type("zorp\r")
            there.until("doing +turn left")
            process.terminate()
            there.until("the daemon ended")
            assert there.ended() == 1


def test_sigterm_stops_the_robot_and_leaves(folder: Path) -> None:
    with terminal(folder) as there:
        there.ready("link up")
        there.type("drive forward 1 m\r")
        there.until("doing +drive forward")
        there.process.terminate()
        assert there.ended() == 0
    assert not (folder / "control.sock").exists()


@pytest.mark.parametrize(
    ("lines", "status", "shown"),
    [
        ("drive forward\n", 0, "done        drive forward: succeeded"),
        ("drive forward\nthe if of\n", 3, "unclear"),
        ("the if of\ndrive forward\n\n", 0, "unclear"),
        ("grab the block\n", 1, "failed"),
        ("to zorp, turn left\n/lessons\n", 0, "1  procedure  to zorp, turn left"),
        ("to zorp, turn left\n/forget 1\n", 0, "forgotten   1"),
        ("/forget 1\n", 1, ""),
        ("/dance\n", 2, ""),
        ("/quit\nthe if of\n", 0, ""),
        ("", 0, ""),
    ],
)
def test_from_a_pipe(
    folder: Path, monkeypatch: pytest.MonkeyPatch, lines: str, status: int, shown: str
) -> None:
    monkeypatch.setenv("SAYSO_STATE_DIR", str(folder))
    result = CliRunner().invoke(cli, ["talk"], input=lines)
    assert result.exit_code == status, result.output
    assert shown in result.stdout


def test_the_speaker_of_a_pipe(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SAYSO_STATE_DIR", str(folder))
    lines = "never grab a cup\n/speaker Rick\nnever grab a ball\n/lessons\n"
    result = CliRunner().invoke(cli, ["talk", "--speaker", "Mary"], input=lines)
    cup, ball = result.stdout.splitlines()[-2:]
    assert " Mary " in cup
    assert " Rick " in ball
