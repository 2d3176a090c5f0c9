"""What the commands of the command line share: options, the running daemon, one utterance said and followed."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import click

if TYPE_CHECKING:
    from daemon.config import Config
    from daemon.control.client import Client
    from daemon.control.reach import Reach

EXIT_FAILED: Final = 1
EXIT_USAGE: Final = 2
EXIT_NOT_UNDERSTOOD: Final = 3

config_option = click.option(
    "--config",
    "config_file",
    type=click.Path(dir_okay=False, path_type=Path),
    help="Configuration (default: ~/.config/sayso/sayso.toml where it exists).",
)
speaker_option = click.option(
    "--speaker", default="", metavar="NAME", help="Who says it (default: whoever spoke last)."
)


def config(path: Path | None) -> Config:
    """The configuration.

    Raises:
        ConfigError: the file is wrong.
    """
    from daemon.config import load

    return load(path)


def reached(config_file: Path | None) -> Reach:
    """The robot: of the running daemon, or one made here. Use as a context."""
    from daemon.control.reach import reach

    return reach(config(config_file))


def running(config_file: Path | None, *, patient: bool = False) -> Client:
    """A connection to the running daemon. patient: it may be silent for as long as it likes.

    Raises:
        ClickException: none runs.
    """
    from daemon.config import socket_path
    from daemon.control.client import ANSWER_S, Client

    try:
        return Client(socket_path(config(config_file)), None if patient else ANSWER_S)
    except (FileNotFoundError, ConnectionRefusedError):
        raise click.ClickException("no daemon runs (start it with: sayso run)") from None


def status(outcome: str) -> int:
    """The exit status of what an utterance came to."""
    from daemon.outcome import EXIT_STATUS

    if outcome == "running":
        click.echo("still going on")
    return EXIT_STATUS[outcome]


def show(event: Mapping[str, Any]) -> None:
    """Print an event where a person need see it."""
    from daemon.control.report import line

    if (shown := line(event)) is not None:
        click.echo(shown)


def text_argument(text: str) -> str:
    """A sentence given as an argument.

    Raises:
        UsageError: there is none, or it is too long.
    """
    from daemon.control.messages import TEXT_LENGTH

    if not text.strip() or len(text) > TEXT_LENGTH:
        raise click.UsageError(f"TEXT must have 1 to {TEXT_LENGTH} characters")
    return clean(text)


def sentences() -> Iterator[str]:
    """Lines of standard input; what is not UTF-8 becomes a mark that no word contains."""
    for raw in sys.stdin.buffer:
        yield raw.rstrip(b"\r\n").decode("utf-8", errors="replace")


def clean(text: str) -> str:
    """Arguments that were not UTF-8 arrive as lone surrogates, which nothing can print."""
    return text.encode("utf-8", errors="replace").decode("utf-8")
