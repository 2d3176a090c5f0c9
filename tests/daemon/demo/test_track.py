"""The picture of the track."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from daemon.demo.track import BODY, Canvas, Outline, box, draw
from daemon.motion import Sample


def at(x_cm: float, y_cm: float, heading_deg: float = 0) -> Sample:
    return Sample(0, x_cm, y_cm, heading_deg, 0, 0)


def test_a_dot_is_where_its_point_is() -> None:
    canvas = Canvas(2, 1, 0, 0, 1)
    canvas.dot((0, 3), "red")  # the upper left dot of the first character
    canvas.dot((3.5, 0), "red")  # the lower right dot of the second
    canvas.dot((4, 0), "red")  # outside
    assert canvas.text().plain == "\u2801\u2880"


def test_a_line_has_no_gaps() -> None:
    canvas = Canvas(5, 1, 0, 0, 1)
    canvas.line((0, 0), (9, 0), "red")
    assert canvas.text().plain == "\u28c0" * 5


def test_the_picture_has_the_size_asked_for() -> None:
    picture = draw([at(0, 0), at(20, 0)], [], columns=30, rows=8)
    assert [len(row) for row in picture.plain.split("\n")] == [30] * 8


def test_a_straight_track_runs_along_one_row_from_tail_to_robot() -> None:
    picture = draw([at(-100, 0), at(0, 0)], [], columns=40, rows=9).plain.split("\n")
    inked = [[c != "\u2800" for c in row] for row in picture]
    tail = [row for row in range(9) if any(inked[row][:20])]
    assert len(tail) == 1
    assert sum(map(sum, inked)) > sum(inked[tail[0]])  # the robot is wider than its track


def test_nothing_at_all_can_be_drawn() -> None:
    assert set(draw([], []).plain) == {"\u2800", "\n"}


def test_things_keep_their_colour() -> None:
    picture = draw([], [Outline(box(0, 0, 0, 10, 10), "red")])
    assert {str(span.style) for span in picture.spans} == {"red"}


@given(st.floats(-300, 300), st.floats(-300, 300), st.floats(0, 7))
def test_a_box_keeps_its_sides(x: float, y: float, turned: float) -> None:
    a, b, c, d = box(x, y, turned, 2, 60)
    assert math.dist(a, b) == pytest.approx(2)
    assert math.dist(b, c) == pytest.approx(60)
    assert math.dist(a, c) == pytest.approx(math.dist(b, d))


def test_the_body_has_the_forklifts_measures() -> None:
    assert math.dist(BODY[1], BODY[2]) == 12
