"""pocketsphinx: an English model of real voices comes in its wheel.

Like Vosk it is told which words follow which in phrases of the whole language, and the language says which of its
hypotheses are sentences. An automaton of what is listened for took three times the memory and the time. It heard more
of the sentences that are listened for whole (81 % where this has 74), but fewer of the demonstration's and hardly one
of all others, and took a quarter of the chatter for sentences. The cepstral mean is reset for each utterance.
"""

from __future__ import annotations

import math
import tempfile
from collections.abc import Iterator
from importlib import resources
from itertools import islice
from pathlib import Path
from typing import Final

import pocketsphinx

from daemon.hearing.judging import Judge
from daemon.hearing.recogniser import Alternative, EngineError, Samples
from daemon.hearing.trigrams import arpa
from grammars.language import Language, listened_for

SHIPPED = "en-us"
SETTINGS: Final = {"lm": None, "fwdflat": False}
"""Without a second pass: what it gave came with scores that cannot be compared, and it took a third more time."""
LISTED: Final = 20_000
"""Sentences that are listened for among the phrases: with them a fifth more of such was heard whole."""
ALTERNATIVES: Final = 30
JUDGE: Final = Judge(listed=0.08, middle=-0.01, spread=0.01)
"""In the decoder's logarithm. Of 45 pieces of chatter 1 was above it, and all but 1 of 58 sentences that came out
whole."""


class DictionaryError(EngineError):
    """A pocketsphinx model that cannot be used."""


def load(model: str) -> tuple[PocketsphinxRecogniser, PocketsphinxRecogniser]:
    """Load a model folder (acoustic model with a .dict beside it), or the wheel's for "": two decoders on it.

    Raises:
        DictionaryError: there is no such folder, or no dictionary in it.
    """
    folder = Path(model or pocketsphinx.get_model_path(SHIPPED))
    dictionaries = sorted(folder.glob("*.dict"))
    if not dictionaries:
        raise DictionaryError(f"{folder}: this is no pocketsphinx model (no .dict in it)")
    inner = folder / folder.name
    place = (inner if inner.is_dir() else folder, dictionaries[0])
    return PocketsphinxRecogniser(*place), PocketsphinxRecogniser(*place)


class PocketsphinxRecogniser:
    """The Recogniser on pocketsphinx."""

    def __init__(self, model: Path, dictionary: Path) -> None:
        config = pocketsphinx.Config(
            hmm=str(model), dict=str(dictionary), loglevel="FATAL", **SETTINGS
        )
        self._decoder = pocketsphinx.Decoder(config)
        self._mean = self._decoder.get_cmn(False)
        self._language: Language | None = None
        self._version = 0
        self._listening = False
        for word, phones in _pronunciations():
            if self._decoder.lookup_word(word) is None:
                self._decoder.add_word(word, phones, True)

    def set_grammar(self, language: Language) -> tuple[str, ...]:
        """See Recogniser.

        Each language has a name of its own: adding one again under the active name crashes the decoder.
        """
        phrases = (*language.phrases, *listened_for(LISTED))
        words = language.words
        unheard = {word for word in words if self._decoder.lookup_word(word) is None}
        before, self._version = self._name, self._version + 1
        with tempfile.NamedTemporaryFile("w", suffix=".arpa", encoding="utf8") as file:
            file.write(arpa(said for said in phrases if unheard.isdisjoint(said.split())))
            file.flush()
            self._decoder.add_lm_file(self._name, file.name)
        self._decoder.activate_search(self._name)
        if self._language is not None:
            self._decoder.remove_search(before)
        self._language = language
        return tuple(sorted(unheard & language.listed.words))

    @property
    def _name(self) -> str:
        return f"language-{self._version}"

    def is_sentence(self, text: str) -> bool:
        """See Recogniser: any that the parser reads."""
        return self._language is not None and self._language.reads(text)

    def reset(self) -> None:
        """See Recogniser."""
        if self._language is None:
            raise EngineError("no grammar was set")
        if self._listening:
            self._decoder.end_utt()
        self._decoder.set_cmn(self._mean)
        self._decoder.start_utt()
        self._listening = True

    def feed(self, samples: Samples) -> None:
        """See Recogniser."""
        self._decoder.process_raw(samples.tobytes(), False, False)

    def partial(self) -> str:
        """See Recogniser."""
        found = self._decoder.hyp()
        return str(found.hypstr) if found else ""

    def final(self) -> tuple[Alternative, ...]:
        """See Recogniser."""
        self._decoder.end_utt()
        self._listening = False
        if self._language is None or (best := self._decoder.hyp()) is None:
            return ()
        scored = dict[str, float]()
        for found in islice(self._decoder.nbest(), ALTERNATIVES):
            scored.setdefault(str(found.hypstr), math.log(found.score))
        # the best has a score of another kind
        scored.setdefault(str(best.hypstr), max(scored.values(), default=0.0))
        return tuple(JUDGE.trusted([*scored.items()], self._language.lists, self.is_sentence))


def _pronunciations() -> Iterator[tuple[str, str]]:
    text = resources.files("grammars").joinpath("words/pronunciations.txt").read_text("utf-8")
    for line in text.splitlines():
        if line.strip() and not line.startswith("#"):
            word, _, phones = line.partition(" ")
            yield word, phones.strip()
