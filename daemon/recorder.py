"""Keeps what a turn is judged by: its events, and samples of where the robot really was."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final

from daemon import events as ev
from daemon.dialogue import Insert, Place, Remove, WorldStep
from daemon.judgement import Turn
from daemon.motion import Sample
from kernel.bodies.forklift.simulated import World

SAMPLE_S: Final = 0.05


def sample(world: World, now_s: float) -> Sample:
    """Where the robot really is, and what it really holds."""
    truth = world.truth()
    held = truth.holding
    named = (held.colour, held.noun, held.name) if held else ()
    return Sample(
        now_s,
        truth.x_cm,
        truth.y_cm,
        math.degrees(truth.heading_rad),
        truth.lift * 1000,
        truth.grip * 1000,
        " ".join(word for word in named if word),
    )


def change(world: World, step: WorldStep) -> None:
    """Do to the world what a `world:` line says."""
    match step:
        case Place(thing=thing):
            world.place(
                thing.noun,
                step.distance_m * 100,
                step.bearing,
                colour=thing.colour or None,
                name=thing.name or None,
                low=thing.low,
                following=step.following,
            )
        case Insert(thing=thing):
            world.between_fingers(
                thing.noun, colour=thing.colour or None, name=thing.name or None, low=thing.low
            )
        case Remove(within_m=None):
            world.clear()
        case Remove(within_m=float(within_m)):
            world.nothing_within(within_m * 100)


class Recorder:
    """One turn after another.

    Args:
        watch: told of every sample.
    """

    def __init__(self, watch: Callable[[Sample], None] = lambda _: None) -> None:
        self._watch = watch
        self._began_s = 0.0
        self._events: list[ev.Event] = []
        self._samples: list[Sample] = []

    def begin(self, first: Sample) -> None:
        """A turn begins, with the robot here."""
        self._began_s = first.t_s
        self._events, self._samples = [], []
        self.move(first)

    def happen(self, event: ev.Event) -> None:
        """Something happened."""
        self._events.append(event)

    def move(self, now: Sample) -> None:
        """The robot is here now. Times only go forward; a second look at one moment adds nothing."""
        if not self._samples or now.t_s > self._samples[-1].t_s:
            self._samples.append(now)
            self._watch(now)

    def turn(self, last: Sample) -> Turn:
        """The turn so far, with the robot here."""
        self.move(last)
        return Turn(tuple(self._events), tuple(self._samples), self._began_s, last.t_s)
