"""The seam between hearing and the speech engines: one protocol, engines found by name."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple, Protocol

import numpy as np
import numpy.typing as npt

from grammars.language import Language

RATE_HZ = 16_000
"""Samples a second that every engine gets: one channel, 16 bits."""

Samples = npt.NDArray[np.int16]


class Alternative(NamedTuple):
    """One hypothesis: its text and how far it is to be trusted, 0 to 1."""

    text: str
    confidence: float


class Recogniser(Protocol):
    """A speech engine with a grammar. It lives in a process of its own and is used by one thread.

    set_grammar is called between utterances only; feed only between reset and final.
    """

    def set_grammar(self, language: Language) -> tuple[str, ...]:
        """Take a new language; return the words that are listened for and that this engine cannot hear."""

    def is_sentence(self, text: str) -> bool:
        """Whether a hypothesis of this engine is a whole sentence of the language."""

    def reset(self) -> None:
        """Forget the utterance, if there is one, and begin another."""

    def feed(self, samples: Samples) -> None:
        """Hear a little more of the utterance."""

    def partial(self) -> str:
        """The best hypothesis so far."""

    def final(self) -> tuple[Alternative, ...]:
        """End the utterance: its hypotheses, the best first; empty if no word was heard."""


class EngineError(Exception):
    """An engine cannot be used as configured."""


class UnknownEngineError(EngineError):
    """The configuration names an engine that is not there."""

    def __init__(self, name: str) -> None:
        known = ", ".join(engines())
        super().__init__(f"there is no speech engine {name}; there are {known}")
        self.name = name


def engines() -> tuple[str, ...]:
    """Names of the engines: every <name>_engine.py of this folder."""
    folder = Path(__file__).parent
    return tuple(sorted(path.stem.removesuffix("_engine") for path in folder.glob("*_engine.py")))


def load(name: str, model: str = "") -> tuple[Recogniser, Recogniser]:
    """Load an engine, with a model of the user's or with the one that comes with Sayso: two recognisers on it.

    Raises:
        EngineError: there is no such engine, or its model cannot be used; says why.
    """
    if name not in engines():
        raise UnknownEngineError(name)
    module = importlib.import_module(f"daemon.hearing.{name}_engine")
    loader: Callable[[str], tuple[Recogniser, Recogniser]] = module.load
    return loader(model)
