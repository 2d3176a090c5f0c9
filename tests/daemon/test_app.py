"""The daemon as a user starts it: real processes, a real PTY, real signals."""

from __future__ import annotations

import json
import os
import selectors
import signal
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from daemon import app
from daemon.control.client import Client
from daemon.control.messages import Done, Happened, Say, Status, Stop, Told

SAYSO = (sys.executable, "-m", "daemon.control.cli")


@pytest.fixture
def folder() -> Iterator[Path]:
    """Short: a socket's path has at most 107 bytes."""
    with tempfile.TemporaryDirectory(prefix="sayso-", ignore_cleanup_errors=True) as name:
        yield Path(name)


def environment(folder: Path, **more: str) -> dict[str, str]:
    return {**os.environ, "SAYSO_STATE_DIR": str(folder), "PYTHONUNBUFFERED": "1", **more}


def sayso(folder: Path, *arguments: str, **more: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [*SAYSO, *arguments],
        capture_output=True,
        text=True,
        timeout=30,
        env=environment(folder, **more),
        check=False,
    )


@contextmanager
def daemon(folder: Path, *arguments: str, **more: str) -> Iterator[subprocess.Popen[str]]:
    """A running daemon that has said that it is ready."""
    with subprocess.Popen(
        [*SAYSO, "run", *arguments],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=environment(folder, **more),
    ) as process:
        try:
            assert process.stdout is not None
            with selectors.DefaultSelector() as selector:
                selector.register(process.stdout, selectors.EVENT_READ)
                assert selector.select(20), "not ready in 20 s"
            line = process.stdout.readline()
            assert line.startswith("ready after"), line + (
                process.stderr.read() if process.stderr else ""
            )
            yield process
        finally:
            process.kill()


def ask(folder: Path, request: Say | Status | Stop) -> list[Happened | Done | Told]:
    with Client(folder / "control.sock", answer_s=20) as client:
        return list(client.ask(request))  # type: ignore[arg-type]


def connected(folder: Path) -> None:
    """Wait for the link: a robot that is not there yet is a normal state."""
    deadline_s = time.monotonic() + 10
    while time.monotonic() < deadline_s:
        (told,) = ask(folder, Status(v=1))
        assert isinstance(told, Told)
        if told.facts["link"] == "up":
            return
        time.sleep(0.02)
    pytest.fail("no link")


def test_from_a_typed_command_to_motion_and_out_on_sigterm(folder: Path) -> None:
    with daemon(folder) as process:
        connected(folder)
        answers = ask(folder, Say(v=1, text="drive forward", speaker="Mary"))
        happened = [answer.event for answer in answers if isinstance(answer, Happened)]
        assert answers[-1] == Done(outcome="done")
        poses = [event for event in happened if event["event"] == "pose"]
        assert poses[-1]["x_cm"] == pytest.approx(20, abs=3)
        process.send_signal(signal.SIGTERM)
        began_s = time.monotonic()
        assert process.wait(5) == 0
        assert time.monotonic() - began_s < 1.0
        assert not (folder / "control.sock").exists()


def test_sigint_in_the_middle_of_a_drive_stops_the_robot(folder: Path) -> None:
    with daemon(folder) as process:
        connected(folder)
        with Client(folder / "control.sock", answer_s=5) as client:
            for answer in client.ask(Say(v=1, text="drive forward one meter")):
                if isinstance(answer, Happened) and answer.event["event"] == "action_started":
                    break
        process.send_signal(signal.SIGINT)
        began_s = time.monotonic()
        assert process.wait(5) == 0
        assert time.monotonic() - began_s < 1.0
        assert process.stderr is not None
        assert "'source': 'closing'" in process.stderr.read()


def test_an_answer_comes_although_something_endless_goes_on(folder: Path) -> None:
    with daemon(folder):
        connected(folder)
        with Client(folder / "control.sock", answer_s=20) as client:
            for answer in client.ask(Say(v=1, text="keep turning left")):
                if isinstance(answer, Happened) and answer.event["event"] == "action_started":
                    break
            assert ask(folder, Say(v=1, text="say hi"))[-1] == Done(outcome="done")
        ask(folder, Stop(v=1))


def test_sigterm_before_it_is_ready(folder: Path) -> None:
    with subprocess.Popen([*SAYSO, "run"], env=environment(folder)) as process:
        while not (folder / "control.sock").exists():
            assert process.poll() is None
            time.sleep(0.005)
        process.send_signal(signal.SIGTERM)
        began_s = time.monotonic()
        assert process.wait(5) == 0
        assert time.monotonic() - began_s < 1.0


def test_it_hears_the_sound_file_it_is_given(folder: Path) -> None:
    audio = Path(app.__file__).parent / "demo" / "audio" / "01-drive-forward.wav"
    with daemon(folder, "--hearing", str(audio)):
        deadline_s = time.monotonic() + 30
        while time.monotonic() < deadline_s:
            (told,) = ask(folder, Status(v=1))
            assert isinstance(told, Told)
            if told.facts["pose"]["x_cm"] == pytest.approx(20, abs=3):
                break
            time.sleep(0.05)
        else:
            pytest.fail("it did not drive")


def test_it_takes_the_lines_that_are_typed(folder: Path) -> None:
    run = subprocess.Popen(
        [*SAYSO, "run"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env=environment(folder),
    )
    with run as process:
        assert process.stdin is not None
        assert process.stdout is not None
        assert process.stdout.readline().startswith("ready after")
        connected(folder)
        process.stdin.write("to hop drive forward\n\n\x00zork\n")
        process.stdin.flush()
        deadline_s = time.monotonic() + 10
        while time.monotonic() < deadline_s:
            (told,) = ask(folder, Status(v=1))
            assert isinstance(told, Told)
            if told.facts["lessons"] == 1:
                break
            time.sleep(0.05)
        else:
            pytest.fail("nothing learned")
        process.stdin.close()
        (told,) = ask(folder, Status(v=1))
        process.send_signal(signal.SIGTERM)
        assert process.wait(5) == 0


def test_stop_from_the_command_line(folder: Path) -> None:
    with daemon(folder):
        connected(folder)
        with Client(folder / "control.sock", answer_s=10) as client:
            outcome = None
            for answer in client.ask(Say(v=1, text="drive forward one meter")):
                if isinstance(answer, Happened) and answer.event["event"] == "action_started":
                    stopped = sayso(folder, "stop")
                    assert (stopped.returncode, stopped.stdout) == (0, "stopped (stop 1)\n")
                if isinstance(answer, Done):
                    outcome = answer.outcome
        assert outcome == "failed"


def test_lessons_survive_kill_9(folder: Path) -> None:
    with daemon(folder) as process:
        taught = sayso(folder, "say", "to bow lower the lift then raise the lift")
        assert taught.returncode == 0, taught.stderr
        process.send_signal(signal.SIGKILL)
        process.wait(5)
    with daemon(folder):
        connected(folder)
        bowed = sayso(folder, "say", "bow")
        assert bowed.returncode == 0
        assert bowed.stdout.count("succeeded") == 2


def test_a_second_daemon_on_the_same_store_is_refused(folder: Path) -> None:
    with daemon(folder):
        second = sayso(folder, "run")
        assert second.returncode == 1
        assert "in use by another sayso" in second.stderr
        assert "Traceback" not in second.stderr
        assert sayso(folder, "status").returncode == 0


def test_daemons_with_stores_of_their_own_do_not_meet(folder: Path) -> None:
    with daemon(folder / "a"), daemon(folder / "b"):
        assert sayso(folder / "a", "say", "to hop drive forward").returncode == 0
        assert json.loads(sayso(folder / "a", "status", "--json").stdout)["lessons"] == 1
        assert json.loads(sayso(folder / "b", "status", "--json").stdout)["lessons"] == 0


def test_a_robot_that_is_not_there_is_a_normal_state_and_commands_fail_aloud(folder: Path) -> None:
    with daemon(folder, "--robot", "serial:/dev/no-such-port"):
        said = sayso(folder, "say", "drive forward")
        assert said.returncode == 1
        assert "drive forward: failed" in said.stdout
        assert "no-such-port" in sayso(folder, "status").stdout


def test_systemd_is_told(folder: Path) -> None:
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as manager:
        manager.bind(str(folder / "notify"))
        manager.settimeout(10)
        more = {"NOTIFY_SOCKET": str(folder / "notify"), "WATCHDOG_USEC": "200000"}
        with daemon(folder, **more) as process:
            told = [manager.recv(1000).decode().partition("\n")[0]]
            while not {"READY=1", "WATCHDOG=1"} <= set(told):
                told.append(manager.recv(1000).decode().partition("\n")[0])
            process.send_signal(signal.SIGTERM)
            process.wait(5)
            manager.setblocking(False)
            while told[-1] != "STOPPING=1":
                told.append(manager.recv(1000).decode().partition("\n")[0])
        assert set(told) == {"READY=1", "WATCHDOG=1", "STOPPING=1"}


@pytest.mark.parametrize(
    ("toml", "said"),
    [
        ("[mind]\ntick = 3\n", "mind.tick: unknown key; known here are tick_hz"),
        ("[robot]\nuri = 'teleport:moon'\n", "robot.uri"),
        ("[robot]\nscene = '/no/such/scene.toml'\n", "robot.scene"),
        ("[robot\n", "not TOML"),
    ],
)
def test_a_bad_configuration_ends_with_78_and_one_line(folder: Path, toml: str, said: str) -> None:
    (folder / "bad.toml").write_text(toml)
    run = sayso(folder, "run", "--config", str(folder / "bad.toml"))
    assert run.returncode == 78
    assert said in run.stderr
    assert len(run.stderr.splitlines()) == 1


def test_a_damaged_store_is_refused_and_kept(folder: Path) -> None:
    (folder / "lessons.sqlite").write_bytes(b"not a database at all")
    run = sayso(folder, "run")
    assert run.returncode == 1
    assert "damaged" in run.stderr
    assert (folder / "lessons.sqlite").read_bytes() == b"not a database at all"
