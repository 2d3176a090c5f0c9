"""The same sound is heard the same, whatever came before it and wherever its blocks are cut."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from daemon.hearing import recording
from daemon.hearing.events import CoreEvent, Ended
from daemon.hearing.listener import Listener
from daemon.hearing.recogniser import RATE_HZ, Samples, load
from grammars.language import language

SPEECH = Path(__file__).parents[2] / "audio" / "hearing" / "flite-slt"
LANGUAGE = language()
OTHERS = ("to-stop-hesitating", "chatter")


@pytest.fixture(scope="module")
def used() -> Listener:
    return Listener(*load("vosk"), LANGUAGE)


@pytest.fixture(scope="module")
def fresh(used: Listener) -> tuple[tuple[str, float], ...]:
    (ended,) = heard(used, spoken("drive-forward"))
    return ended.alternatives


def spoken(name: str) -> Samples:
    return recording.read(SPEECH / f"{name}.wav")


def silence(length_s: float) -> Samples:
    return np.zeros(round(length_s * RATE_HZ), np.int16)


def heard(listener: Listener, *sounds: Samples, block: int = 1_600) -> list[Ended]:
    def events() -> Iterator[CoreEvent]:
        everything = np.concatenate([*sounds, silence(4.0)])
        for start in range(0, len(everything), block):
            yield from listener.hear(everything[start : start + block])

    return [event for event in events() if isinstance(event, Ended)]


@pytest.mark.parametrize("offset", [1, 111, 1_599])
def test_where_it_begins_changes_nothing(
    used: Listener, fresh: tuple[tuple[str, float], ...], offset: int
) -> None:
    (ended,) = heard(used, np.zeros(offset, np.int16), spoken("drive-forward"))
    assert ended.alternatives == fresh


@pytest.mark.parametrize("block", [160, 1_111])
def test_how_it_is_cut_changes_nothing(
    used: Listener, fresh: tuple[tuple[str, float], ...], block: int
) -> None:
    (ended,) = heard(used, spoken("drive-forward"), block=block)
    assert ended.alternatives == fresh


@pytest.mark.parametrize("before", OTHERS)
def test_what_was_said_before_changes_nothing(
    used: Listener, fresh: tuple[tuple[str, float], ...], before: str
) -> None:
    *_, ended = heard(used, spoken(before), silence(4.0), spoken("drive-forward"))
    assert ended.alternatives == fresh


def test_its_times_count_from_the_first_sample(used: Listener) -> None:
    began_s = used.now_s
    (ended,) = heard(used, silence(1.0), spoken("drive-forward"))
    length_s = len(spoken("drive-forward")) / RATE_HZ
    assert began_s + 1.0 < ended.began_s < began_s + 1.35
    assert began_s + 1.0 + length_s - 0.6 < ended.ended_s < began_s + 1.0 + length_s - 0.4


def test_what_follows_a_lesson_that_was_not_understood_is_no_command() -> None:
    """It may be the rest of it: "to dance cha-cha then (unclear)", a pause, "shimmy"."""
    said = (*LANGUAGE.typical, *LANGUAGE.likely)
    likely = tuple(text for text in said if not {"drive", "driving"} & set(text.split()))
    listener = Listener(*load("vosk"), replace(LANGUAGE, typical=(), likely=likely))
    lesson = (spoken("cha-cha-0.4"), silence(1.2), spoken("please-dance"))
    (unclear,) = heard(listener, *lesson)
    assert unclear.alternatives[0][0].startswith("to cha-cha")
    (command,) = heard(listener, silence(1.0), spoken("please-dance"))
    assert command.alternatives[0][0] == "please dance"
