"""`sayso teach`: a file is read whole, then taught line by line."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from daemon.control import common
from daemon.control.reach import Reach
from daemon.lessonfile import Line, NotTextError, read_lines
from daemon.teaching import Plan, plan


def teach(file: Path, speaker: str, config_file: Path | None, *, dry_run: bool) -> int:
    """Teach a file; the exit status.

    Raises:
        ClickException: the file cannot be read, or is no text.
    """
    try:
        data = sys.stdin.buffer.read() if str(file) == "-" else file.read_bytes()
        lines = read_lines(data)
    except OSError as error:
        raise click.ClickException(f"{file} cannot be read ({error.strerror})") from error
    except NotTextError as error:
        raise click.ClickException(f"{file}: {error}") from error
    with common.reached(config_file) as robot:
        planned = plan(lines, robot.lessons())
        for wrong in planned.wrong:
            click.echo(f"{file}:{wrong.line.number}: {wrong.line.text!r}: {wrong.why}", err=True)
        if planned.wrong:
            count = len(planned.wrong)
            click.echo(
                f"nothing was taught: {count} wrong line{'' if count == 1 else 's'}", err=True
            )
            return common.EXIT_NOT_UNDERSTOOD
        if dry_run:
            for line, lessons in planned.new:
                click.echo(f"{file}:{line.number}: {lessons[0].kind}: {line.text}")
            click.echo(
                f"{len(planned.new)} new, {len(planned.known)} known already; nothing was taught"
            )
            return 0
        return _teach(robot, planned, speaker, file)


def _teach(robot: Reach, planned: Plan, speaker: str, file: Path) -> int:
    """Say them one after another, showing how far it is; the exit status."""
    from rich.progress import Progress

    learned = told = 0
    refused: list[tuple[Line, str]] = []
    doubtful: list[tuple[Line, str]] = []
    with Progress(transient=True, disable=not sys.stderr.isatty()) as progress:
        task = progress.add_task("learning", total=len(planned.new))
        for line, _ in planned.new:
            came = _Came()
            who = speaker if line.speaker is None else line.speaker
            outcome = robot.say(line.text, who, came.see, aloud=False)
            if came.asked:  # whoever wrote the file wants it, as whoever was asked then kept it
                doubtful.append((line, came.reply))
                outcome = robot.say("keep both", who, came.see, aloud=False)
            learned += came.learned
            told += came.noted and not came.learned
            if outcome != "done" or not (came.learned or came.noted):
                refused.append((line, came.reply or outcome))
            progress.advance(task)
    for line, why in doubtful:
        doubt, _, _ = why.partition(" Shall I")
        click.echo(f"{file}:{line.number}: {line.text!r}: kept all the same: {doubt}", err=True)
    for line, why in refused:
        click.echo(f"{file}:{line.number}: {line.text!r}: not learned: {why}", err=True)
    parts = [f"{learned} new", f"{len(planned.known)} known already"]
    if told:
        until = "until the daemon ends" if robot.live else "and forgotten with this command"
        parts.append(f"{told} fact{'' if told == 1 else 's'} noted {until}")
    parts += [f"{len(refused)} not learned"] if refused else []
    click.echo(", ".join(parts))
    return common.EXIT_FAILED if refused else 0


class _Came:
    """What came of one sentence."""

    def __init__(self) -> None:
        self.learned = self.noted = self.asked = False
        self.reply = ""

    def see(self, event: Mapping[str, Any]) -> None:
        """Take an event into account."""
        match event:
            case {"event": "lesson"}:
                self.learned = True
            case {"event": "question"}:
                self.asked = True
            case {"event": "replied", "shown": shown, "kind": kind}:
                self.noted = self.noted or kind == "FactTaken"
                self.reply = shown
            case {"event": "not_understood" | "error" as kind, **more}:
                self.reply = str(more.get("reason") or more.get("text") or kind)
