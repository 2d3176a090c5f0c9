"""Events told to whoever watches: one line each, or none. What is heard, understood, decided and said."""

from __future__ import annotations

from typing import Final

from rich.text import Text

from daemon import events as ev
from daemon.judgement import Outcome

STYLES: Final = {
    "heard": "bold",
    "means": "green",
    "does": "cyan",
    "done": "cyan",
    "says": "bold magenta",
    "asks": "bold magenta",
    "shows": "magenta",
    "learned": "green",
    "vetoed": "bold red",
    "stop": "bold red",
    "error": "bold red",
    "not heard": "yellow",
    "link": "dim",
}


def told(event: ev.Event) -> Text | None:
    """The line of an event; None where there is nothing to tell."""
    match event:
        case ev.Heard(text=text, speaker=speaker, confidence=confidence):
            doubt = "" if confidence == 1 else f"  ({confidence:.2f})"
            return _line(event, "heard", f"{text}{f'  [{speaker}]' if speaker else ''}{doubt}")
        case ev.Understood(readback=readback, kind=kind):
            return _line(event, "means", f"{readback}  ({kind})")
        case ev.NotUnderstood(text=text, reason=reason):
            return _line(event, "not heard", f"{text}: {reason}" if text else reason)
        case ev.Lesson(ident=ident, readback=readback):
            return _line(event, "learned", f"#{ident} {readback}")
        case ev.ActionStarted(function=function, words=words):
            return _line(event, "does", " ".join((function, *words)))
        case ev.ActionEnded(function=function, verdict=verdict):
            return _line(event, "done", f"{function} {verdict}")
        case ev.Prohibited(by=by):
            return _line(event, "vetoed", f"by: {by}")
        case ev.SayStarted(text=text):
            return _line(event, "says", f'"{text}"')
        case ev.Question(text=text):
            return _line(event, "asks", text)
        case ev.Stopped(source=source):
            return _line(event, "stop", source)
        case ev.Link(up=up, detail=detail):
            return _line(event, "link", f"{'up' if up else 'down'} {detail}".strip())
        case ev.Error(part=part, text=text):
            return _line(event, "error", f"{part}: {text}")
        case _:
            return None


def entered(line: str) -> Text:
    """A line of the dialogue file, as its turn begins."""
    return Text(f"\n> {line}", style="bold blue")


def judged(outcome: Outcome) -> Text:
    """An expectation, checked; with a diff where it failed."""
    if not outcome.expectation.checked:
        return Text(f"  ({outcome.expectation.text})", style="dim")
    if outcome.ok:
        return Text.assemble(("  as expected: ", "green"), outcome.expectation.text)
    return Text(
        f"  not as expected\n  {outcome.diff().replace(chr(10), chr(10) + '  ')}", style="red"
    )


def _line(event: ev.Event, word: str, text: str) -> Text:
    return Text.assemble(f"{event.t:7.2f} s  ", (f"{word:>9}", STYLES[word]), f"  {text}")
