"""The ear in real time."""

from __future__ import annotations

import asyncio
from pathlib import Path

import numpy as np
import pytest

from daemon.hearing import recording
from daemon.hearing.choice import Engine, choose_engine
from daemon.hearing.ear import MOST_BLOCKS, Ear, play
from daemon.hearing.events import Heard, HearingEvent, NotHeard, Partial
from daemon.hearing.recogniser import RATE_HZ, UnknownEngineError
from grammars.language import language

SPEECH = Path(__file__).parents[2] / "audio" / "hearing" / "flite-slt"
LANGUAGE = language()


async def next_event(ear: Ear) -> HearingEvent:
    async with asyncio.timeout(20):
        while isinstance(event := await ear.events.get(), Partial):
            pass
        return event


async def test_it_hears_a_recording_played_to_it() -> None:
    ear = Ear(Engine("vosk"), LANGUAGE, lambda text: LANGUAGE.reads(text))
    async with asyncio.TaskGroup() as group:
        serving = group.create_task(ear.serve())
        await ear.ready.wait()
        await play(recording.read(SPEECH / "please-dance.wav"), ear)
        heard = await next_event(ear)
        assert isinstance(heard, Heard)
        assert heard.text == "please dance"
        serving.cancel()


async def test_a_dead_recogniser_is_reported_and_started_again() -> None:
    ear = Ear(Engine("vosk"), LANGUAGE, lambda text: LANGUAGE.reads(text))
    async with asyncio.TaskGroup() as group:
        serving = group.create_task(ear.serve())
        await ear.ready.wait()
        assert ear.pid is not None
        await play(recording.read(SPEECH / "drive-forward.wav")[:12_000], ear)
        ear.kill()
        ear.hear(recording.read(SPEECH / "drive-forward.wav")[:1_600])
        lost = await next_event(ear)
        assert isinstance(lost, NotHeard)
        assert lost.reason == "lost"
        await ear.ready.wait()
        # on a busy machine some of what was said before still waits to be heard
        silence = np.zeros(2 * RATE_HZ, np.int16)
        please_dance = recording.read(SPEECH / "please-dance.wav")
        await play(np.concatenate([silence, please_dance, silence]), ear)
        while isinstance(event := await next_event(ear), NotHeard):
            pass
        assert isinstance(event, Heard)
        serving.cancel()


async def test_sound_nobody_takes_does_not_pile_up() -> None:
    ear = Ear(Engine("vosk"), LANGUAGE, bool)
    block = recording.read(SPEECH / "stop.wav")[:1_600]
    for _ in range(MOST_BLOCKS + 3):
        ear.hear(block)
    assert ear.dropped == 3


def test_auto_is_an_installed_official_model_or_the_better_engine(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("SAYSO_VOSK_MODEL", raising=False)
    assert choose_engine("auto", "", (tmp_path,)).model == ""
    official = tmp_path / "vosk-model-small-en-us-0.15"
    official.mkdir()
    assert choose_engine("auto", "", (tmp_path,)) == Engine("vosk", str(official))
    monkeypatch.setenv("SAYSO_VOSK_MODEL", "/elsewhere")
    assert choose_engine("auto", "", (tmp_path,)) == Engine("vosk", "/elsewhere")
    assert choose_engine("pocketsphinx", "", ()) == Engine("pocketsphinx")
    with pytest.raises(UnknownEngineError, match="pocketsphinx, vosk"):
        choose_engine("whisper", "", ())
