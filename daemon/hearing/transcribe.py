"""Recordings heard in virtual time: as fast as the recogniser can, with the times the sound itself has."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from daemon.closing import Closing
from daemon.hearing import recording
from daemon.hearing.choice import Engine
from daemon.hearing.events import Ended, HearingEvent, NotHeard
from daemon.hearing.recogniser import RATE_HZ, Samples
from daemon.hearing.recogniser_process import RecogniserLostError, RecogniserProcess
from daemon.hearing.trust import Parses, choose
from daemon.hearing.worker import Noticed, SetLanguage, SetUp, Sound
from grammars.language import Language

SILENCE_S = 5.0
"""Silence after a recording: enough for the longest wait to be over."""


class Transcriber(Closing):
    """A recogniser kept for several recordings. If its process dies, the recording is reported lost and the next one
    gets a new process.

    Args:
        engine: which engine, with which model.
        language: what may be said.
        robot_name: may stand before or after a stop word.
    """

    def __init__(self, engine: Engine, language: Language, robot_name: str = "robot") -> None:
        self._engine, self._language, self._name = engine, language, robot_name
        self._process: RecogniserProcess | None = None
        self._heard_s = 0.0

    def start(self) -> RecogniserProcess:
        """The process, loaded and listening; started if there is none.

        Raises:
            EngineError: the engine cannot be used; says why.
            RecogniserLostError: it died while loading.
        """
        if self._process is None:
            process = RecogniserProcess()
            try:
                process.ask(
                    SetUp(self._engine.name, self._engine.model, self._name, self._language)
                )
            except BaseException:
                process.close()
                raise
            self._process, self._heard_s = process, 0.0
        return self._process

    def set_language(self, language: Language) -> None:
        """Take a new language for the recordings to come."""
        self._language = language
        if self._process is not None:
            try:
                self._process.ask(SetLanguage(language))
            except RecogniserLostError:
                self.close()  # the next recording starts another, with this language

    def transcribe(
        self, recorded: Path | Samples, parses: Parses, gated: bool = False
    ) -> Iterator[HearingEvent]:
        """Hear a recording; times count from its beginning.

        Raises:
            RecordingError: the file cannot be heard.
            EngineError: see start.
        """
        samples = recording.read(recorded) if isinstance(recorded, Path) else recorded
        process = self.start()
        began_s = self._heard_s
        silence = np.zeros(round(SILENCE_S * RATE_HZ), np.int16)
        idle = True
        for place, block in enumerate(recording.blocks(np.concatenate([samples, silence]))):
            if idle and place * recording.BLOCK_S > len(samples) / RATE_HZ + 1.0:
                break
            try:
                reply = process.ask(Sound(block.tobytes(), gated))
            except RecogniserLostError:
                self.close()
                length_s = len(samples) / RATE_HZ
                yield NotHeard(0.0, length_s, length_s, "lost")
                return
            self._heard_s += len(block) / RATE_HZ
            if isinstance(reply, Noticed):
                idle = reply.idle
                for event in reply.events:
                    shifted = event.shifted(-began_s)
                    if isinstance(shifted, Ended):
                        yield choose(shifted, parses, self._engine.thresholds)
                    else:
                        yield shifted

    def close(self) -> None:
        """End the process."""
        if self._process is not None:
            self._process.close()
            self._process = None


def transcribe(
    recorded: Path | Samples, engine: Engine, language: Language, parses: Parses
) -> list[HearingEvent]:
    """Hear one recording with a recogniser of its own.

    Raises:
        RecordingError: the file cannot be heard.
        EngineError: the engine cannot be used; says why.
    """
    with Transcriber(engine, language) as transcriber:
        return list(transcriber.transcribe(recorded, parses))
