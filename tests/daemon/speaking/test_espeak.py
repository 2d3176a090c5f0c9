"""The program at arm's length, with stand-ins for it that are really started."""

from __future__ import annotations

import threading
import time

import pytest

from daemon.config import Speaking
from daemon.speaking import choice
from daemon.speaking.espeak import EspeakVoice
from daemon.speaking.silent import SilentVoice


def wait_for_end(voice: EspeakVoice, ended: threading.Event) -> None:
    assert ended.wait(5)
    for _ in range(500):
        if not voice.busy(0.0):
            return
        time.sleep(0.001)
    pytest.fail("still busy")


def test_it_is_busy_until_the_program_ends() -> None:
    ended = threading.Event()
    voice = EspeakVoice(program=("sh", "-c", "exit 0", "sh"), ended=ended.set)
    voice.start("hello", 0.0)
    wait_for_end(voice, ended)


def test_interrupt_ends_it_at_once() -> None:
    ended = threading.Event()
    voice = EspeakVoice(program=("sh", "-c", "exec sleep 60", "sh"), ended=ended.set)
    voice.start("a long story", 0.0)
    assert voice.busy(0.0)
    voice.interrupt()
    wait_for_end(voice, ended)


@pytest.mark.parametrize(
    ("program", "said"),
    [
        (("sh", "-c", "echo no sound card >&2; exit 1", "sh"), "no sound card"),
        (("no-such-program-here",), "no-such-program-here"),
    ],
)
def test_a_failure_is_told_once(program: tuple[str, ...], said: str) -> None:
    ended = threading.Event()
    voice = EspeakVoice(program=program, ended=ended.set)
    voice.start("hello", 0.0)
    assert ended.wait(5)
    with pytest.raises(OSError, match=said):
        voice.busy(0.0)
    wait_for_end(voice, ended)


def test_auto_is_silent_where_espeak_is_not_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    assert isinstance(choice.choose(Speaking()), SilentVoice)
    with pytest.raises(choice.NoVoiceError, match="apt install espeak-ng"):
        choice.choose(Speaking(voice="espeak"))
