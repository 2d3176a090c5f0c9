"""Vosk: the owner's engine. Any model with run-time grammars; a small one comes with Sayso.

Its phrase list is only a bigram with backoff (any order of the words passes, at a cost), so it is given phrases of the
whole language, asked for many alternatives, and `judging` says which of them are sentences. What is not in the
language shows as [unk], and as a best alternative that is no sentence: the confidence is the margin over it.
"""

from __future__ import annotations

import json
import tempfile
from pathlib import Path

import vosk

from daemon.hearing.judging import Judge
from daemon.hearing.recogniser import RATE_HZ, Alternative, EngineError, Samples
from grammars.language import Language

SHIPPED = Path(__file__).parent / "models" / "vosk-tiny"
ALTERNATIVES = 20
UNKNOWN = "[unk]"
UNKNOWN_SHARE = 20
"""One [unk] for so many phrases: with a single one, its share of the bigram vanishes as the list grows."""

LISTED = 5.0
"""Nats by which a sentence that is listened for is taken to be likelier than any other: without it "to shimmy" came out
as "to show me" in a voice of three; and with 6 other sentences began to be taken for such ones."""

DOUBT = 0.5
"""Cost in nats of an "a": "grab the" came out as "grab a" in 3 of 230 sentences without it, and with 1.0 "a" as "the"
in as many others."""

JUDGE = Judge(LISTED, middle=-0.8, spread=2.0)
"""Confidence 0.6, which is enough, where a sentence fits best. Of 183 pieces of chatter 14 were above it, each with the
words of a sentence and none that moves the robot; and 6 in 10 other sentences of those people would say."""

OVERLAY = """--endpoint.rule1.min-trailing-silence=1000
--endpoint.rule2.min-trailing-silence=1000
--endpoint.rule3.min-trailing-silence=1000
--endpoint.rule4.min-trailing-silence=1000
--endpoint.rule5.min-utterance-length=1000
--frames-per-chunk=3
--beam=13.0
--lattice-beam=8.0
"""
"""Never an end of speech of its own accord, that is the listener's; and hypotheses every 30 ms instead of every 210,
which the stop spotter needs; and alternatives enough: with a lattice beam of 4 the right one was missing in 1 of 25."""


class ModelError(EngineError):
    """A Vosk model that cannot be used."""


STEADY = "--dither=0\n"
"""Kaldi's own noise is random, and the same sound never the same twice; the listener adds noise that is."""
OVERLAYS = {"model.conf": OVERLAY, "mfcc.conf": STEADY}


def load(model: str) -> tuple[VoskRecogniser, VoskRecogniser]:
    """Load a model folder, or the shipped model for "": two recognisers that share it.

    Raises:
        ModelError: there is no such folder, it is no Vosk model, or it takes no grammars.
    """
    path = Path(model) if model else SHIPPED
    check(path)
    vosk.SetLogLevel(-1)
    with tempfile.TemporaryDirectory(prefix="sayso-model-") as folder:
        overlay(path, Path(folder))
        try:
            loaded = vosk.Model(folder)
        except Exception as error:  # the binding raises nothing narrower
            raise ModelError(f"{path}: Vosk cannot load this model") from error
    return VoskRecogniser(loaded), VoskRecogniser(loaded)


class VoskRecogniser:
    """The Recogniser on Vosk."""

    def __init__(self, model: vosk.Model) -> None:
        self._model = model
        self._recogniser: vosk.KaldiRecognizer | None = None
        self._language: Language | None = None
        self._joined: dict[str, str] = {}

    def set_grammar(self, language: Language) -> tuple[str, ...]:
        """See Recogniser. Words the model lacks are spelled by their parts ("cha-cha"), or left out and returned."""
        self._joined, self._language = {}, language
        unheard = {word for word in language.words if not self._can_hear(word)}
        parts_of = {word: parts for parts, word in self._joined.items()}

        def spelled(phrase: str) -> str:
            words = phrase.split()
            if parts_of.keys().isdisjoint(words):
                return phrase
            return " ".join(parts_of.get(word, word) for word in words)

        phrases = [spelled(said) for said in language.phrases if unheard.isdisjoint(said.split())]
        grammar = phrases + [UNKNOWN] * (1 + len(phrases) // UNKNOWN_SHARE)
        self._recogniser = vosk.KaldiRecognizer(self._model, float(RATE_HZ), json.dumps(grammar))
        self._recogniser.SetMaxAlternatives(ALTERNATIVES)
        return tuple(sorted(unheard & language.listed.words))

    def is_sentence(self, text: str) -> bool:
        """See Recogniser: any that the parser reads."""
        return self._language is not None and UNKNOWN not in text and self._language.reads(text)

    def _can_hear(self, word: str) -> bool:
        """The model knows the word, or at least its parts."""
        if self._knows(word):
            return True
        parts = word.replace("-", " ")
        if " " not in parts or not all(self._knows(part) for part in parts.split()):
            return False
        self._joined[parts] = word
        return True

    def reset(self) -> None:
        """See Recogniser. Reset() alone would keep the means and the frames of an utterance that was not ended."""
        self._engine.FinalResult()
        self._engine.Reset()

    def feed(self, samples: Samples) -> None:
        """See Recogniser."""
        self._engine.AcceptWaveform(samples.tobytes())

    def partial(self) -> str:
        """See Recogniser."""
        return self._read(json.loads(self._engine.PartialResult()).get("partial", ""))

    def final(self) -> tuple[Alternative, ...]:
        """See Recogniser."""
        result = json.loads(self._engine.FinalResult())
        heard = ((self._read(found["text"]), found) for found in result["alternatives"])
        scored = [
            (text, float(found["confidence"]) - DOUBT * text.split().count("a"))
            for text, found in heard
        ]
        assert self._language is not None
        return tuple(JUDGE.trusted(scored, self._language.lists, self.is_sentence))

    @property
    def _engine(self) -> vosk.KaldiRecognizer:
        if self._recogniser is None:
            raise EngineError("no grammar was set")
        return self._recogniser

    def _knows(self, word: str) -> bool:
        return bool(self._model.vosk_model_find_word(word) >= 0)

    def _read(self, text: str) -> str:
        for parts, word in self._joined.items():
            text = f" {text} ".replace(f" {parts} ", f" {word} ").strip()
        return text


def check(path: Path) -> None:
    """Look at a model before Vosk does, which is curt or worse.

    Raises:
        ModelError: see load.
    """
    if not path.is_dir():
        raise ModelError(f"{path}: there is no such folder")
    if not any(path.rglob("final.mdl")):
        raise ModelError(f"{path}: this is no Vosk model (no final.mdl in it)")
    if not any(path.rglob("HCLr.fst")):
        raise ModelError(
            f"{path}: this model has a fixed graph (HCLG.fst) and takes no grammars; use one of Vosk's small models"
        )


def overlay(model: Path, folder: Path) -> None:
    """Make a folder that is the model with our endpoint settings; the model itself stays as it is."""
    for entry in model.iterdir():
        if entry.name != "conf":
            (folder / entry.name).symlink_to(entry.resolve())
    settings = model / "conf"
    if not settings.is_dir():
        return
    (folder / "conf").mkdir()
    for entry in settings.iterdir():
        if entry.name not in OVERLAYS:
            (folder / "conf" / entry.name).symlink_to(entry.resolve())
    for name, added in OVERLAYS.items():
        own = settings / name
        lines = own.read_text(encoding="utf-8").splitlines() if own.is_file() else []
        kept = [line for line in lines if not _is_ours(line)]
        (folder / "conf" / name).write_text("\n".join(kept) + "\n" + added, encoding="utf-8")


def _is_ours(line: str) -> bool:
    return any(option in line for option in ("endpoint.rule", "frames-per-chunk", "dither"))
