"""What a line of the demonstration came to."""

import pytest

from daemon import events as ev
from daemon.acts import Act, acts
from daemon.demo.result import result, same, table
from daemon.dialogue import parse
from daemon.judgement import Turn
from grammars.vocabulary import BORN


def act(text: str) -> Act:
    return acts(parse(text).steps)[0]


def heard(*texts: str) -> Turn:
    return Turn(tuple(ev.Heard(t=0.1, text=text) for text in texts), (), 0.0, 1.0)


@pytest.mark.parametrize(
    ("said", "heard", "expected"),
    [
        ("drive forward", "Drive forward.", True),
        ("drive forward", "drive forwards", True),
        ("drive forward", "drive backward", False),
        ("drive forward", "", False),
        ("To shimmy turn left then turn right", "to shimmy turn left and turn right", False),
        ("zork the florble", "florble the zork", False),
    ],
)
def test_what_is_heard_must_mean_what_was_said(said: str, heard: str, expected: bool) -> None:
    assert same(said, heard, BORN) is expected


def test_a_line_misheard_fails_though_nothing_else_was_expected() -> None:
    line = act("you: drive forward")
    assert result(line, "you: drive forward", heard("drive forward"), BORN).ok
    assert not result(line, "you: drive forward", heard("drive backward"), BORN).ok
    assert not result(line, "you: drive forward", heard(), BORN).ok
    assert not result(line, "you: drive forward", heard("drive forward", "stop"), BORN).ok


def test_a_line_of_the_world_is_not_heard() -> None:
    assert result(act("world: clear\nrobot: does not move"), "world: clear", heard(), BORN).ok


def test_a_failed_expectation_fails_the_line() -> None:
    line = act("you: drive forward\nrobot: waves\nrobot: lifts")
    found = result(line, "you: drive forward", heard("drive forward"), BORN)
    assert not found.ok
    assert [outcome.ok for outcome in found.outcomes] == [True, False]


def test_the_table_has_a_row_for_every_line() -> None:
    lines = [act("you: drive forward"), act("world: clear\nrobot: lifts")]
    assert table(result(line, "x", heard("drive forward"), BORN) for line in lines).row_count == 2
