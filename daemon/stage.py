"""A fresh mind and a simulated robot in virtual time, with a world to change and a truth to judge by."""

from __future__ import annotations

import heapq
from collections.abc import Callable
from functools import partial
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Final

from daemon import events as ev
from daemon.closing import Closing
from daemon.config import Config, MindPart, Robot
from daemon.hearing.events import Heard, HearingEvent, NotHeard, StopWord
from daemon.judgement import Turn
from daemon.link.virtual import VirtualLink
from daemon.motion import Sample
from daemon.parts import Parts, assemble_virtual
from daemon.recorder import SAMPLE_S, Recorder, sample
from daemon.store import Store
from kernel.bodies.forklift.simulated import World
from kernel.bodies.forklift.twin import STEP_S
from kernel.memory.meaning import Utterance

if TYPE_CHECKING:
    from daemon.virtual_ear import VirtualEar

TICK_S: Final = 1 / 30
CONNECT_S: Final = 3.0
SETTLE_S: Final = 0.5
"""Idle for so long is idle: a sensor's next report, and what the mind makes of it, come within that."""
AT_MOST_S: Final = 60.0


class Stage(Closing):
    """One rehearsal's daemon. Time passes only in `run` and `restart`.

    Args:
        seed: of the mind's choices, the sensors' noise and the line.
        emit: told of every event.
        watch: told of every sample of the robot's true pose.
        engine: of the recogniser, started with the first recording.
    """

    def __init__(
        self,
        seed: int,
        emit: Callable[[ev.Event], None],
        watch: Callable[[Sample], None] = lambda _: None,
        engine: str = "auto",
    ) -> None:
        self._seed, self._tell = seed, emit
        self._store = Store.in_memory()
        self._engine = engine
        self._ear: VirtualEar | None = None
        self._recorder = Recorder(watch)
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

    def meet_stranger(self) -> None:
        """Whoever speaks next is not identified."""
        self._parts.cycle.mind.speaker = ""

    def play(self, path: Path) -> None:
        """A recording begins now; what is heard in it arrives when its sound is there.

        Raises:
            RecordingError: the file cannot be heard.
            EngineError: the recogniser cannot be used.
        """
        cycle = self._parts.cycle
        recorded = self._recogniser().hear(path, cycle.vocabulary, cycle.expecting)
        for known_s, event in recorded.events:
            self.at(self.now_s + known_s, partial(self._heard, event))
        silent = partial(cycle.unclear, "", "noise")
        self.at(self.now_s + recorded.length_s, (lambda: None) if recorded.said else silent)

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
        self._recorder.begin(sample(self.world, self.now_s))

    def turn(self) -> Turn:
        """What has happened since the turn began."""
        return self._recorder.turn(sample(self.world, self.now_s))

    def restart(self) -> None:
        """The store is kept, everything else is new."""
        self._due.clear()
        self._begin()

    def close(self) -> None:
        """Tell where the robot ended up, and give up the store."""
        self._emit(self._parts.cycle.pose)
        self._store.close()
        if self._ear is not None:
            self._ear.close()

    def _recogniser(self) -> VirtualEar:
        """Made when it is needed: a typed rehearsal starts without it."""
        if self._ear is None:
            from daemon.virtual_ear import VirtualEar

            self._ear = VirtualEar(self._engine)
        return self._ear

    def _heard(self, event: HearingEvent) -> None:
        match event:
            case StopWord():
                self._parts.cycle.stop("spotted")
                self._tick()
            case Heard():
                utterance = Utterance(
                    event.text, "", self.now_s, event.confidence, event.alternatives
                )
                self.hear(utterance, "heard")
            case NotHeard(text=text, reason=reason):
                self._parts.cycle.unclear(text, reason)

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
            self._recorder.move(sample(self.world, self.now_s))

    def _tick(self) -> None:
        self._parts.cycle.step(self.now_s)
        if self._due or not self._parts.cycle.idle:
            self._busy_s = self.now_s

    def _emit(self, event: ev.Event) -> None:
        self._recorder.happen(event)
        self._tell(event)
