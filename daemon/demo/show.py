"""The demonstration told live: what happens as lines, the robot's track drawn below them where there is a terminal."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Final, Self

from rich.console import Console, Group
from rich.live import Live
from rich.panel import Panel
from rich.text import Text

from daemon import events as ev
from daemon.closing import Closing
from daemon.demo.result import Result, table
from daemon.demo.track import Outline, box, colour, draw
from daemon.motion import Sample
from daemon.narration import entered, judged, told
from kernel.bodies.forklift.scene import Thing

REFRESH_HZ: Final = 8.0
COLUMNS: Final = 64
ROWS: Final = 14


class Show(Closing):
    """Args:
    console: where to; lines only, if it is no terminal.
    things: what stands in the world now.
    """

    def __init__(self, console: Console, things: Callable[[], Iterable[Thing]] = tuple) -> None:
        self._console = console
        self.things = things
        self._track: list[Sample] = []
        self._line = ""
        self._drawn_s = float("-inf")
        self._live = Live(console=console, auto_refresh=False, transient=True)

    def enter(self, text: str) -> None:
        """A line of the script begins."""
        self._line = text
        self._print(entered(text))

    def happen(self, event: ev.Event) -> None:
        """Something happened."""
        text = told(event)
        if text is not None:
            self._print(text)

    def move(self, sample: Sample) -> None:
        """The robot is here."""
        self._track.append(sample)
        if self._console.is_terminal and sample.t_s - self._drawn_s >= 1 / REFRESH_HZ:
            self._drawn_s = sample.t_s
            self._live.update(self.picture(), refresh=True)

    def judge(self, result: Result) -> None:
        """A line of the script has ended."""
        if result.misheard:
            heard = f'heard "{result.heard}"' if result.heard else "nothing was heard"
            self._print(Text(f"  MISHEARD: {heard}", style="red"))
        for outcome in result.outcomes:
            self._print(judged(outcome))

    def summary(self, results: Sequence[Result], seconds: float) -> Group:
        """The last word: every line, expected and actual, and the whole track."""
        held = sum(result.ok for result in results)
        verdict = f"{held} of {len(results)} lines went as expected, in {seconds:.0f} s"
        style = "bold green" if held == len(results) else "bold red"
        return Group(table(results), self.picture(), Text(verdict, style=style))

    def picture(self) -> Panel:
        """The track from above, and where the robot is."""
        outlines = [outline(thing) for thing in self.things()]
        track = draw(self._track, outlines, COLUMNS, ROWS)
        return Panel(Group(track, self._where()), title="from above", expand=False)

    def _print(self, text: Text) -> None:
        self._console.print(text, soft_wrap=not self._console.is_terminal)

    def _where(self) -> Text:
        if not self._track:
            return Text()
        here = self._track[-1]
        held = f", holds {here.held}" if here.held else ""
        place = (
            f"x {here.x_cm:.0f} cm, y {here.y_cm:.0f} cm, heading {here.heading_deg:.0f} degrees"
        )
        return Text(f"{here.t_s:.0f} s: {place}{held}", style="dim")

    def __enter__(self) -> Self:
        if self._console.is_terminal:
            self._live.start()
        return super().__enter__()

    def close(self) -> None:
        """Leave the last picture standing."""
        self._live.stop()


def outline(thing: Thing) -> Outline:
    """A thing as it is drawn."""
    corners = box(thing.x_cm, thing.y_cm, thing.turned_rad, thing.along_cm, thing.across_cm)
    return Outline(corners, colour(thing.colour))
