"""A running daemon and the commands for what it was taught: they go through it, for it has the store."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import pytest

SAYSO: Final = (sys.executable, "-m", "daemon.control.cli")


@pytest.fixture(scope="module")
def folder() -> Iterator[Path]:
    with tempfile.TemporaryDirectory(prefix="sayso-", ignore_cleanup_errors=True) as name:
        yield Path(name)


def environment(folder: Path) -> dict[str, str]:
    return {**os.environ, "SAYSO_STATE_DIR": str(folder), "PYTHONUNBUFFERED": "1"}


@pytest.fixture(scope="module", autouse=True)
def daemon(folder: Path) -> Iterator[None]:
    with subprocess.Popen(
        [*SAYSO, "run"],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        text=True,
        env=environment(folder),
    ) as process:
        assert process.stdout is not None
        assert process.stdout.readline().startswith("ready after")
        yield
        process.kill()


def sayso(folder: Path, *arguments: str, given: str = "") -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [*SAYSO, *arguments],
        input=given,
        capture_output=True,
        text=True,
        timeout=60,
        env=environment(folder),
        check=False,
    )


def test_teach_list_forget_and_look_back(folder: Path) -> None:
    assert sayso(folder, "lessons").stdout.startswith("nothing was taught")
    assert sayso(folder, "say", "hello").returncode == 0
    given = "you(Mary): never grab a cup\nto zorp, turn left\nthe block is red\n"
    with subprocess.Popen(
        [*SAYSO, "log", "-n", "1", "--follow", "--json"],
        stdout=subprocess.PIPE,
        text=True,
        env=environment(folder),
    ) as following:
        assert following.stdout is not None
        assert json.loads(following.stdout.readline())["text"] == "hello"
        result = sayso(folder, "teach", "-", given=given)
        assert (result.returncode, result.stdout) == (
            0,
            "2 new, 0 known already, 1 fact noted until the daemon ends\n",
        )
        followed = [json.loads(following.stdout.readline())]
        while followed[-1]["event"] != "acknowledged" or "block" not in followed[-1]["text"]:
            followed.append(json.loads(following.stdout.readline()))
        assert not [e for e in followed if e["event"] == "say_started"], "it is not read out"
        assert sum(e["event"] == "lesson" for e in followed) == 2
        following.send_signal(signal.SIGINT)
        assert following.wait(10) == 0
    answers = [json.loads(x) for x in sayso(folder, "lessons", "--json").stdout.splitlines()]
    assert [(a["text"], a["teacher"]) for a in answers] == [
        ("never grab a cup", "mary"),
        ("to zorp, turn left", "mary"),
    ]
    assert "to zorp, turn left" in sayso(folder, "export").stdout
    wrong = sayso(folder, "forget", "1", "9")
    assert (wrong.returncode, wrong.stderr) == (
        1,
        "sayso: there is no lesson 9; nothing was changed (`sayso lessons` lists them)\n",
    )
    result = sayso(folder, "forget", "1", "--speaker", "Rick")
    assert result.returncode == 0
    assert "forgotten   1: never grab a cup" in result.stdout
    assert "1: never grab a cup" in sayso(folder, "log", "-n", "1").stdout
    assert "taken back" in sayso(folder, "lessons", "--all", "cup").stdout
    piped = sayso(folder, "talk", given="zorp\n/lessons\n")
    assert piped.returncode == 0
    assert "doing       turn left" in piped.stdout
    assert "2  procedure  to zorp" in piped.stdout
