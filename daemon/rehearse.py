"""Rehearsals: a dialogue file against a fresh mind and the simulated robot, in virtual time, checked line by line."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from rich.console import Console
from rich.text import Text

from daemon import events as ev
from daemon.acts import Act, acts
from daemon.dialogue import (
    Audio,
    Dialogue,
    DialogueError,
    Insert,
    LinkSwitch,
    Place,
    Remove,
    Restart,
    You,
    load,
)
from daemon.judgement import Outcome, Turn, judge
from daemon.narration import entered, judged, told
from daemon.recorder import change
from daemon.stage import Stage
from kernel.memory.meaning import Utterance

EXIT_FAILED: Final = 1
EXIT_USAGE: Final = 2


@dataclass(frozen=True, slots=True)
class Played:
    """An act that was played, and whether its expectations held."""

    act: Act
    outcomes: tuple[Outcome, ...]

    @property
    def ok(self) -> bool:
        """All of them held."""
        return all(outcome.ok for outcome in self.outcomes)


def perform(act: Act, stage: Stage) -> Turn:
    """Play one act on a stage: its input line, and the time after it. What happened."""
    stage.begin_turn()
    match act.step:
        case You(text=text, speaker=speaker):
            if speaker == "":
                stage.meet_stranger()
            stage.hear(Utterance(text, speaker or "", stage.now_s))
        case Audio(path=path):
            stage.play(path)
        case Place() | Insert() | Remove() as step:
            change(stage.world, step)
        case Restart():
            stage.restart()
        case LinkSwitch(up=True):
            stage.parts.link.restore()
        case LinkSwitch(up=False):
            stage.parts.link.cut()
    stage.run(act.seconds)
    return stage.turn()


def rehearse(
    dialogue: Dialogue,
    *,
    seed: int = 0,
    emit: Callable[[ev.Event], None] = lambda _: None,
    enter: Callable[[str], None] = lambda _: None,
    check: Callable[[Outcome], None] = lambda _: None,
) -> tuple[Played, ...]:
    """Play a whole dialogue.

    Args:
        dialogue: parsed.
        seed: of every chance there is; the same one gives the same events.
        emit: told of every event, when it happens.
        enter: told of every input line before it is played.
        check: told of every expectation after its turn.
    """
    played = []
    with Stage(seed, emit) as stage:
        for act in acts(dialogue.steps):
            if act.step is not None:
                enter(dialogue.lines[act.step.line])
            turn = perform(act, stage)
            played.append(Played(act, judge([line.expectation for line in act.expected], turn)))
            for outcome in played[-1].outcomes:
                check(outcome)
    return tuple(played)


def main(path: Path, *, seed: int = 0, as_json: bool = False) -> int:
    """`sayso rehearse`: events on standard output; the exit status, 1 if an expectation failed, 2 for a wrong file."""
    try:
        dialogue = load(path)
    except DialogueError as error:
        print(f"sayso: {error}", file=sys.stderr)
        return EXIT_USAGE
    played = _as_json(dialogue, seed) if as_json else _as_text(dialogue, seed)
    return 0 if all(act.ok for act in played) else EXIT_FAILED


def _as_json(dialogue: Dialogue, seed: int) -> Sequence[Played]:
    def emit(event: ev.Event) -> None:
        if not isinstance(event, ev.INTERNAL):
            print(json.dumps(ev.as_dict(event), ensure_ascii=False))

    def check(outcome: Outcome) -> None:
        if not outcome.ok:
            print(judged(outcome).plain, file=sys.stderr)

    return rehearse(dialogue, seed=seed, emit=emit, check=check)


def _as_text(dialogue: Dialogue, seed: int) -> Sequence[Played]:
    console = Console(highlight=False, soft_wrap=True)

    def show(text: Text | None) -> None:
        if text is not None:
            console.print(text)

    played = rehearse(
        dialogue,
        seed=seed,
        emit=lambda event: show(told(event)),
        enter=lambda line: show(entered(line)),
        check=lambda outcome: show(judged(outcome)),
    )
    outcomes = [o for act in played for o in act.outcomes if o.expectation.checked]
    held = sum(outcome.ok for outcome in outcomes)
    console.print(f"\n{dialogue.name}: {held} of {len(outcomes)} expectations held")
    return played
