"""`sayso talk`: a console on the robot; from a pipe, one sentence after another."""

from __future__ import annotations

import asyncio
import sys
from pathlib import Path

import click

from daemon.control import common
from daemon.control.reach import Reach, ReachError, See, reach

HELP = """Type what you would say to the robot. Also:
  /lessons [WORDS]   what it was taught, with numbers     /forget N...   take lessons back
  /speaker [NAME]    who is speaking                      /help          this
  /stop, Ctrl-C      emergency stop                       /quit, Ctrl-D  leave"""


def talk(speaker: str, config_file: Path | None) -> int:
    """Talk until the end; the exit status."""
    config = common.config(config_file)
    if not (sys.stdin.isatty() and sys.stdout.isatty()):
        with reach(config) as robot:
            return _piped(robot, speaker)
    from daemon.control.console import converse

    return asyncio.run(converse(config, speaker))


def _piped(robot: Reach, speaker: str) -> int:
    """Each line of standard input, one after another; the status of the last."""
    status = 0
    for text in common.sentences():
        if not text.strip():
            continue
        command, _, rest = text.strip().partition(" ")
        if command == "/quit":
            break
        if command == "/speaker":
            speaker = rest.strip()
        elif command.startswith("/"):
            status = slash(robot, command, rest, speaker)
        else:
            status = common.status(robot.say(text, speaker, common.show))
    return status


def slash(robot: Reach, command: str, rest: str, speaker: str, show: See = common.show) -> int:
    """Do a command that only asks or takes back, and print what comes of it; the exit status."""
    match command:
        case "/help":
            click.echo(HELP)
        case "/lessons":
            from daemon.control import listing

            rows = robot.lessons()
            chosen = listing.choose(rows, rest, everything=False)
            listing.show(rows, chosen, everything=False, filtered=bool(rest), bare=True)
        case "/forget" if rest and all(n.isascii() and n.isdigit() for n in rest.split()):
            try:
                numbers = tuple(dict.fromkeys(map(int, rest.split())))
                return common.status(robot.forget(numbers, speaker, show))
            except ReachError as error:
                click.echo(str(error), err=True)
                return common.EXIT_FAILED
        case "/stop":
            return common.status(robot.say("stop", speaker, show))
        case _:
            click.echo(
                f"{command}: no such command, or it wants something else; /help tells", err=True
            )
            return common.EXIT_USAGE
    return 0
