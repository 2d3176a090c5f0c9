"""`sayso log`: the journal on the screen, and what the running daemon does."""

from __future__ import annotations

import json
import time
from collections.abc import Sequence

import click
import msgspec

from daemon.control import messages
from daemon.control.client import Client
from daemon.control.report import line
from daemon.lessonfile import plain
from daemon.logbook import Entry


def show(entries: Sequence[Entry], *, as_json: bool) -> None:
    """Entries, oldest first."""
    for entry in entries:
        click.echo(
            json.dumps(msgspec.to_builtins(entry), ensure_ascii=False) if as_json else told(entry)
        )
    if not entries and not as_json:
        click.echo("nothing was said yet", err=True)


def told(entry: Entry) -> str:
    """An entry as a line."""
    at = time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(entry.at_s))
    about = f"{entry.lesson}: {entry.text}" if entry.lesson else entry.text
    match entry.what:
        case "said":
            more = f"({entry.kind})"
        case "adapted":
            more = f"({entry.before:.2f} to {entry.after:.2f})"
        case "learned":
            more = f"({entry.kind}{', ' if entry.source else ''}{entry.source})"
        case _:
            more = ""
    return (
        f"{at}  {plain(entry.who).title() or '-':<8} {entry.what:<9} {plain(about)} {more}".rstrip()
    )


def follow(client: Client, *, as_json: bool) -> None:
    """Print every event of the running daemon until Ctrl-C, or until it ends.

    Raises:
        ControlError: it ended.
    """
    try:
        with client:
            for answer in client.ask(messages.Watch(v=1)):
                if isinstance(answer, messages.Happened):
                    _follow(answer, as_json=as_json)
    except KeyboardInterrupt:
        return


def _follow(answer: messages.Happened, *, as_json: bool) -> None:
    if as_json:
        click.echo(json.dumps(answer.event, ensure_ascii=False))
    elif (shown := line(answer.event)) is not None:
        click.echo(f"{time.strftime('%Y-%m-%d %H:%M:%S')}  {shown}")
