#!/usr/bin/env python3
"""Trim a Vosk model of the vosk-tiny kind to the words that serve, and give it the words it lacks.

    scripts/trim_vosk_model.py SOURCE TARGET [--common 10000] [--also FILE ...]

Acoustic model and settings are copied; the lexicon graph (HCLr.fst, look-ahead on output labels) is built anew from
the pronunciations of pocketsphinx's dictionary, a few reduced forms and grammars/words/pronunciations.txt; the bigram
grammar (Gr.fst) is cut down to the words kept. Kept are the most frequent words of the source, and every word found in
the files given with --also. Needs fstcompile, fstprint, fstarcsort and fstconvert with libfstlookahead (Debian:
libfst-tools).

Facts about the model, from its recipe. Phones are word-position dependent: 1 silence, 2 the unknown word's, then four
(begin, end, internal, alone) for each real phone in alphabetical order. One emitting state a phone; transition ids are
2(p-1)+1 for its self-loop and 2(p-1)+2 for entering it. No disambiguation symbols.
"""

from __future__ import annotations

import argparse
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

PHONES = (
    "AA AE AH AO AW AY B CH D DH EH ER EY F G HH IH IY JH K L M N NG OW OY P R S SH T TH UH UW V W Y Z ZH"
).split()
SILENCE, UNKNOWN = 1, 2
UNKNOWN_WORD = "[unk]"
SILENCE_PROBABILITY = 0.2
SECOND_PRONUNCIATION_COST = 0.3
NEW_WORD_COST = 6.0 * math.log(10.0)
REDUCED_FORMS = {
    "and": ("AE N D", "AH N D", "AH N", "EH N D", "IH N D"),
    "to": ("T UW", "T AH", "T IH"),
    "the": ("DH AH", "DH IY"),
    "a": ("AH", "EY"),
    "for": ("F AO R", "F ER"),
    "can": ("K AE N", "K AH N"),
    "you": ("Y UW", "Y AH"),
    "at": ("AE T", "AH T"),
    "your": ("Y AO R", "Y UH R", "Y ER"),
    "or": ("AO R", "ER"),
    "as": ("AE Z", "AH Z"),
    "from": ("F R AH M", "F R AA M"),
}
"""Forms that synthesizers and people both use; the model was trained with them."""
LOOKAHEAD = {"LD_PRELOAD": "libfstlookahead.so.22"}
HOUSE = Path(__file__).resolve().parent.parent

Pronunciation = tuple[str, ...]
Lexicon = dict[str, list[Pronunciation]]


def read_lexicon(paths: Iterable[Path]) -> Lexicon:
    """Read pronunciations in the dictionary's form, "word PH PH" or "word(2) PH PH", earlier files first."""
    lexicon: Lexicon = {
        word: [tuple(form.split()) for form in forms] for word, forms in REDUCED_FORMS.items()
    }
    for path in paths:
        for line in path.read_text(encoding="utf-8").splitlines():
            parts = line.split()
            if len(parts) < 2 or parts[0].startswith("#"):
                continue
            known = lexicon.setdefault(re.sub(r"\(\d+\)$", "", parts[0]), [])
            if tuple(parts[1:]) not in known:
                known.append(tuple(parts[1:]))
    return lexicon


def phone_ids(pronunciation: Pronunciation) -> tuple[int, ...]:
    """Number the phones of a word by their position in it."""
    last = len(pronunciation) - 1

    def position(place: int) -> int:
        if last == 0:
            return 3
        return 0 if place == 0 else 1 if place == last else 2

    return tuple(
        3 + 4 * PHONES.index(phone) + position(place) for place, phone in enumerate(pronunciation)
    )


@dataclass
class LexiconGraph:
    """The lexicon as a transducer from transition ids to words, in OpenFst's text form.

    The words share their beginnings until only one word is left; its label comes out there, and what follows shares
    the endings. States 0, 1, 2 are the start, the place between words, and silence.
    """

    arcs: list[str] = field(default_factory=list)
    _states: int = 3
    _endings: dict[tuple[int, ...], int] = field(default_factory=dict)

    @classmethod
    def build(cls, entries: Iterable[tuple[int, tuple[int, ...], float]]) -> LexiconGraph:
        """Build from (word number, phone numbers, cost)."""
        graph = cls()
        quiet, silent = -math.log(1 - SILENCE_PROBABILITY), -math.log(SILENCE_PROBABILITY)
        graph._arc(0, 1, 0, 0, quiet)
        graph._arc(0, 2, _enter(SILENCE), 0, silent)
        graph._arc(2, 2, _stay(SILENCE))
        graph._arc(2, 1, 0)
        graph._branch(1, sorted((phones, word, cost) for word, phones, cost in entries), 0)
        graph.arcs.append("1")
        return graph

    def _arc(self, source: int, target: int, label: int, word: int = 0, cost: float = 0.0) -> None:
        self.arcs.append(f"{source}\t{target}\t{label}\t{word}\t{cost:.4f}")

    def _state(self, phone: int) -> int:
        state, self._states = self._states, self._states + 1
        self._arc(state, state, _stay(phone))
        return state

    def _branch(
        self, state: int, entries: list[tuple[tuple[int, ...], int, float]], depth: int
    ) -> None:
        by_phone: dict[int, list[tuple[tuple[int, ...], int, float]]] = {}
        for entry in entries:
            by_phone.setdefault(entry[0][depth], []).append(entry)
        for phone, here in by_phone.items():
            if len(here) == 1:
                phones, word, cost = here[0]
                self._arc(state, self._ending(phones[depth:]), _enter(phone), word, cost)
                continue
            for phones, word, cost in here:
                if len(phones) == depth + 1:
                    self._arc(state, self._ending(phones[depth:]), _enter(phone), word, cost)
            longer = [entry for entry in here if len(entry[0]) > depth + 1]
            if longer:
                middle = self._state(phone)
                self._arc(state, middle, _enter(phone))
                self._branch(middle, longer, depth + 1)

    def _ending(self, phones: tuple[int, ...]) -> int:
        """The state that is in the first of these phones and goes on through the others."""
        if phones not in self._endings:
            self._endings[phones] = state = self._state(phones[0])
            if len(phones) == 1:
                self._arc(state, 1, 0, 0, -math.log(1 - SILENCE_PROBABILITY))
                self._arc(state, 2, _enter(SILENCE), 0, -math.log(SILENCE_PROBABILITY))
            else:
                self._arc(state, self._ending(phones[1:]), _enter(phones[1]))
        return self._endings[phones]


def _enter(phone: int) -> int:
    return 2 * (phone - 1) + 2


def _stay(phone: int) -> int:
    return 2 * (phone - 1) + 1


@dataclass(frozen=True)
class Bigram:
    """The source's grammar: one state for each word that has bigrams, 0 for the start, 1 for backing off.

    arcs are (from, to, word or "", cost); finals are (state, cost).
    """

    arcs: tuple[tuple[int, int, str, float], ...]
    finals: tuple[tuple[int, float], ...]

    @classmethod
    def read(cls, model: Path) -> Bigram:
        """Read the grammar of a model."""
        names = {}
        for line in (model / "graph/words.txt").read_text(encoding="utf-8").splitlines():
            word, number = line.split()
            names[number] = "" if word == "<eps>" else word
        printed = _run(["fstprint", str(model / "graph/Gr.fst")])
        arcs, finals = [], []
        for row in (line.split("\t") for line in printed.splitlines()):
            if len(row) >= 4:
                cost = float(row[4]) if len(row) > 4 else 0.0
                arcs.append((int(row[0]), int(row[1]), names[row[2]], cost))
            else:
                finals.append((int(row[0]), float(row[1]) if len(row) > 1 else 0.0))
        return cls(tuple(arcs), tuple(finals))

    def by_frequency(self) -> list[str]:
        """Every word, the most frequent first."""
        costs = sorted((cost, word) for start, _, word, cost in self.arcs if start == 1 and word)
        return [word for _, word in costs]

    def cut(self, numbers: Mapping[str, int]) -> Iterator[str]:
        """Cut down to the words numbered, in OpenFst's text form, the start state first."""
        own = {state for start, state, word, _ in self.arcs if start == 1 and word in numbers}
        kept = own | {0, 1}
        seen = set()
        for start, target, word, cost in sorted(self.arcs, key=lambda arc: arc[0]):
            if start in kept and target in kept and (not word or word in numbers):
                number = numbers[word] if word else 0
                yield f"{start}\t{target}\t{number}\t{number}\t{cost:.4f}"
                if start == 1:
                    seen.add(word)
        for word in sorted(numbers.keys() - seen - {"<eps>"}):
            yield f"1\t1\t{numbers[word]}\t{numbers[word]}\t{NEW_WORD_COST:.4f}"
        for state, cost in self.finals:
            if state in kept:
                yield f"{state}\t{cost:.4f}"


def trim(source: Path, target: Path, words: list[str], lexicon: Lexicon, bigram: Bigram) -> None:
    """Write the model at target with these words."""
    graph = target / "graph"
    (graph / "phones").mkdir(parents=True, exist_ok=True)
    for name in ("am", "conf"):
        shutil.copytree(source / name, target / name, dirs_exist_ok=True)
    for name in ("phones/word_boundary.int", "disambig_tid.int"):
        shutil.copyfile(source / "graph" / name, graph / name)
    numbers = {word: place for place, word in enumerate(["<eps>", UNKNOWN_WORD, *words])}
    entries: list[tuple[int, tuple[int, ...], float]] = [(numbers[UNKNOWN_WORD], (UNKNOWN,), 0.0)]
    for word in words:
        for place, pronunciation in enumerate(lexicon[word]):
            cost = SECOND_PRONUNCIATION_COST if place else 0.0
            entries.append((numbers[word], phone_ids(pronunciation), cost))
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        (work / "lexicon.txt").write_text("\n".join(LexiconGraph.build(entries).arcs) + "\n")
        _run(["fstcompile", str(work / "lexicon.txt"), str(work / "lexicon.fst")])
        _run(
            [
                "fstarcsort",
                "--sort_type=olabel",
                str(work / "lexicon.fst"),
                str(work / "sorted.fst"),
            ]
        )
        _run(
            [
                "fstconvert",
                "--fst_type=olabel_lookahead",
                f"--save_relabel_opairs={work / 'relabel'}",
                str(work / "sorted.fst"),
                str(graph / "HCLr.fst"),
            ],
            LOOKAHEAD,
        )
        pairs = (line.split() for line in (work / "relabel").read_text().splitlines() if line)
        moved = {int(before): int(after) for before, after in pairs}
        numbers = {word: moved.get(number, number) for word, number in numbers.items()}
        (work / "bigram.txt").write_text("\n".join(bigram.cut(numbers)) + "\n")
        _run(["fstcompile", str(work / "bigram.txt"), str(work / "bigram.fst")])
        _run(
            ["fstarcsort", "--sort_type=ilabel", str(work / "bigram.fst"), str(work / "sorted.fst")]
        )
        _run(["fstconvert", "--fst_type=const", str(work / "sorted.fst"), str(graph / "Gr.fst")])
    rows = sorted(numbers.items(), key=lambda item: item[1])
    (graph / "words.txt").write_text("".join(f"{word} {number}\n" for word, number in rows))


def _run(command: list[str], environment: Mapping[str, str] | None = None) -> str:
    done = subprocess.run(
        command,
        check=True,
        text=True,
        stdout=subprocess.PIPE,
        env={**os.environ, **(environment or {})},
    )
    return done.stdout


def main() -> int:
    """Trim a model as the command line says."""
    told = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    told.add_argument("source", type=Path)
    told.add_argument("target", type=Path)
    told.add_argument("--common", type=int, default=10_000, help="frequent words to keep")
    told.add_argument("--also", type=Path, nargs="*", default=[], help="files whose words to keep")
    asked = told.parse_args()

    import pocketsphinx  # only for the place of its dictionary

    dictionary = Path(pocketsphinx.get_model_path("en-us/cmudict-en-us.dict"))
    lexicon = read_lexicon([HOUSE / "grammars/words/pronunciations.txt", dictionary])
    bigram = Bigram.read(asked.source)
    text = " ".join(path.read_text(encoding="utf-8").lower() for path in asked.also)
    wanted = set(re.findall(r"[a-z](?:[a-z'-]*[a-z])?", text))
    wanted |= {part for word in wanted for part in word.split("-")}
    common = [word for word in bigram.by_frequency() if re.fullmatch(r"[a-z][a-z']*", word)]
    words = sorted((wanted | set(common[: asked.common])) & lexicon.keys())
    trim(asked.source, asked.target, words, lexicon, bigram)
    missing = sorted(wanted - lexicon.keys())
    print(f"{len(words)} words; no pronunciation for: {' '.join(missing) or 'none'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
