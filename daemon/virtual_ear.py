"""Recordings in virtual time: the real recogniser hears them, at the times their own sound has."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from daemon.closing import Closing
from daemon.config import model_folders
from daemon.hearing import recording
from daemon.hearing.choice import choose_engine
from daemon.hearing.events import Heard, HearingEvent, NotHeard
from daemon.hearing.recogniser import RATE_HZ
from daemon.hearing.transcribe import Transcriber
from daemon.understanding import understand
from grammars.asking import AskWord
from grammars.language import language
from grammars.vocabulary import Vocabulary
from kernel.memory.meaning import Utterance
from kernel.memory.reply import AskKeep, AskWhich


@dataclass(frozen=True, slots=True)
class Recorded:
    """What was heard in a recording, with the moment at which each thing is known; its length, s."""

    events: tuple[tuple[float, HearingEvent], ...]
    length_s: float

    @property
    def said(self) -> bool:
        """There was an utterance in it, of whatever kind."""
        return any(isinstance(event, Heard | NotHeard) for _, event in self.events)


class VirtualEar(Closing):
    """One recogniser for all recordings of a rehearsal; its process starts with the first.

    Args:
        engine: "auto", "vosk" or "pocketsphinx".
        model: path of its model, "" for an installed or the shipped one.
    """

    def __init__(self, engine: str = "auto", model: str = "") -> None:
        self._engine = choose_engine(engine, model, model_folders())
        self._transcriber: Transcriber | None = None
        self._vocabulary: Vocabulary | None = None

    @property
    def engine(self) -> str:
        """The engine's name."""
        return self._engine.name

    def hear(
        self,
        path: Path,
        vocabulary: Vocabulary,
        expecting: AskWhich | AskKeep | AskWord | None = None,
    ) -> Recorded:
        """Hear a recording, knowing these words and the robot's open question.

        Raises:
            RecordingError: the file cannot be heard.
            EngineError: the engine cannot be used.
        """
        samples = recording.read(path)
        ear = self._knowing(vocabulary)

        def parses(text: str) -> bool:
            return understand(Utterance(text), vocabulary, expecting).heard is not None

        known = tuple((known_s(event), event) for event in ear.transcribe(samples, parses))
        return Recorded(known, len(samples) / RATE_HZ)

    def close(self) -> None:
        """End the recogniser."""
        if self._transcriber is not None:
            self._transcriber.close()
            self._transcriber = None

    def _knowing(self, vocabulary: Vocabulary) -> Transcriber:
        if self._transcriber is None:
            self._transcriber = Transcriber(self._engine, language(vocabulary))
        elif vocabulary != self._vocabulary:
            self._transcriber.set_language(language(vocabulary))
        self._vocabulary = vocabulary
        return self._transcriber


def known_s(event: HearingEvent) -> float:
    """The audio time at which an event is there."""
    return event.decided_s if isinstance(event, Heard | NotHeard) else event.at_s
