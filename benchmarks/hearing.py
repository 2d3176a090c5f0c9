"""How well the engines hear: `python benchmarks/hearing.py [--engine vosk] [--quick]`.

Speaks the lists of hearing_lists/ with synthesizer voices (see scripts/make_speech.py; the speech is kept in
.benchmarks/hearing), lets the recogniser process hear them in virtual time, and prints a table: sentences whole after
normalising, time needed for a second of sound, end of speech to decision, end of "stop" to its discovery, and what was
taken for a sentence though it was chatter.
"""

from __future__ import annotations

import argparse
import statistics
import subprocess
import sys
import time
from pathlib import Path

from rich.console import Console
from rich.table import Table

from daemon.hearing import recording
from daemon.hearing.choice import Engine
from daemon.hearing.events import Heard, HearingEvent, StopWord
from daemon.hearing.recogniser import RATE_HZ, engines
from daemon.hearing.transcribe import Transcriber
from grammars.errors import NotUnderstoodError
from grammars.finite_state import automaton
from grammars.normalise import pieces
from grammars.parse import parse
from grammars.vocabulary import BORN, Vocabulary

HERE = Path(__file__).parent
SPOKEN = HERE.parent / ".benchmarks" / "hearing"
VOICES = ("flite-kal16", "flite-slt", "flite-awb", "flite-rms", "festival-kal", "espeak-en-us")
TAIL_S = 0.5
TAUGHT = Vocabulary(BORN.born, {"widdershins": {"DIR": "widdershins"}})


def sentences(name: str) -> list[str]:
    return (HERE / "hearing_lists" / f"{name}.txt").read_text("utf8").splitlines()


def normal(text: str) -> tuple[str, ...]:
    return tuple(piece.text for piece in pieces(text))


def parses(text: str) -> bool:
    try:
        parse(text, TAUGHT)
    except NotUnderstoodError:
        return False
    return True


def spoken(name: str, voice: str) -> list[tuple[str, Path]]:
    folder = SPOKEN / name
    listed = folder / "list.tsv"
    folder.mkdir(parents=True, exist_ok=True)
    listed.write_text("".join(f"{at}\t{text}\n" for at, text in enumerate(sentences(name))))
    if not (folder / voice).is_dir():
        script = HERE.parent / "scripts" / "make_speech.py"
        subprocess.run([sys.executable, script, listed, folder, "--voice", voice], check=True)
    return [(text, folder / voice / f"{at}.wav") for at, text in enumerate(sentences(name))]


def main() -> int:
    told = argparse.ArgumentParser()
    told.add_argument("--engine", choices=engines(), action="append")
    told.add_argument("--list", action="append", dest="lists")
    told.add_argument("--wrong", action="store_true", help="print what was heard wrong")
    asked = told.parse_args()
    table = Table("engine", "voice", "list", "whole", "of", "lag s", "stop s", "false", "per s")
    console = Console()
    for engine in asked.engine or engines():
        with Transcriber(Engine(engine), automaton(TAUGHT)) as transcriber:
            transcriber.start()
            for name in asked.lists or ("demonstration", "others", "chatter"):
                for voice in VOICES:
                    row = measure(transcriber, name, voice, asked.wrong)
                    table.add_row(engine, voice, name, *row)
                    print(engine, voice, name, *row, flush=True)
    console.print(table)
    return 0


def measure(transcriber: Transcriber, name: str, voice: str, show: bool) -> list[str]:
    whole = wrong = count = 0
    lags: list[float] = []
    stops: list[float] = []
    sound_s = spent_s = 0.0
    for text, path in spoken(name, voice):
        samples = recording.read(path)
        length_s = len(samples) / RATE_HZ
        began = time.perf_counter()
        events: list[HearingEvent] = list(transcriber.transcribe(samples, parses))
        spent_s += time.perf_counter() - began
        sound_s += length_s
        count += 1
        heard = [event for event in events if isinstance(event, Heard)]
        found = [event for event in events if isinstance(event, StopWord)]
        stops += [event.at_s - (length_s - TAIL_S) for event in found]
        lags += [event.decided_s - event.ended_s for event in heard]
        right = len(heard) == 1 and normal(heard[0].text) == normal(text)
        whole += right
        wrong += bool(found) != (text == "stop") or (name == "chatter" and bool(heard))
        if show and (heard if name == "chatter" else not right):
            print(f"{voice}: {text} -> {events[-1] if events else 'nothing'}")
    lag = f"{statistics.median(lags):.2f}" if lags else "-"
    stop = f"{max(stops):.2f}" if stops else "-"
    return [str(whole), str(count), lag, stop, str(wrong), f"{spent_s / sound_s:.3f}"]


if __name__ == "__main__":
    sys.exit(main())
