#!/usr/bin/env python3
"""Speak sentences with synthesizer voices into 16 kHz mono WAV files.

    scripts/make_speech.py LIST FOLDER [--voice flite-slt] [--voice festival-kal] [--stretch 1.0]

LIST holds one sentence a line, or "name<tab>sentence"; a pause is written in seconds between bars: "to cha-cha |0.8|
drive forward". The files are FOLDER/<voice>/<name>.wav. Needs flite, festival with festvox-kallpc16k, espeak-ng:
whichever of them the voices belong to. The demonstration's audio and the fixtures in tests/audio were made by it.
"""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import numpy.typing as npt
import soundfile
import soxr

RATE_HZ = 16_000
VOICES = ("flite-kal16", "flite-slt", "flite-awb", "flite-rms", "festival-kal", "espeak-en-us")
LEAD_S, TAIL_S = 0.3, 0.5
"""Silence before and after the words. A file has to end with some: the last word ends when it is heard to end."""

Samples = npt.NDArray[np.int16]


def speak(text: str, voice: str, stretch: float = 1.0) -> Samples:
    """Speak a sentence, with pauses where the text has |seconds|; longer for a stretch above 1.

    Raises:
        ValueError: the voice is none of VOICES' kinds.
        subprocess.CalledProcessError: the synthesizer failed.
    """
    parts: list[Samples] = [_silence(LEAD_S)]
    for place, piece in enumerate(re.split(r"\|\s*([\d.]+)\s*\|", text)):
        if place % 2:
            parts.append(_silence(float(piece)))
        elif piece.strip():
            parts.append(_trim(_synthesise(piece.strip(), voice, stretch)))
    parts.append(_silence(TAIL_S))
    return np.concatenate(parts)


def slug(text: str) -> str:
    """Name a file after its sentence."""
    return re.sub(r"[^a-z0-9]+", "-", re.sub(r"\|.*?\|", " ", text).replace("'", "").lower()).strip(
        "-"
    )


def _synthesise(text: str, voice: str, stretch: float) -> Samples:
    engine, _, name = voice.partition("-")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "said.wav")
        if engine == "flite":
            options = ["--setf", f"duration_stretch={stretch}"]
            command = ["flite", "-voice", name, *options, "-t", text, "-o", str(path)]
            script = ""
        elif engine == "festival":
            said = text.replace("\\", "").replace('"', "")
            command = ["festival", "--pipe"]
            script = (
                f"(voice_{name}_diphone) (Parameter.set 'Duration_Stretch {stretch}) "
                f'(utt.save.wave (utt.synth (Utterance Text "{said}")) "{path}" \'riff)'
            )
        elif engine == "espeak":
            pace = str(round(160 / stretch))
            command = ["espeak-ng", "-v", name, "-s", pace, "-w", str(path), text]
            script = ""
        else:
            raise ValueError(f"no voice {voice}: known are {', '.join(VOICES)}")
        subprocess.run(command, input=script, text=True, check=True, capture_output=True)
        samples, rate_hz = soundfile.read(path, dtype="int16", always_2d=True)
    mono: Samples = samples[:, 0]
    if rate_hz != RATE_HZ:
        mono = soxr.resample(mono, rate_hz, RATE_HZ)
    return mono


def _trim(samples: Samples) -> Samples:
    """Cut the synthesizer's own silence, so that a pause is as long as the list says."""
    loud = np.flatnonzero(np.abs(samples.astype(np.int32)) > 100)
    return samples[loud[0] : loud[-1] + 1] if len(loud) else samples[:0]


def _silence(length_s: float) -> Samples:
    """Near silence: a room is never digitally silent."""
    noise = np.random.default_rng(0).normal(0.0, 3.0, round(length_s * RATE_HZ))
    return noise.astype(np.int16)


def main() -> int:
    """Speak a list of sentences with every voice asked for."""
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    words.add_argument("list", type=Path, help="sentences, one a line, or name<tab>sentence")
    words.add_argument("folder", type=Path)
    words.add_argument("--voice", action="append", help=f"one of {', '.join(VOICES)}; repeatable")
    words.add_argument("--stretch", type=float, default=1.0, help="above 1 is slower")
    asked = words.parse_args()
    for voice in asked.voice or ["flite-slt"]:
        (asked.folder / voice).mkdir(parents=True, exist_ok=True)
        for line in asked.list.read_text(encoding="utf-8").splitlines():
            if not line.strip() or line.startswith("#"):
                continue
            name, _, sentence = line.rpartition("\t")
            path = asked.folder / voice / f"{name or slug(sentence)}.wav"
            soundfile.write(path, speak(sentence, voice, asked.stretch), RATE_HZ, subtype="PCM_16")
    return 0


if __name__ == "__main__":
    sys.exit(main())
