"""The command line. What a command needs is imported when it runs: `sayso --help` loads nothing else."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Final, NoReturn

import click

from daemon.control import common, managing

EXIT_CONFIG: Final = 78


@click.group(context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100})
@click.version_option(package_name="sayso")
def cli() -> None:
    """Sayso: a small forklift robot that learns by being told.

    Start with `sayso demo`. Teach it: `sayso say "to cha-cha drive forward then drive backwards"`, then `sayso say
    cha-cha`. Without a running daemon (`sayso run`), say and hear do it at once on a simulated robot; lessons are kept
    either way.

    What was taught: lessons, forget, undo, export, teach. What happened: why, log. A console: talk.

    Exit status: 0 done, 1 failed or refused, 2 wrong usage, 3 not understood, 78 wrong configuration.
    """


@cli.command()
@common.config_option
@click.option("--robot", metavar="URI", help="sim://forklift, serial:/dev/ttyUSB0?baud=57600, ...")
@click.option("--hearing", metavar="SOURCE", help="typed, or a WAV file.")
@click.option("--scene", metavar="FILE", help="What stands around the simulated robot.")
@click.option("--verbose", "-v", is_flag=True, help="Log every decision of the mind.")
def run(
    config_file: Path | None,
    robot: str | None,
    hearing: str | None,
    scene: str | None,
    verbose: bool,
) -> None:
    """The daemon, in the foreground: hear, think, act."""
    from daemon.app import main as serve
    from daemon.config import override

    config = override(common.config(config_file), robot=robot, hearing=hearing, scene=scene)
    sys.exit(serve(config, verbose=verbose))


@cli.command()
@click.argument("text")
@common.speaker_option
@common.config_option
def say(text: str, speaker: str, config_file: Path | None) -> None:
    """Say TEXT to the robot and print what comes of it."""
    said = common.text_argument(text)
    with common.reached(config_file) as robot:
        sys.exit(common.status(robot.say(said, speaker, common.show)))


@cli.command()
@click.argument("file", type=click.Path(exists=True, dir_okay=False, path_type=Path))
@common.speaker_option
@common.config_option
def hear(file: Path, speaker: str, config_file: Path | None) -> None:
    """Play FILE (WAV) to the robot's ears and print what comes of it."""
    with common.reached(config_file) as robot:
        sys.exit(common.status(robot.hear(file, speaker, common.show)))


@cli.command()
@common.config_option
def stop(config_file: Path | None) -> None:
    """Emergency stop of the running daemon's robot."""
    from daemon.control.messages import Stop, Told

    with common.running(config_file) as client:
        for answer in client.ask(Stop(v=1)):
            if isinstance(answer, Told):
                click.echo(f"stopped (stop {answer.facts.get('epoch')})")


@cli.command()
@common.config_option
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
def status(config_file: Path | None, as_json: bool) -> None:
    """State of the running daemon: hearing, mind, link."""
    import json

    from daemon.control.messages import Status, Told

    with common.running(config_file) as client:
        for answer in client.ask(Status(v=1)):
            if isinstance(answer, Told):
                if as_json:
                    click.echo(json.dumps(answer.facts))
                else:
                    for key, value in answer.facts.items():
                        shown = value
                        if isinstance(value, dict):
                            inner = ((k, v) for k, v in value.items() if k not in ("t", "event"))
                            shown = ", ".join(f"{k} {v}" for k, v in inner)
                        click.echo(f"{key:<11} {shown}")


@cli.command()
@click.argument("text", required=False)
@click.option("--json", "as_json", is_flag=True, help="Print JSON objects, one a line.")
@click.option("--explain", is_flag=True, help="Print the readings, their ranks and what decided.")
def parse(text: str | None, as_json: bool, explain: bool) -> None:
    """What TEXT means; nothing is executed. With - or nothing: one sentence a line from standard input."""
    from daemon.control.describing import as_json_line, as_text, described, explained

    if explain and as_json:
        raise click.UsageError("--explain is for people, --json for programs: one of the two")

    def show(sentence: str) -> bool:
        answer = described(sentence)
        click.echo(as_json_line(answer) if as_json else as_text(answer))
        for line in explained(sentence) if explain else ():
            click.echo(line)
        return bool(answer["kind"] != "not_understood")

    if text not in (None, "-"):
        sys.exit(0 if show(common.clean(text or "")) else common.EXIT_NOT_UNDERSTOOD)
    for sentence in common.sentences():
        show(sentence)


@cli.command()
@click.argument("file", type=click.Path(exists=True, dir_okay=False, path_type=Path))
@click.option("--json", "as_json", is_flag=True, help="Print every event as a JSON object.")
@click.option("--seed", type=click.IntRange(min=0), default=0, show_default=True)
def rehearse(file: Path, as_json: bool, seed: int) -> None:
    """Play a dialogue FILE against a fresh mind and simulated robot, in virtual time."""
    from daemon.rehearse import main as play

    sys.exit(play(file, seed=seed, as_json=as_json))


@cli.command()
@click.option("--fast", is_flag=True, help="In virtual time, instead of real time over the PTY.")
@click.option("--typed", is_flag=True, help="Type the sentences instead of hearing them.")
@click.option(
    "--engine",
    type=click.Choice(["auto", "vosk", "pocketsphinx"]),
    default="auto",
    show_default=True,
    help="Which recogniser hears.",
)
@click.option("--seed", type=click.IntRange(min=0), default=0, show_default=True)
@click.option(
    "--picture",
    metavar="FILE",
    type=click.Path(dir_okay=False, path_type=Path),
    help="Draw the end as an SVG.",
)
def demo(fast: bool, typed: bool, engine: str, seed: int, picture: Path | None) -> None:
    """The paper's demonstration, from recorded speech to the moving robot; fails if any line does."""
    from daemon.demo.run import main as play

    sys.exit(play(fast=fast, typed=typed, engine=engine, seed=seed, picture=picture))


for command in managing.COMMANDS:
    cli.add_command(command)


def main() -> NoReturn:
    """The console script: errors become one line, never a traceback (but for SAYSO_DEBUG=1)."""
    try:
        cli.main(prog_name="sayso", standalone_mode=True)
    except Exception as error:
        if os.environ.get("SAYSO_DEBUG"):
            raise
        click.echo(f"sayso: {_said(error)}", err=True)
        sys.exit(EXIT_CONFIG if type(error).__name__ == "ConfigError" else common.EXIT_FAILED)
    sys.exit(0)


def _said(error: Exception) -> str:
    """An error we know speaks for itself; of another its kind is told as well."""
    known = type(error).__module__.partition(".")[0] in ("daemon", "grammars", "kernel")
    if known or isinstance(error, OSError | click.ClickException):
        return str(error)
    return f"internal error ({type(error).__name__}: {error}); SAYSO_DEBUG=1 tells more"


if __name__ == "__main__":
    main()
