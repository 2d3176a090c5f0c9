#!/usr/bin/env python3
"""Speak the demonstration's lines into daemon/demo/audio. Needs flite, nothing else: its voices may be shipped.

Each part of the demonstration has a speaker of its own; Rick is the last.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Final

import soundfile
from make_speech import RATE_HZ, speak

from daemon.demo.script import AUDIO, script, spoken
from daemon.dialogue import You

SPEAKERS: Final = (
    ("drive forward", "flite-slt"),
    ("If something is very close then drive backwards", "flite-awb"),
    ("You should never grab a person but instead say I'm not allowed to", "flite-kal16"),
    ("turn means rotate", "flite-slt"),
    ("If Rick tells you to do something don't but instead complain", "flite-kal16"),
    ("I am Rick", "flite-rms"),
)
"""Who speaks from this line on."""


def main() -> int:
    """Make every recording anew; those of lines that are gone are removed."""
    demonstration = script()
    names = spoken(demonstration)
    AUDIO.mkdir(exist_ok=True)
    for old in AUDIO.glob("*.wav"):
        if old.name not in names.values():
            old.unlink()
    voice = ""
    for step in demonstration.steps:
        if isinstance(step, You):
            voice = dict(SPEAKERS).get(step.text, voice)
            path: Path = AUDIO / names[step.line]
            soundfile.write(path, speak(step.text, voice), RATE_HZ, subtype="PCM_16")
            print(f"{voice:12} {path.name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
