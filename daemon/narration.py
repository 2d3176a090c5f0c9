"""A dialogue told to whoever watches: its lines, the events of each turn, and whether it went as expected."""

from __future__ import annotations

from typing import Final

from rich.text import Text

from daemon import events as ev
from daemon.control.report import line
from daemon.judgement import Outcome

STYLES: Final = {
    "heard": "bold",
    "understood": "green",
    "unclear": "yellow",
    "doing": "cyan",
    "done": "cyan",
    "said": "bold magenta",
    "shown": "green",
    "forbidden": "bold red",
    "stopped": "bold red",
    "error": "bold red",
}


def told(event: ev.Event) -> Text | None:
    """An event with its time; None where there is nothing to tell."""
    shown = line(ev.as_dict(event))
    if shown is None:
        return None
    label, _, rest = shown.partition(" ")
    time = (f"{event.t:7.2f} s  ", "dim")
    return Text.assemble(time, (f"{label:<11}", STYLES.get(label, "")), rest.strip())


def entered(text: str) -> Text:
    """A line of the dialogue file, as its turn begins."""
    return Text(f"\n{text}", style="bold blue")


def judged(outcome: Outcome) -> Text:
    """A `robot:` line and whether it held; with a diff where it did not."""
    wanted = outcome.expectation
    if not outcome.ok:
        diff = "\n".join(f"    {row}" for row in outcome.diff().splitlines())
        return Text(f"  FAILED: {wanted.text}\n{diff}", style="red")
    if not wanted.checked:
        return Text(f"  not checked: {wanted.text}", style="dim")
    return Text.assemble(("  as expected: ", "green"), (wanted.text, "dim"))
