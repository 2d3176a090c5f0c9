"""How well the engines hear: `python benchmarks/hearing.py [--engine vosk] [--list demonstration] [--wrong]`.

Speaks the lists of hearing_lists/ with synthesizer voices at several speeds (see scripts/make_speech.py; the speech is
kept in .benchmarks/hearing), lets the recogniser process hear them in virtual time, and prints a table: sentences whole
after normalising, time needed for a second of sound, end of speech to decision, end of "stop" to its discovery, and
what was wrongly taken: for chatter every sentence, for lessons with pauses everything that would move the robot.
"""

from __future__ import annotations

import argparse
import re
import shutil
import statistics
import subprocess
import sys
import time
from dataclasses import dataclass, field, fields
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from rich.console import Console
from rich.table import Table

from daemon.hearing import recording
from daemon.hearing.choice import Engine
from daemon.hearing.events import Heard, HearingEvent, NotHeard, StopWord
from daemon.hearing.recogniser import RATE_HZ, engines
from daemon.hearing.transcribe import Transcriber
from grammars.errors import NotUnderstoodError
from grammars.language import language
from grammars.normalise import pieces
from grammars.parse import parse
from grammars.vocabulary import BORN, Vocabulary
from kernel.memory.notation import read
from kernel.memory.reply import AskWhich
from kernel.net.graphlet import Graphlet

HERE = Path(__file__).parent
SPOKEN = HERE.parent / ".benchmarks" / "hearing"
VOICES = ("flite-kal16", "flite-slt", "flite-awb", "flite-rms", "festival-kal")
SPEEDS = {"demonstration": (0.85, 1.0, 1.2), "heldout": (0.85, 1.0, 1.2)}
"""Duration, relative to the voice's own; 1 for a list that is not here."""
PAUSES_S = {"lessons": (0.4, 0.8, 1.2)}
"""What the bars in a list stand for."""
LISTS = ("demonstration", "heldout", "others", "wide", "lessons", "managing", "chatter", "near")
COLUMNS = ("whole", "of", "%", "lag s", "stop s", "wrong", "per s")
TAIL_S = 0.5
APART_S = 2.5
"""Silence between two recordings: what follows an unclear lesson at once would be the rest of it."""
TAUGHT = Vocabulary(BORN.born, {"widdershins": {"DIR": "widdershins"}})
RED = read("ako-1 -lex- block\n-ako-> obj-1\nhq-1 -lex- red\n-hq-> obj-1")
ASKED = AskWhich(RED, (RED,)) if isinstance(RED, Graphlet) else None
"""The question that is open while managing.txt is heard: which block, the red one?"""


def sentences(name: str) -> list[str]:
    return (HERE / "hearing_lists" / f"{name}.txt").read_text("utf8").splitlines()


def normal(text: str) -> tuple[str, ...]:
    return tuple(piece.text for piece in pieces(text))


def parses(text: str, asked: AskWhich | None = None) -> bool:
    try:
        parse(text, TAUGHT, asked)
    except NotUnderstoodError:
        return False
    return True


def moves(text: str) -> bool:
    return parse(text, TAUGHT).kind == "command"


def spoken(name: str, voice: str, speed: float, pause_s: float) -> list[tuple[str, Path]]:
    """The sentences of a list with their recordings, made if they are not there."""
    lines = [line.replace("|P|", f"|{pause_s}|") for line in sentences(name)]
    folder = SPOKEN / (f"{name}-{pause_s}" if pause_s else name)
    made = folder / f"{voice}@{speed}"
    if not made.is_dir():
        with TemporaryDirectory() as work:
            listed = Path(work, "list.tsv")
            listed.write_text("".join(f"{at}\t{text}\n" for at, text in enumerate(lines)))
            script = HERE.parent / "scripts" / "make_speech.py"
            options = ["--voice", voice, "--stretch", str(speed)]
            subprocess.run([sys.executable, script, listed, work, *options], check=True)
            made.parent.mkdir(parents=True, exist_ok=True)
            shutil.move(Path(work, voice), made)
    texts = [re.sub(r" ?\|[^|]*\| ?", " ", line) for line in lines]
    return [(text, made / f"{at}.wav") for at, text in enumerate(texts)]


@dataclass
class Measure:
    """What was measured."""

    whole: int = 0
    count: int = 0
    wrong: int = 0
    sound_s: float = 0.0
    spent_s: float = 0.0
    lags: list[float] = field(default_factory=list)
    stops: list[float] = field(default_factory=list)

    def add(self, other: Measure) -> None:
        for name in (entry.name for entry in fields(self)):
            setattr(self, name, getattr(self, name) + getattr(other, name))

    def cells(self) -> tuple[str, ...]:
        lag = f"{statistics.median(self.lags):.2f}" if self.lags else "-"
        stop = f"{max(self.stops):.2f}" if self.stops else "-"
        shares = (str(self.whole), str(self.count), f"{100 * self.whole / self.count:.1f}")
        return (*shares, lag, stop, str(self.wrong), f"{self.spent_s / self.sound_s:.3f}")


def main() -> int:
    told = argparse.ArgumentParser()
    told.add_argument("--engine", choices=engines(), action="append")
    told.add_argument("--voice", choices=VOICES, action="append")
    told.add_argument("--list", choices=LISTS, action="append", dest="lists")
    told.add_argument("--wrong", action="store_true", help="print what was heard wrong")
    asked = told.parse_args()
    table = Table("engine", "list", "voice", "speed", "pause", *COLUMNS)
    console = Console()
    for engine in asked.engine or engines():
        with Transcriber(Engine(engine), language(TAUGHT)) as transcriber:
            transcriber.start()
            for name in asked.lists or LISTS:
                total = Measure()
                for speed in SPEEDS.get(name, (1.0,)):
                    for pause_s in PAUSES_S.get(name, (0.0,)):
                        for voice in asked.voice or VOICES:
                            heard = spoken(name, voice, speed, pause_s)
                            row = measure(transcriber, name, heard, asked.wrong and voice)
                            cells = (engine, name, voice, str(speed), str(pause_s), *row.cells())
                            table.add_row(*cells)
                            print(*cells, flush=True)
                            total.add(row)
                cells = (engine, name, "all", "", "", *total.cells())
                table.add_row(*cells, end_section=True)
                print(*cells, flush=True)
    console.print(table)
    return 0


def measure(
    transcriber: Transcriber, name: str, recordings: list[tuple[str, Path]], show: str
) -> Measure:
    found = Measure()
    for text, path in recordings:
        samples = recording.read(path)
        length_s = len(samples) / RATE_HZ
        apart = np.concatenate([samples, np.zeros(round(APART_S * RATE_HZ), samples.dtype)])
        began = time.perf_counter()
        judge = partial(parses, asked=ASKED if name == "managing" else None)
        events: list[HearingEvent] = list(transcriber.transcribe(apart, judge))
        found.spent_s += time.perf_counter() - began
        found.sound_s += length_s
        found.count += 1
        heard = [event for event in events if isinstance(event, Heard)]
        stops = [event for event in events if isinstance(event, StopWord)]
        right = len(heard) == 1 and normal(heard[0].text) == normal(text)
        found.whole += right
        wrong = bool(stops) and text != "stop"
        match name:
            case "chatter" | "near":
                wrong = wrong or bool(heard)
            case "lessons":
                wrong = wrong or any(moves(event.text) for event in heard)
            case _:
                found.stops += [event.at_s - (length_s - TAIL_S) for event in stops]
                found.lags += [event.decided_s - event.ended_s for event in heard]
        found.wrong += wrong
        if show and (wrong if name in ("chatter", "near") else wrong or not right):
            told = [
                f"{type(event).__name__} {event.text}"
                for event in events
                if isinstance(event, Heard | NotHeard)
            ]
            print(f"  {show}: {text} -> {told} {'STOP' if stops else ''}", flush=True)
    return found


if __name__ == "__main__":
    sys.exit(main())
