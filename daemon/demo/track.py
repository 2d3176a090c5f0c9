"""The robot's track from above, drawn in the terminal: braille dots over rich, to scale in both directions.

(A plotting library was looked at first: plotext draws axes of unequal scale from one global figure, and drawille's
licence does not fit.)
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Final

from rich.text import Text

from daemon.motion import Sample

Point = tuple[float, float]

_DOTS: Final = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
BODY: Final[Sequence[Point]] = ((-7, -6), (3, -6), (3, 6), (-7, 6))  # the robot's outline, cm
FINGERS: Final = (((3.0, 3.2), (7.0, 3.2)), ((3.0, -3.2), (7.0, -3.2)))
COLOURS: Final = {
    "orange": "dark_orange",
    "purple": "magenta",
    "violet": "magenta",
    "pink": "hot_pink",
    "brown": "orange4",
    "black": "grey50",
    "gray": "grey70",
    "grey": "grey70",
    "silver": "grey82",
    "gold": "gold1",
}


@dataclass(frozen=True, slots=True)
class Outline:
    """A thing as it is drawn: its corners, cm, and a colour of rich."""

    corners: tuple[Point, ...]
    style: str = "white"


@dataclass(slots=True)
class Canvas:
    """Dots of braille, 2 x 4 a character. y grows upwards.

    Args:
        columns, rows: size in characters.
        left_cm, bottom_cm: the world's point at the lower left dot.
        cm: centimetres a dot, both ways.
    """

    columns: int
    rows: int
    left_cm: float
    bottom_cm: float
    cm: float
    _cells: dict[tuple[int, int], int] = field(default_factory=dict)
    _styles: dict[tuple[int, int], str] = field(default_factory=dict)

    def dot(self, point: Point, style: str) -> None:
        """Set a dot; outside the canvas there are none."""
        x = math.floor((point[0] - self.left_cm) / self.cm)
        y = self.rows * 4 - 1 - math.floor((point[1] - self.bottom_cm) / self.cm)
        if 0 <= x < self.columns * 2 and 0 <= y < self.rows * 4:
            cell = (x // 2, y // 4)
            self._cells[cell] = self._cells.get(cell, 0) | _DOTS[y % 4][x % 2]
            self._styles[cell] = style

    def line(self, start: Point, end: Point, style: str) -> None:
        """Set the dots between two points."""
        steps = max(1, math.ceil(math.dist(start, end) / self.cm))
        for i in range(steps + 1):
            part = i / steps
            self.dot(
                (start[0] + (end[0] - start[0]) * part, start[1] + (end[1] - start[1]) * part),
                style,
            )

    def text(self) -> Text:
        """The picture."""
        picture = Text(no_wrap=True)
        for row in range(self.rows):
            for column in range(self.columns):
                bits = self._cells.get((column, row), 0)
                picture.append(chr(0x2800 + bits), self._styles.get((column, row)))
            picture.append("\n" if row < self.rows - 1 else "")
        return picture


def draw(
    track: Sequence[Sample], things: Iterable[Outline], columns: int = 60, rows: int = 16
) -> Text:
    """Where the body has been, where it is, and what stands around it; everything fits."""
    outlines = list(things)
    points = [(s.x_cm, s.y_cm) for s in track] or [(0.0, 0.0)]
    for outline in outlines:
        points += outline.corners
    left, right = min(p[0] for p in points) - 12, max(p[0] for p in points) + 12
    bottom, top = min(p[1] for p in points) - 12, max(p[1] for p in points) + 12
    cm = max((right - left) / (columns * 2), (top - bottom) / (rows * 4))
    canvas = Canvas(
        columns,
        rows,
        (left + right) / 2 - cm * columns,
        (bottom + top) / 2 - cm * rows * 2,
        cm,
    )
    for before, after in pairwise(track):
        canvas.line((before.x_cm, before.y_cm), (after.x_cm, after.y_cm), "cyan")
    for outline in outlines:
        for start, end in _edges(outline.corners):
            canvas.line(start, end, outline.style)
    if track:
        for start, end in (*_edges(BODY), *FINGERS):
            canvas.line(_there(track[-1], start), _there(track[-1], end), "bold yellow")
    return canvas.text()


def box(
    x_cm: float, y_cm: float, turned_rad: float, along_cm: float, across_cm: float
) -> tuple[Point, ...]:
    """The corners of a rectangle."""
    cos, sin = math.cos(turned_rad), math.sin(turned_rad)
    halves = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    corners = [(along_cm / 2 * a, across_cm / 2 * b) for a, b in halves]
    return tuple((x_cm + x * cos - y * sin, y_cm + x * sin + y * cos) for x, y in corners)


def colour(name: str | None) -> str:
    """A colour of rich for a colour of the world."""
    return COLOURS.get(name, name) if name else "white"


def _edges(corners: Sequence[Point]) -> Iterator[tuple[Point, Point]]:
    return zip(corners, (*corners[1:], corners[0]), strict=True)


def _there(body: Sample, point: Point) -> Point:
    """A point of the body's frame in the world."""
    cos, sin = math.cos(math.radians(body.heading_deg)), math.sin(math.radians(body.heading_deg))
    return body.x_cm + point[0] * cos - point[1] * sin, body.y_cm + point[0] * sin + point[1] * cos
