"""Scenes: what stands where in the simulated world, written by a user as TOML.

[robot]                 # optional; where it starts
x_cm = 0
y_cm = 0
heading_deg = 0         # counterclockwise from x

[[thing]]               # any number
noun = "block"
colour = "red"          # optional, as are name and low
x_cm = 40               # its centre
y_cm = 0
size_cm = 3             # or [along, across]; optional, the noun has a usual size
turned_deg = 0
low = false             # under the rangefinder's beam

[[wall]]
from_cm = [100, -50]
to_cm = [100, 50]
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from kernel.errors import KernelError

USUAL_CM: Mapping[str, tuple[float, float]] = {
    "wall": (2.0, 60.0),
    "block": (3.0, 3.0),
    "cube": (3.0, 3.0),
    "brick": (3.0, 5.0),
    "cup": (4.0, 4.0),
    "ball": (4.0, 4.0),
    "pill": (2.0, 2.0),
    "bottle": (4.0, 4.0),
    "can": (4.0, 4.0),
    "box": (8.0, 8.0),
    "sneaker": (5.0, 12.0),
    "table": (20.0, 30.0),
    "chair": (15.0, 15.0),
    "person": (16.0, 16.0),
    "man": (16.0, 16.0),
    "woman": (16.0, 16.0),
    "girl": (12.0, 12.0),
    "boy": (12.0, 12.0),
}
OTHER_CM = (4.0, 4.0)
ROUND = frozenset({"cup", "ball", "bottle", "can", "person", "man", "woman", "girl", "boy"})
FIXED = frozenset({"wall", "table", "chair", "person", "man", "woman", "girl", "boy"})
WALL_THICKNESS_CM = 2.0


class SceneError(KernelError):
    """A scene cannot be read; where names the entry, problem what is wrong with it."""

    def __init__(self, where: str, problem: str) -> None:
        super().__init__(f"{where}: {problem}")
        self.where, self.problem = where, problem


@dataclass(frozen=True, slots=True)
class Thing:
    """One thing in the world; the centre in cm, turned counterclockwise in radians. Sizes: along x, along y."""

    noun: str
    colour: str | None = None
    name: str | None = None
    low: bool = False
    x_cm: float = 0.0
    y_cm: float = 0.0
    turned_rad: float = 0.0
    along_cm: float = OTHER_CM[0]
    across_cm: float = OTHER_CM[1]

    @property
    def round(self) -> bool:
        """A circle from above, as wide as it is long."""
        return self.noun in ROUND

    @property
    def fixed(self) -> bool:
        """Does not yield when it is pushed."""
        return self.noun in FIXED

    def could_be(self, other: Thing) -> bool:
        """Whether both descriptions may mean the same thing: nothing they both state differs."""
        return (
            self.noun == other.noun
            and (None in (self.colour, other.colour) or self.colour == other.colour)
            and (None in (self.name, other.name) or self.name == other.name)
        )


@dataclass(frozen=True, slots=True)
class Scene:
    """Where the robot starts and what stands around it."""

    x_cm: float = 0.0
    y_cm: float = 0.0
    heading_rad: float = 0.0
    things: tuple[Thing, ...] = ()


@dataclass(frozen=True, slots=True)
class Truth:
    """Where the robot really is; for judging and drawing only, the body never sees it."""

    x_cm: float
    y_cm: float
    heading_rad: float
    lift: float
    grip: float
    holding: Thing | None
    range_cm: float | None


def usual(
    noun: str, colour: str | None = None, name: str | None = None, low: bool = False
) -> Thing:
    """A thing of the size its noun usually has, at the origin."""
    along, across = USUAL_CM.get(noun, OTHER_CM)
    return Thing(noun, colour, name, low, along_cm=along, across_cm=across)


def read(text: str) -> Scene:
    """The scene a TOML text describes; see the module for the form.

    Raises:
        SceneError: no TOML, an unknown key, a missing one, or a value of the wrong kind.
    """
    try:
        table = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise SceneError("scene", str(error)) from error
    _only(table, "scene", ("robot", "thing", "wall"))
    robot = table.get("robot", {})
    if not isinstance(robot, dict):
        raise SceneError("robot", "expected a table")
    _only(robot, "robot", ("x_cm", "y_cm", "heading_deg"))
    things = [_thing(entry, where) for entry, where in _entries(table, "thing")]
    walls = [_wall(entry, where) for entry, where in _entries(table, "wall")]
    return Scene(
        _number(robot, "robot", "x_cm", 0.0),
        _number(robot, "robot", "y_cm", 0.0),
        math.radians(_number(robot, "robot", "heading_deg", 0.0)),
        tuple(things + walls),
    )


def _entries(table: Mapping[str, object], kind: str) -> list[tuple[dict[str, object], str]]:
    entries = table.get(kind, [])
    if not isinstance(entries, list) or not all(isinstance(entry, dict) for entry in entries):
        raise SceneError(kind, f"expected [[{kind}]] tables")
    return [(entry, f"{kind} {number}") for number, entry in enumerate(entries, 1)]


def _thing(entry: Mapping[str, object], where: str) -> Thing:
    known = ("noun", "colour", "name", "low", "x_cm", "y_cm", "size_cm", "turned_deg")
    _only(entry, where, known)
    for key in ("noun", "x_cm", "y_cm"):
        if key not in entry:
            raise SceneError(where, f"{key} is missing")
    noun = _text(entry, where, "noun") or ""
    low = entry.get("low", False)
    if not isinstance(low, bool):
        raise SceneError(where, "low: expected true or false")
    thing = usual(noun, _text(entry, where, "colour"), _text(entry, where, "name"), low)
    along, across = _size(entry, where, (thing.along_cm, thing.across_cm))
    return replace(
        thing,
        x_cm=_number(entry, where, "x_cm", 0.0),
        y_cm=_number(entry, where, "y_cm", 0.0),
        turned_rad=math.radians(_number(entry, where, "turned_deg", 0.0)),
        along_cm=along,
        across_cm=across,
    )


def _wall(entry: Mapping[str, object], where: str) -> Thing:
    _only(entry, where, ("from_cm", "to_cm"))
    (ax, ay), (bx, by) = _pair(entry, where, "from_cm"), _pair(entry, where, "to_cm")
    length = math.hypot(bx - ax, by - ay)
    if length == 0:
        raise SceneError(where, "from_cm and to_cm are the same")
    return Thing(
        "wall",
        x_cm=(ax + bx) / 2,
        y_cm=(ay + by) / 2,
        turned_rad=math.atan2(by - ay, bx - ax) - math.pi / 2,
        along_cm=WALL_THICKNESS_CM,
        across_cm=length,
    )


def _only(table: Mapping[str, object], where: str, known: Sequence[str]) -> None:
    for key in table:
        if key not in known:
            raise SceneError(where, f"unknown key {key}; known are {', '.join(known)}")


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def _number(table: Mapping[str, object], where: str, key: str, default: float) -> float:
    value = table.get(key, default)
    if not _is_number(value):
        raise SceneError(where, f"{key}: expected a number")
    return float(value)  # type: ignore[arg-type]


def _text(table: Mapping[str, object], where: str, key: str) -> str | None:
    value = table.get(key)
    if value is not None and (not isinstance(value, str) or not value.strip()):
        raise SceneError(where, f"{key}: expected a word")
    return value


def _pair(table: Mapping[str, object], where: str, key: str) -> tuple[float, float]:
    value = table.get(key)
    if not isinstance(value, list) or len(value) != 2 or not all(map(_is_number, value)):
        raise SceneError(where, f"{key}: expected two numbers, [x, y]")
    return float(value[0]), float(value[1])


def _size(
    table: Mapping[str, object], where: str, usual_cm: tuple[float, float]
) -> tuple[float, float]:
    value = table.get("size_cm")
    if value is None:
        return usual_cm
    if _is_number(value):
        value = [value, value]
    size = _pair({"size_cm": value}, where, "size_cm")
    if min(size) <= 0 or max(size) > 1000:
        raise SceneError(where, "size_cm: expected more than 0, at most 1000")
    return size
