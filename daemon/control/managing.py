"""Commands for what was taught: list, take back, write out, learn again, ask, look back.

What a command needs is imported when it runs (daemon/control/cli.py).
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Final

import click

from daemon.control import common

KINDS: Final = (
    *("procedure", "reaction", "before", "after", "prohibition", "permission"),
    *("rule", "alias", "fact"),
)


@click.command(short_help="What the robot was taught, with numbers.")
@click.argument("text", nargs=-1)
@click.option(
    "--all", "everything", is_flag=True, help="Also those taken back, and those that rest."
)
@click.option(
    "--recheck", is_flag=True, help="Only those whose words would mean something else now."
)
@click.option("--json", "as_json", is_flag=True, help="Print JSON objects, one a lesson.")
@common.config_option
def lessons(
    text: tuple[str, ...], everything: bool, recheck: bool, as_json: bool, config_file: Path | None
) -> None:
    """What the robot was taught, with the numbers that `sayso forget` takes; only lessons with the words of TEXT.

    \b
    sayso lessons                  all in force
    sayso lessons grab person      those about grabbing persons
    """
    from daemon.control import listing

    with common.reached(config_file) as robot:
        rows = robot.lessons()
    chosen = listing.choose(rows, " ".join(text), everything=everything)
    if recheck:
        listing.show_changed(rows, chosen, as_json=as_json)
    elif as_json:
        listing.as_json(chosen)
    else:
        listing.show(rows, chosen, everything=everything, filtered=bool(text))


@click.command(
    short_help="Take lessons back, by number or in words.",
    context_settings={"ignore_unknown_options": True},  # -1 is a number, if a wrong one
)
@click.argument("what", nargs=-1, required=True, metavar="N...|TEXT")
@common.speaker_option
@common.config_option
def forget(what: tuple[str, ...], speaker: str, config_file: Path | None) -> None:
    """Take lessons back: by their numbers in `sayso lessons`, or by what they are about.

    \b
    sayso forget 3 5
    sayso forget how to dance

    Where a number is wrong nothing is changed. `sayso undo` brings back what was forgotten.
    """
    numbers = _numbers(what)
    said = common.text_argument(" ".join(what))
    if said.lower().split()[0] != "forget":
        said = f"forget {said}"
    with common.reached(config_file) as robot:
        if numbers:
            sys.exit(common.status(robot.forget(numbers, speaker, common.show)))
        sys.exit(common.status(robot.say(said, speaker, common.show)))


def _numbers(what: tuple[str, ...]) -> tuple[int, ...]:
    """The numbers given, once each; none where something else was given.

    Raises:
        UsageError: too many, or no number of a lesson.
    """
    from daemon.control.messages import FORGET_AT_ONCE

    for word in what:
        if word.startswith("-") or (word.isascii() and word.isdigit() and int(word[:18]) == 0):
            raise click.UsageError(f"{word} is no number of a lesson: they begin with 1")
    if not all(word.isascii() and word.isdigit() for word in what):
        return ()
    if len(what) > FORGET_AT_ONCE or any(len(word) > 18 for word in what):
        raise click.UsageError(
            f"at most {FORGET_AT_ONCE} numbers, each as `sayso lessons` shows it"
        )
    return tuple(dict.fromkeys(map(int, what)))


@click.command(short_help="Take the last change of what was taught back.")
@click.option("--today", is_flag=True, help="Everything that was taught or changed today.")
@common.speaker_option
@common.config_option
def undo(today: bool, speaker: str, config_file: Path | None) -> None:
    """Take the last change of what was taught back; an undo can be undone as well."""
    said = "undo everything from today" if today else "undo that"
    with common.reached(config_file) as robot:
        sys.exit(common.status(robot.say(said, speaker, common.show)))


@click.command(short_help="Why the robot did what it did last.")
@click.argument("text", nargs=-1)
@common.speaker_option
@common.config_option
def why(text: tuple[str, ...], speaker: str, config_file: Path | None) -> None:
    """Why the robot did what it did last; or the question TEXT.

    \b
    sayso why
    sayso why "why did you not grab Mary"
    """
    said = common.text_argument(" ".join(text) or "why did you do that")
    if not said.lower().startswith(("why", "how", "what", "who", "when", "which", "where")):
        said = f"why {said}"
    with common.reached(config_file) as robot:
        sys.exit(common.status(robot.say(said, speaker, common.show)))


@click.command(short_help="Write what was taught as readable English.")
@click.argument(
    "file", default="-", type=click.Path(dir_okay=False, path_type=Path, allow_dash=True)
)
@click.option(
    "--kind",
    "kinds",
    multiple=True,
    type=click.Choice(KINDS),
    help="Only of this kind; may be repeated.",
)
@click.option("--force", is_flag=True, help="Write over FILE.")
@common.config_option
def export(file: Path, kinds: tuple[str, ...], force: bool, config_file: Path | None) -> None:
    """Write what was taught as readable English, one lesson a line; `sayso teach FILE` learns it again.

    Without FILE it is printed. Comments say who taught it, when, and in which words.
    """
    from daemon.lessonfile import written

    if str(file) != "-" and file.exists() and not force:
        raise click.ClickException(f"{file} exists; --force writes over it")
    with common.reached(config_file) as robot:
        rows = robot.lessons()
    text = "".join(f"{line}\n" for line in written(rows, kinds))
    if str(file) == "-":
        click.echo(text, nl=False)
        return
    half = file.with_name(f".{file.name}.half")
    try:
        half.write_text(text, encoding="utf-8")
        half.replace(file)  # whole or not at all
    except OSError as error:
        half.unlink(missing_ok=True)
        raise click.ClickException(f"{file} cannot be written ({error.strerror})") from error
    count = sum(row.counts and not row.origins and (not kinds or row.kind in kinds) for row in rows)
    click.echo(f"{file}: {count} lesson{'' if count == 1 else 's'}", err=True)


@click.command(short_help="Learn the lessons and facts of a file.")
@click.argument(
    "file", type=click.Path(exists=True, dir_okay=False, path_type=Path, allow_dash=True)
)
@common.speaker_option
@click.option("--dry-run", is_flag=True, help="Only say what would be learned.")
@common.config_option
def teach(file: Path, speaker: str, dry_run: bool, config_file: Path | None) -> None:
    """Learn the lessons and facts of FILE (- for standard input), one sentence a line.

    Lines that begin with # are left out; `you(Mary): never grab a cup` is taught by Mary. Every line is understood
    before any is taught: where one is not, or is no lesson, nothing is taught and the line is named. What is in force
    already is left out. A fact can set off a reaction, as it does when it is said.

    Exit status: 0 all learned or known, 1 some were refused, 3 a line is not understood or no lesson.
    """
    from daemon.control import teaching

    sys.exit(teaching.teach(file, speaker, config_file, dry_run=dry_run))


@click.command(short_help="What was said, learned and taken back.")
@click.option(
    "-n",
    "last",
    type=click.IntRange(1, 1000),
    default=20,
    show_default=True,
    help="So many entries.",
)
@click.option(
    "--follow",
    "-f",
    is_flag=True,
    help="Then go on with what the running daemon does (Ctrl-C ends it).",
)
@click.option("--json", "as_json", is_flag=True, help="Print JSON objects, one a line.")
@common.config_option
def log(last: int, follow: bool, as_json: bool, config_file: Path | None) -> None:
    """What was said, and what was learned, taken back, undone and adapted, in order of time."""
    from daemon.control import looking_back

    with common.reached(config_file) as robot:
        if follow and not robot.live:
            raise click.ClickException(
                "nothing to follow: no daemon runs (start it with: sayso run)"
            )
        looking_back.show(robot.log(last), as_json=as_json)
    if follow:
        looking_back.follow(common.running(config_file, patient=True), as_json=as_json)


@click.command(short_help="A console: type, and see what is heard, said, done.")
@common.speaker_option
@common.config_option
def talk(speaker: str, config_file: Path | None) -> None:
    """A console on the running daemon; where none runs, on a simulated robot of its own.

    Type what you would say. Tab completes, the arrow keys go back in the history, Ctrl-C is the emergency stop, Ctrl-D
    leaves. /help tells of the commands. From a pipe: one sentence a line; the exit status is that of the last.
    """
    from daemon.control import talking

    sys.exit(talking.talk(speaker, config_file))


COMMANDS: Final = (lessons, forget, undo, why, export, teach, log, talk)
