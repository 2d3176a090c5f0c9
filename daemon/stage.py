"""A fresh mind and a simulated robot in virtual time, with a world to change and a truth to judge by."""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable
from itertools import count
from types import TracebackType
from typing import Final, Self

from daemon import events as ev
from daemon.config import Config, MindPart, Robot
from daemon.dialogue import Insert, Place, Remove, WorldStep
from daemon.judgement import Turn
from daemon.link.virtual import VirtualLink
from daemon.motion import Sample
from daemon.parts import Parts, assemble_virtual
from daemon.store import Store
from kernel.bodies.forklift.simulated import World
from kernel.bodies.forklift.twin import STEP_S
from kernel.memory.meaning import Utterance

TICK_S: Final = 1 / 30
SAMPLE_S: Final = 0.05
CONNECT_S: Final = 3.0
SETTLE_S: Final = 0.5
"""Idle for so long is idle: a sensor's next report, and what the mind makes of it, come within that."""
AT_MOST_S: Final = 60.0


def sample(world: World, now_s: float) -> Sample:
    """Where the robot really is."""
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


class Stage:
    """One rehearsal's daemon. Time passes only in `run`.

    Args:
        seed: of the mind's choices, the sensors' noise and the line.
        emit: told of every event.
    """

    def __init__(self, seed: int, emit: Callable[[ev.Event], None]) -> None:
        self._seed = seed
        self._watch = emit
        self._store = Store.in_memory()
        self._turn_began_s = 0.0
        self._events: list[ev.Event] = []
        self._samples: list[Sample] = []
        self._due: list[tuple[float, int, Callable[[], None]]] = []
        self._order = count()
        self._steps = 0
        self._busy_s = 0.0
        self._begin()

    @property
    def now_s(self) -> float:
        """Virtual time since the beginning, s."""
        return self._steps * STEP_S

    @property
    def parts(self) -> Parts[VirtualLink]:
        """The cycle and its link; new ones after a restart."""
        return self._parts

    @property
    def world(self) -> World:
        """The robot's world."""
        return self._parts.link.simulated.world

    def hear(self, utterance: Utterance, source: str = "typed") -> None:
        """An utterance arrives now."""
        self._parts.cycle.hear(utterance, source)
        self._tick()

    def at(self, when_s: float, act: Callable[[], None]) -> None:
        """Do it when that time comes."""
        heapq.heappush(self._due, (when_s, next(self._order), act))

    def run(self, seconds: float | None) -> None:
        """Let time pass: so long, or until nothing has been going on for a while (at most AT_MOST_S)."""
        self._busy_s = self.now_s
        end_s = self.now_s + (AT_MOST_S if seconds is None else seconds) - STEP_S / 2
        while self.now_s < end_s:
            if seconds is None and self.now_s - self._busy_s >= SETTLE_S:
                break
            self._step()

    def begin_turn(self) -> None:
        """Forget what happened up to now."""
        self._events, self._samples = [], [sample(self.world, self.now_s)]
        self._turn_began_s = self.now_s

    def turn(self) -> Turn:
        """What has happened since the turn began."""
        last = sample(self.world, self.now_s)
        samples = (*self._samples, last) if last.t_s > self._samples[-1].t_s else self._samples
        return Turn(tuple(self._events), tuple(samples), self._turn_began_s, self.now_s)

    def restart(self) -> None:
        """The store is kept, everything else is new."""
        self._due.clear()
        self._begin()

    def close(self) -> None:
        """Tell where the robot ended up, and give up the store."""
        self._emit(self._parts.cycle.pose)
        self._store.close()

    def _begin(self) -> None:
        config = Config(robot=Robot(uri="sim://forklift"), mind=MindPart(seed=self._seed))
        self._parts = assemble_virtual(config, self._store, self._emit)
        self._next_tick_s = self.now_s
        self.begin_turn()
        end_s = self.now_s + CONNECT_S
        while not self._parts.link.connected and self.now_s < end_s:
            self._step()
        self._tick()

    def _step(self) -> None:
        self._steps += 1
        self._parts.link.advance(STEP_S)
        while self._due and self._due[0][0] <= self.now_s:
            heapq.heappop(self._due)[2]()
        if self.now_s >= self._next_tick_s:
            self._next_tick_s += TICK_S
            self._tick()
        if self._steps % round(SAMPLE_S / STEP_S) == 0:
            self._samples.append(sample(self.world, self.now_s))

    def _tick(self) -> None:
        self._parts.cycle.step(self.now_s)
        if self._due or not self._parts.cycle.idle:
            self._busy_s = self.now_s

    def _emit(self, event: ev.Event) -> None:
        self._events.append(event)
        self._watch(event)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()
