"""Lessons as a text file: readable English, one lesson a line, that `sayso teach` learns again."""

from __future__ import annotations

import re
import time
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from daemon.lessons import Row

GROUPS: Final[tuple[tuple[str, tuple[str, ...]], ...]] = (
    ("What words mean", ("alias",)),
    ("How things are done", ("procedure",)),
    ("What goes before and after", ("before", "after")),
    ("What to do when something happens", ("reaction",)),
    ("What follows from what", ("rule",)),
    ("What is so", ("fact",)),
    # In one group, in the order taught: where both apply, the newer one may decide.
    ("What is forbidden and what is allowed", ("prohibition", "permission")),
)
"""Headings of the file and the kinds below them, new words first."""

_SAID: Final = re.compile(r"you\s*(?:\(([^)]*)\))?\s*:\s*(.*)", re.IGNORECASE)
NOBODY: Final = "unknown"  # as in dialogue files


@dataclass(frozen=True, slots=True)
class Line:
    """A sentence of a file. number: counted from 1; speaker: None where the file does not say who."""

    number: int
    text: str
    speaker: str | None = None


class NotTextError(Exception):
    """The file holds no text. at: the line, counted from 1."""

    def __init__(self, at: int) -> None:
        super().__init__(f"line {at} is not text (UTF-8 is expected)")
        self.at = at


def written(rows: Iterable[Row], kinds: Sequence[str] = ()) -> Iterator[str]:
    """The file, line by line: lessons in force by group, each group in the order taught.

    Args:
        rows: lessons; what was taken back, and what the robot made by itself, is left out.
        kinds: of lessons; empty for all.
    """
    wanted = [row for row in rows if row.standing != "taken back"]
    wanted = [row for row in wanted if not kinds or row.kind in kinds]
    taught = [row for row in wanted if row.counts and not row.origins]
    yield f"# What this robot was taught: {len(taught)} lesson{'' if len(taught) == 1 else 's'}."
    yield "# To teach it again: sayso teach FILE. Lines that begin with # are for people."
    if own := sum(bool(row.origins) for row in wanted):
        yield f"# Left out: {own} that it made by itself, and will make again."
    for heading, group in GROUPS:
        if found := [row for row in taught if row.kind in group]:
            yield from ("", f"# {heading}", "")
            for row in found:
                yield from _lesson(row)
    if resting := [row for row in wanted if row.standing == "rests"]:
        yield from ("", "# Not in force: they rest", "")
        for row in resting:
            yield f"# {plain(row.words)} (rests: {plain(row.why)})"


def _lesson(row: Row) -> Iterator[str]:
    text = row.text
    same = text.casefold() == row.words.strip(" .").casefold()
    about = f"{plain(row.teacher).title() or 'Somebody'}, {when(row.at_s)}"
    yield f"# {about}" + ("" if same or not row.words else f": {plain(row.words)}")
    yield text


def read_lines(data: bytes) -> tuple[Line, ...]:
    """The sentences of a file: plain ones, and what persons say in a dialogue (`you: ...`, `you(Mary): ...`).

    Raises:
        NotTextError: it is none.
    """
    found = []
    for number, raw in enumerate(data.removeprefix(b"\xef\xbb\xbf").splitlines(), start=1):
        try:
            text = raw.decode("utf-8").strip()
        except UnicodeDecodeError as error:
            raise NotTextError(number) from error
        if "\0" in text:
            raise NotTextError(number)
        if not text or text.startswith("#"):
            continue
        if said := _SAID.fullmatch(text):
            name = said[1]
            speaker = name if name is None else name.strip().removeprefix(NOBODY)
            found.append(Line(number, said[2].strip(), speaker))
        else:
            found.append(Line(number, text))
    return tuple(found)


def when(at_s: float) -> str:
    """Local time to the minute: "2026-11-25 14:03"; "?" where none was noted."""
    return time.strftime("%Y-%m-%d %H:%M", time.localtime(at_s)) if at_s > 0 else "?"


def plain(text: str) -> str:
    """On one line, without what a terminal might act on."""
    return " ".join("".join(c if c.isprintable() else " " for c in text).split())
