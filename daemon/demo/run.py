"""`sayso demo`: the paper's demonstration, from sound to motion; told live, judged line by line."""

from __future__ import annotations

import io
import time
from dataclasses import replace
from pathlib import Path
from typing import Final

from rich.console import Console

from daemon.acts import Act, acts
from daemon.demo.result import Result, result
from daemon.demo.script import AUDIO, SCRIPT, recordings, script
from daemon.demo.show import Show
from daemon.dialogue import Audio, Dialogue, You
from daemon.rehearse import perform
from daemon.stage import Stage

EXIT_FAILED: Final = 1
PICTURE_COLUMNS: Final = 150
PLAIN_COLUMNS: Final = 120
"""A file has no width of its own."""


def main(
    *,
    fast: bool = False,
    typed: bool = False,
    engine: str = "auto",
    seed: int = 0,
    path: Path = SCRIPT,
    audio: Path = AUDIO,
    picture: Path | None = None,
    console: Console | None = None,
) -> int:
    """Play the demonstration; the exit status: 0 only if every line was heard right and went as expected.

    Args:
        fast: in virtual time instead of real time over the PTY.
        typed: the sentences are typed, nothing is heard.
        engine: of the recogniser.
        seed: of the mind's choices and the simulated robot.
        path: the script.
        audio: folder of its recordings.
        picture: where to put a picture (SVG) of the end.
        console: where to tell it.

    Raises:
        DialogueError: the script is wrong.
        FileNotFoundError: a recording is not there.
    """
    console = console or Console(highlight=False)
    if not console.is_terminal and console.width < PLAIN_COLUMNS:
        console.width = PLAIN_COLUMNS
    demonstration = script(path)
    sounds = {} if typed else recordings(demonstration, audio)
    show = Show(console)
    began_s = time.monotonic()
    with show:
        play = _fast if fast else _live
        results = play(demonstration, sounds, show, engine, seed)
    summary = show.summary(results, time.monotonic() - began_s)
    console.print(summary)
    if picture is not None:
        paper = Console(record=True, width=PICTURE_COLUMNS, file=io.StringIO(), force_terminal=True)
        paper.print(summary)
        paper.save_svg(str(picture), title="sayso demo")
    return 0 if all(found.ok for found in results) else EXIT_FAILED


def _fast(
    demonstration: Dialogue, sounds: dict[int, Path], show: Show, engine: str, seed: int
) -> list[Result]:
    """In virtual time."""
    results = []
    with Stage(seed, show.happen, show.move, engine) as stage:
        show.things = lambda: stage.world.things
        for act in acts(demonstration.steps):
            line = demonstration.lines[act.step.line] if act.step else ""
            show.enter(line)
            vocabulary = stage.parts.cycle.vocabulary
            turn = perform(heard(act, sounds), stage)
            results.append(result(act, line, turn, vocabulary))
            show.judge(results[-1])
    return results


def _live(
    demonstration: Dialogue, sounds: dict[int, Path], show: Show, engine: str, seed: int
) -> list[Result]:
    """In real time; the daemon is loaded for it alone."""
    from daemon.demo.live import play

    return play(demonstration, sounds, show, engine, seed)


def heard(act: Act, sounds: dict[int, Path]) -> Act:
    """The act with its recording in place of its words, if it has one."""
    step = act.step
    if isinstance(step, You) and step.line in sounds:
        return replace(act, step=Audio(step.line, sounds[step.line]))
    return act
