"""Real engines on real speech, through the recogniser's process, in virtual time."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from daemon.hearing import recording
from daemon.hearing.choice import Engine
from daemon.hearing.events import Heard, HearingEvent, NotHeard, Partial, StopWord
from daemon.hearing.recogniser import RATE_HZ, EngineError, Samples
from daemon.hearing.transcribe import Transcriber, transcribe
from grammars.language import language

SPEECH = Path(__file__).parents[2] / "audio" / "hearing" / "flite-slt"
LANGUAGE = language()


def parses(text: str) -> bool:
    return LANGUAGE.reads(text)


@pytest.fixture(scope="module", params=["vosk", "pocketsphinx"])
def either(request: pytest.FixtureRequest) -> Iterator[Transcriber]:
    with Transcriber(Engine(request.param), LANGUAGE) as transcriber:
        yield transcriber


@pytest.fixture(scope="module")
def vosk() -> Iterator[Transcriber]:
    with Transcriber(Engine("vosk"), LANGUAGE) as transcriber:
        yield transcriber


def spoken(name: str) -> Samples:
    return recording.read(SPEECH / f"{name}.wav")


def said(transcriber: Transcriber, samples: Samples) -> list[HearingEvent]:
    events = transcriber.transcribe(samples, parses)
    return [event for event in events if not isinstance(event, Partial)]


def test_a_command_is_heard_soon_after_it_ends(either: Transcriber) -> None:
    (heard,) = said(either, spoken("please-dance"))
    assert isinstance(heard, Heard)
    assert heard.text == "please dance"
    assert heard.decided_s - heard.ended_s < 0.4


def test_a_pause_between_commands_parts_them(either: Transcriber) -> None:
    texts = [
        event.text for event in said(either, spoken("two-commands")) if isinstance(event, Heard)
    ]
    assert texts == ["drive forward", "turn left"]


def test_stop_is_found_before_its_utterance_has_ended(either: Transcriber) -> None:
    samples = spoken("stop")
    stop, heard = said(either, samples)
    assert isinstance(stop, StopWord)
    assert (
        stop.at_s < len(samples) / 16_000 - 0.5 + 0.2
    )  # the file ends with half a second of silence
    assert isinstance(heard, Heard)
    assert stop.at_s < heard.decided_s


def test_silence_and_hum_are_nothing(either: Transcriber) -> None:
    assert said(either, np.zeros(16_000, np.int16)) == []
    hum = np.random.default_rng(1).normal(0.0, 60.0, 32_000).astype(np.int16)
    assert not any(isinstance(event, Heard | StopWord) for event in said(either, hum))


@pytest.mark.parametrize("pause", ["0.4", "0.8", "1.2"])
def test_a_lesson_with_pauses_is_one_lesson(vosk: Transcriber, pause: str) -> None:
    (heard,) = said(vosk, spoken(f"cha-cha-{pause}"))
    assert isinstance(heard, Heard)
    assert heard.text == "to cha-cha drive forward then drive backwards"


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("yellow-mug", "where did you put the yellow mug"),
        ("red-block-heavy", "who said that the red block is heavy"),
    ],
)
def test_what_is_not_listened_for_is_heard_if_it_is_a_sentence(
    vosk: Transcriber, name: str, text: str
) -> None:
    assert not LANGUAGE.lists(text)
    (heard,) = said(vosk, spoken(name))
    assert isinstance(heard, Heard)
    assert heard.text == text
    assert heard.decided_s - heard.ended_s < 0.4


def test_neither_is_a_lesson_that_is_not_listened_for_taken_apart(vosk: Transcriber) -> None:
    (heard,) = said(vosk, spoken("in-case-0.8"))
    assert isinstance(heard, Heard)
    assert heard.text == "in case you see a person drive forward"
    assert all(isinstance(event, NotHeard) for event in said(vosk, spoken("in-case-late")))


def test_what_follows_an_unfinished_lesson_is_never_heard_alone(vosk: Transcriber) -> None:
    (heard,) = said(vosk, spoken("cha-cha-late"))
    assert isinstance(heard, Heard)
    assert heard.text == "to cha-cha drive forward"


def test_stop_in_a_halting_lesson_stops(either: Transcriber) -> None:
    assert any(isinstance(event, StopWord) for event in said(either, spoken("to-stop-hesitating")))


def test_the_name_may_stand_before_stop(either: Transcriber) -> None:
    assert any(isinstance(event, StopWord) for event in said(either, spoken("robot-stop")))


def test_chatter_is_outside_the_language(either: Transcriber) -> None:
    pause = np.zeros(
        3 * RATE_HZ, np.int16
    )  # what follows an unclear lesson at once is the rest of it
    (event,) = said(either, np.concatenate([pause, spoken("chatter")]))
    assert isinstance(event, NotHeard)
    assert event.reason == "outside"


def test_while_the_robot_speaks_only_stop_is_heard(vosk: Transcriber) -> None:
    assert not list(vosk.transcribe(spoken("please-dance"), parses, gated=True))
    (event,) = vosk.transcribe(spoken("stop"), parses, gated=True)
    assert isinstance(event, StopWord)


def test_a_language_is_taken_between_utterances(vosk: Transcriber) -> None:
    vosk.set_language(language())
    assert isinstance(said(vosk, spoken("please-dance"))[0], Heard)


def test_a_recogniser_killed_in_the_middle_is_reported_and_comes_back() -> None:
    with Transcriber(Engine("vosk"), LANGUAGE) as transcriber:
        process = transcriber.start()
        events = transcriber.transcribe(spoken("cha-cha-0.4"), parses)
        first = next(events)
        assert isinstance(first, Partial)
        os.kill(process.pid, signal.SIGKILL)
        rest = list(events)
        assert isinstance(rest[-1], NotHeard)
        assert rest[-1].reason == "lost"
        (heard,) = said(transcriber, spoken("drive-forward"))
        assert isinstance(heard, Heard)
        assert heard.text == "drive forward"


@pytest.mark.parametrize(
    ("make", "reason"),
    [
        (lambda folder: folder / "none", "no such folder"),
        (lambda folder: folder, "no Vosk model"),
    ],
)
def test_a_model_that_cannot_be_used_is_refused(tmp_path: Path, make: object, reason: str) -> None:
    assert callable(make)
    with pytest.raises(EngineError, match=reason):
        transcribe(SPEECH / "stop.wav", Engine("vosk", str(make(tmp_path))), LANGUAGE, parses)


def test_a_model_with_a_fixed_graph_is_refused(tmp_path: Path) -> None:
    (tmp_path / "am").mkdir()
    (tmp_path / "am" / "final.mdl").touch()
    with pytest.raises(EngineError, match="takes no grammars"):
        transcribe(SPEECH / "stop.wav", Engine("vosk", str(tmp_path)), LANGUAGE, parses)
