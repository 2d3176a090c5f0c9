"""The demonstration told on a terminal and into a file."""

import io

import pytest
from rich.console import Console

from daemon import events as ev
from daemon.acts import acts
from daemon.demo.result import Result
from daemon.demo.show import Show, outline
from daemon.dialogue import parse
from daemon.expectation import expectation
from daemon.judgement import Outcome
from daemon.motion import Sample
from kernel.bodies.forklift.scene import usual

ACT = acts(parse("you: hi\nrobot: lifts").steps)[0]
FAILED = Outcome(expectation("lifts"), False, ("lifts",), ("lowers",))


def drive(show: Show) -> None:
    with show:
        show.enter("you: hi")
        show.happen(ev.SayStarted(t=0.1, text="hello"))
        show.happen(ev.Noted(t=0.1, what="focus", text="unseen"))
        for i in range(20):
            show.move(Sample(i * 0.05, i, 0, 0, 0, 1000, "cup"))
        show.judge(Result(ACT, "you: hi", "high", True, (FAILED,)))


def test_a_file_gets_plain_lines_and_no_track_until_the_end() -> None:
    told = io.StringIO()
    show = Show(Console(file=told, width=100))
    drive(show)
    lines = told.getvalue()
    assert "hello" in lines
    assert "unseen" not in lines
    assert 'MISHEARD: heard "high"' in lines
    assert "+ happened: lowers" in lines
    assert "\x1b" not in lines
    assert "from above" not in lines


def test_a_terminal_sees_the_track_while_it_is_drawn(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "xterm")
    told = io.StringIO()
    show = Show(Console(file=told, width=100, force_terminal=True))
    drive(show)
    assert "from above" in told.getvalue()
    assert "holds cup" in told.getvalue()


def test_the_summary_counts_what_held() -> None:
    told = io.StringIO()
    console = Console(file=told, width=100)
    good = Result(ACT, "you: ho", "ho", False, ())
    bad = Result(ACT, "you: hi", "hi", False, (FAILED,))
    console.print(Show(console).summary([good, bad], 12.3))
    assert "1 of 2 lines went as expected, in 12 s" in told.getvalue()
    assert "FAIL" in told.getvalue()


def test_things_are_drawn_in_their_colour_and_size() -> None:
    drawn = outline(usual("block", "orange"))
    assert drawn.style == "dark_orange"
    xs = [x for x, _ in drawn.corners]
    assert max(xs) - min(xs) == 3.0
    assert outline(usual("wall")).style == "white"
