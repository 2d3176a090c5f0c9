"""Dialogue files: what a person says, what happens in the world, and what the robot is expected to do.

One line, one event (service.md). A file is parsed whole before anything is played, so a wrong line costs nothing but
its own message.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Final, Literal

from daemon.expectation import Expectation, expectation

Bearing = Literal["ahead", "left", "right", "behind"]

COLOURS: Final = frozenset({
    "red", "green", "blue", "yellow", "orange", "purple", "violet", "pink", "brown", "black", "white", "gray", "grey",
    "silver", "gold",
})  # fmt: skip
PERSONS: Final = frozenset(
    {"person", "man", "woman", "girl", "boy", "child", "baby", "guest", "visitor", "dog", "cat"}
)


class DialogueError(Exception):
    """A line of a dialogue file is not one of its forms, or names a file that is not there.

    Attributes:
        line: counted from 1; 0 for the file itself.
        text: the line as it stands.
        expected: what may stand there.
    """

    def __init__(self, line: int, text: str, expected: str, path: Path | None = None) -> None:
        place = f"{path}: " if path else ""
        place += f"line {line}: " if line else ""
        super().__init__(f"{place}{text!r}: expected {expected}")
        self.line, self.text, self.expected, self.path = line, text, expected, path


@dataclass(frozen=True, slots=True)
class You:
    """Somebody says it. speaker: who it is known to be, "" for not identified, None for nothing known anew."""

    line: int
    text: str
    speaker: str | None = None


@dataclass(frozen=True, slots=True)
class Audio:
    """Somebody says it, and this is the recording."""

    line: int
    path: Path


@dataclass(frozen=True, slots=True)
class Wait:
    """Time passes: so many seconds, or None for until nothing is active."""

    line: int
    seconds: float | None


@dataclass(frozen=True, slots=True)
class Thing:
    """What stands in the world. name "" and colour "" where none is given; low: under the range beam."""

    noun: str
    colour: str = ""
    name: str = ""
    low: bool = False


@dataclass(frozen=True, slots=True)
class Place:
    """Put a thing, or move the one that is there: distance_m from the robot's edge on that side (ahead: from the
    gripper's front). following: it keeps its place before the robot while the robot moves."""

    line: int
    thing: Thing
    distance_m: float
    bearing: Bearing
    following: bool = False


@dataclass(frozen=True, slots=True)
class Insert:
    """Put a thing between the fingers of the gripper."""

    line: int
    thing: Thing


@dataclass(frozen=True, slots=True)
class Remove:
    """Take away every thing nearer than this, or everything (None)."""

    line: int
    within_m: float | None


@dataclass(frozen=True, slots=True)
class Restart:
    """The store is kept, everything else is new."""

    line: int


@dataclass(frozen=True, slots=True)
class LinkSwitch:
    """The link to the robot is cut, or comes back."""

    line: int
    up: bool


@dataclass(frozen=True, slots=True)
class Expect:
    """What the robot is expected to have done since the last input line."""

    line: int
    expectation: Expectation


WorldStep = Place | Insert | Remove
Step = You | Audio | Wait | WorldStep | Restart | LinkSwitch | Expect


@dataclass(frozen=True, slots=True)
class Dialogue:
    """A parsed file: its steps in order, and their lines as they stand, by line number."""

    name: str
    steps: tuple[Step, ...]
    lines: dict[int, str]


_LINE: Final = re.compile(
    r"(?P<key>[A-Za-z]+)\s*(?:\((?P<name>[^)]*)\))?\s*:(?P<rest>.*)", re.DOTALL
)
_NUMBER: Final = r"(\d+(?:\.\d+)?)"
_WAIT: Final = re.compile(rf"{_NUMBER}\s*(?:s|sec|seconds?)")
_PLACE: Final = re.compile(
    rf"(.+?)\s+(?:at\s+)?{_NUMBER}\s*cm\s+(ahead|left|right|behind)(\s*,\s*following the robot)?"
)
_INSERT: Final = re.compile(r"(.+?)\s+between the fingers")
_NOTHING: Final = re.compile(rf"nothing within\s+{_NUMBER}\s*cm")

_EXPECTED_LINE: Final = (
    "you: TEXT, you(NAME): TEXT, audio: FILE.wav, wait: N s, wait: until idle, world: ..., restart:, "
    "link: down, link: up, robot: ..., a comment (# ...) or a blank line"
)
_EXPECTED_WORLD: Final = (
    "[low] [COLOUR] NOUN [NAME] [at] N cm ahead, left, right or behind [, following the robot]; "
    "[low] [COLOUR] NOUN [NAME] between the fingers; nothing within N cm; or clear"
)


def load(path: Path) -> Dialogue:
    """Read and parse a dialogue file.

    Raises:
        DialogueError: the file cannot be read or is not UTF-8, a line is wrong, or a recording is not there.
    """
    try:
        raw = path.read_bytes()
    except OSError as error:
        raise DialogueError(0, str(path), f"a readable file ({error.strerror})") from error
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw.count(b"\n", 0, error.start) + 1
        wrong = raw.splitlines()[line - 1].decode("utf-8", "backslashreplace")
        raise DialogueError(line, wrong, "UTF-8 text", path) from error
    try:
        dialogue = parse(text, name=path.stem, folder=path.parent)
    except DialogueError as error:
        raise DialogueError(error.line, error.text, error.expected, path) from None
    for step in dialogue.steps:
        if isinstance(step, Audio) and not step.path.is_file():
            wrong = dialogue.lines[step.line]
            raise DialogueError(step.line, wrong, f"a recording; there is no {step.path}", path)
    return dialogue


def parse(text: str, name: str = "dialogue", folder: Path = Path()) -> Dialogue:
    """Parse the text of a dialogue file; recordings are taken relative to folder.

    Raises:
        DialogueError: the first line that is none of the forms.
    """
    steps: list[Step] = []
    lines: dict[int, str] = {}
    for number, raw in enumerate(re.split(r"\r\n|\n|\r", text), start=1):
        stripped = raw.strip()
        if not stripped or stripped.startswith("#"):
            continue
        steps.append(_step(number, stripped, folder))
        lines[number] = stripped
    return Dialogue(name, tuple(steps), lines)


def _step(number: int, text: str, folder: Path) -> Step:
    match = _LINE.fullmatch(text)
    key = match["key"].lower() if match else ""
    rest = match["rest"].strip() if match else ""
    if match and key == "you":
        return _you(number, text, match["name"], rest)
    if match and match["name"] is None:
        if key == "audio" and rest.lower().endswith(".wav"):
            return Audio(number, folder / rest)
        if key in _READERS:
            return _READERS[key](number, text, rest)
    raise DialogueError(number, text, _EXPECTED_LINE)


def _you(number: int, text: str, name: str | None, rest: str) -> Step:
    if not rest:
        raise DialogueError(number, text, "what is said, after the colon")
    if name is None:
        return You(number, rest)
    speaker = " ".join(name.split()).lower()
    if not speaker:
        raise DialogueError(number, text, "you(NAME): or you(unknown):")
    return You(number, rest, "" if speaker == "unknown" else speaker)


def _wait(number: int, text: str, rest: str) -> Step:
    if " ".join(rest.split()) == "until idle":
        return Wait(number, None)
    match = _WAIT.fullmatch(rest)
    if match is None:
        raise DialogueError(number, text, "wait: N s, or wait: until idle")
    return Wait(number, float(match[1]))


def _restart(number: int, text: str, rest: str) -> Step:
    if rest:
        raise DialogueError(number, text, "restart: alone")
    return Restart(number)


def _link(number: int, text: str, rest: str) -> Step:
    if rest not in ("down", "up"):
        raise DialogueError(number, text, "link: down, or link: up")
    return LinkSwitch(number, rest == "up")


def _robot(number: int, text: str, rest: str) -> Step:
    if not rest:
        raise DialogueError(number, text, "what the robot does, after the colon")
    return Expect(number, expectation(rest))


def _world(number: int, text: str, rest: str) -> Step:
    if rest == "clear":
        return Remove(number, None)
    if match := _NOTHING.fullmatch(rest):
        return Remove(number, float(match[1]) / 100)
    if match := _INSERT.fullmatch(rest):
        return Insert(number, _thing(number, text, match[1]))
    if match := _PLACE.fullmatch(rest):
        bearing: Bearing = match[3]  # type: ignore[assignment]  # one of the four in the pattern
        thing = _thing(number, text, match[1])
        return Place(number, thing, float(match[2]) / 100, bearing, match[4] is not None)
    raise DialogueError(number, text, f"world: {_EXPECTED_WORLD}")


def _thing(number: int, text: str, words_text: str) -> Thing:
    """[low] [COLOUR] NOUN [NAME]; a name is written with a capital, or follows a word for a person."""
    words = words_text.split()
    if words and words[0].lower() in ("a", "an", "the"):
        words = words[1:]
    low = bool(words) and words[0].lower() == "low"
    words = words[low:]
    colour = words[0].lower() if words and words[0].lower() in COLOURS else ""
    words = words[bool(colour) :]
    name = ""
    if len(words) > 1 and (words[-1][0].isupper() or words[0].lower() in PERSONS):
        name = words.pop().lower()
    if not words or not all(re.fullmatch(r"[^\W\d_][\w'-]*", word) for word in words):
        raise DialogueError(number, text, f"world: {_EXPECTED_WORLD}")
    return Thing(" ".join(words).lower(), colour, name, low)


_READERS: Final[dict[str, Callable[[int, str, str], Step]]] = {
    "wait": _wait,
    "restart": _restart,
    "link": _link,
    "robot": _robot,
    "world": _world,
}
