"""What the robot is born knowing: English sentences in *.txt here, compiled to notation in born.net.

Start-up reads the compiled file and parses nothing; a test compares it with a fresh compile.
"""

from __future__ import annotations

import re
from importlib.resources import files
from typing import Final, get_args
from zlib import crc32

from kernel.errors import NotationError
from kernel.memory.lesson import INNATE, Lesson, LessonKind
from kernel.memory.notation import read

COMPILED: Final = "born.net"
_HEAD: Final = re.compile(r"# (?P<kind>[a-z]+): (?P<words>.+)")


def born() -> list[Lesson]:
    """The lessons it is born with, in the order of the sentences.

    Their numbers are below zero and made from the notation: a forgotten one stays forgotten although sentences are
    added or removed.

    Raises:
        NotationError: the compiled file is damaged.
    """
    return lessons(files(__package__).joinpath(COMPILED).read_text("utf8"))


def lessons(compiled: str) -> list[Lesson]:
    """The lessons of a compiled text: blocks apart by a blank line, each a heading "# kind: words" over notation.

    Raises:
        NotationError: a heading is missing or names no kind of lesson, or what is under it is no notation.
    """
    found: list[Lesson] = []
    for block in filter(None, (part.strip() for part in compiled.split("\n\n"))):
        heading, _, notation = block.partition("\n")
        match = _HEAD.fullmatch(heading)
        kinds: dict[str, LessonKind] = {kind: kind for kind in get_args(LessonKind)}
        if match is None or match["kind"] not in kinds:
            raise NotationError(1, heading, "a heading such as # procedure: to bow, lower the lift")
        number = -1 - crc32(notation.strip().encode()) % (-INNATE - 1)
        found.append(Lesson(number, kinds[match["kind"]], read(notation), match["words"]))
    return found
