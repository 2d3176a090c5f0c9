"""The demonstration's script and its recordings: package data beside this module."""

from __future__ import annotations

import re
from importlib.resources import files
from pathlib import Path
from typing import Final

from daemon.dialogue import Dialogue, You, load

FOLDER: Final = Path(str(files("daemon.demo")))
SCRIPT: Final = FOLDER / "paper.txt"
AUDIO: Final = FOLDER / "audio"


def spoken(dialogue: Dialogue) -> dict[int, str]:
    """The name of the recording of each spoken line, by its line number: its place among them and its words.

    >>> from daemon.dialogue import parse
    >>> spoken(parse("you: hi\\nyou: I'm Rick!"))
    {1: '01-hi.wav', 2: '02-im-rick.wav'}
    """
    lines = [step for step in dialogue.steps if isinstance(step, You)]
    return {step.line: f"{place:02}-{_slug(step.text)}.wav" for place, step in enumerate(lines, 1)}


def recordings(dialogue: Dialogue, folder: Path = AUDIO) -> dict[int, Path]:
    """The recording of each spoken line.

    Raises:
        FileNotFoundError: one is not there; scripts/make_demo_audio.py makes them.
    """
    paths = {line: folder / name for line, name in spoken(dialogue).items()}
    for path in paths.values():
        if not path.is_file():
            raise FileNotFoundError(
                f"{path}: no such recording; scripts/make_demo_audio.py makes it"
            )
    return paths


def script(path: Path = SCRIPT) -> Dialogue:
    """The demonstration as shipped, or another file of the same sort."""
    return load(path)


def _slug(text: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", text.lower().replace("'", "")).strip("-")
