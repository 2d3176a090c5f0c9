"""pocketsphinx: small and exact, and its English model comes in its wheel.

Settings as measured on recordings of real people (97.6 % whole commands right): no lattice pass, wide beams, cepstral
mean reset for each utterance, an automaton without empty moves instead of JSGF.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from importlib import resources
from pathlib import Path

import pocketsphinx

from daemon.hearing.recogniser import Alternative, EngineError, Samples
from grammars.automaton import restrict
from grammars.language import Language

SHIPPED = "en-us"
SETTINGS = {"bestpath": False, "beam": 1e-80, "wbeam": 1e-60, "pbeam": 1e-80, "lm": None}
FORCED = 0.02
"""How much lower a whole sentence may score than the beginning of a longer one, in the decoder's logarithm: whole ones
were at most 0.016 lower, broken-off ones, filled up with a word, 0.01 to 0.09."""


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
        self._version = 0
        self._active = ""
        self._listening = False
        for word, phones in _pronunciations():
            if self._decoder.lookup_word(word) is None:
                self._decoder.add_word(word, phones, True)

    def set_grammar(self, language: Language) -> tuple[str, ...]:
        """See Recogniser.

        Each grammar has a name of its own: adding one again under the active name crashes the decoder.
        """
        listed = language.listed
        unheard = {word for word in listed.words if self._decoder.lookup_word(word) is None}
        automaton = restrict(listed, listed.words - unheard)
        self._lists = language.lists
        self._version += 1
        name = f"language-{self._version}"
        end = automaton.size
        grammar = pocketsphinx.FsgModel(name, self._decoder.logmath, 1.0, end + 1)
        grammar.set_start_state(automaton.start)
        grammar.set_final_state(end)
        for source, word, target in automaton.arcs:
            grammar.trans_add(source, target, 0, grammar.word_add(word))
        for state in sorted(automaton.finals):
            grammar.null_trans_add(state, end, 0)
        self._decoder.add_fsg(name, grammar)
        self._decoder.activate_search(name)
        if self._active:
            self._decoder.remove_search(self._active)
        self._active = name
        return tuple(sorted(unheard))

    def is_sentence(self, text: str) -> bool:
        """See Recogniser: it hears what is listed and nothing else."""
        return self._lists(text)

    def reset(self) -> None:
        """See Recogniser."""
        if not self._active:
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
        return self._text()

    def final(self) -> tuple[Alternative, ...]:
        """See Recogniser.

        One hypothesis only: without the lattice pass there are no others worth the time. The decoder would end in a
        sentence at any price; where that is too high, what was heard is the beginning of one.
        """
        unforced = self._decoder.hyp()
        self._decoder.end_utt()
        self._listening = False
        forced = self._decoder.hyp()
        if unforced and (not forced or math.log(unforced.score / forced.score) > FORCED):
            return (Alternative(str(unforced.hypstr), 0.0),)
        return (Alternative(str(forced.hypstr), self._fit()),) if forced else ()

    def _text(self) -> str:
        found = self._decoder.hyp()
        return str(found.hypstr) if found else ""

    def _fit(self) -> float:
        """How well the words fit the sound: the geometric mean over their frames of the senone's score to the best."""
        frames, score = 0, 0.0
        for segment in self._decoder.seg():
            if segment.word[0] not in "<[(":
                frames += segment.end_frame - segment.start_frame + 1
                score += math.log(max(segment.ascore, 1e-300))
        return math.exp(score / frames) if frames else 0.0


def _pronunciations() -> Iterator[tuple[str, str]]:
    text = resources.files("grammars").joinpath("words/pronunciations.txt").read_text("utf-8")
    for line in text.splitlines():
        if line.strip() and not line.startswith("#"):
            word, _, phones = line.partition(" ")
            yield word, phones.strip()
