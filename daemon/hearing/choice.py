"""Which engine hears: as configured, or the best there is."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from daemon.hearing.recogniser import UnknownEngineError, engines
from daemon.hearing.trust import Thresholds

THRESHOLDS = {
    "vosk": Thresholds(outside=0.5, unsure=0.6),
    "pocketsphinx": Thresholds(outside=0.5, unsure=0.6),
}
"""Measured with five voices. Vosk: all but 6 of 1,095 sentences that are listened for are above the second, and 14 of
244 pieces of chatter, each with the words of a sentence, most of them a question or a fact, none of which moves the
robot. pocketsphinx: 57 of 58 sentences that came out whole, and 1 of 45 pieces of chatter."""
BETTER = "vosk"
"""By benchmarks/hearing.py, five voices at three speeds: the shipped Vosk model has 98.6 % of the demonstration's
sentences whole (340 of 345) and 99.2 % of others (595 of 600), is moved by none of 305 pieces of chatter and by none of
90 lessons with pauses, and takes some 0.1 s for a second of sound; pocketsphinx has 84.5 % (175 of 207) and 73.9 % (266
of 360) in three voices, in as much time."""
OFFICIAL = "vosk-model*-en-*"
"""How the official English models are called."""
MODEL_VARIABLE = "SAYSO_VOSK_MODEL"


@dataclass(frozen=True, slots=True)
class Engine:
    """An engine with its model, "" for the one that comes with Sayso, and the thresholds measured for it."""

    name: str
    model: str = ""

    @property
    def thresholds(self) -> Thresholds:
        """Of this engine."""
        return THRESHOLDS[self.name]


def choose_engine(configured: str, model: str, folders: tuple[Path, ...]) -> Engine:
    """Choose the engine.

    Args:
        configured: an engine's name, or "auto": an installed official Vosk model if there is one, else the better of
            the two that come with Sayso.
        model: path of a model, "" for none; SAYSO_VOSK_MODEL stands in for it where the engine is Vosk.
        folders: where official models are installed.

    Raises:
        UnknownEngineError: there is no engine of that name.
    """
    vosk_model = model or os.environ.get(MODEL_VARIABLE, "")
    if configured == "auto":
        if not vosk_model:
            found = sorted(path for folder in folders for path in folder.glob(OFFICIAL))
            vosk_model = str(found[0]) if found else ""
        return Engine("vosk", vosk_model) if vosk_model else Engine(BETTER)
    if configured not in engines():
        raise UnknownEngineError(configured)
    return Engine(configured, vosk_model if configured == "vosk" else model)
