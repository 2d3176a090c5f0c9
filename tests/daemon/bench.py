"""A cycle on a bench: the real mind, the real session and the simulated robot, in virtual time."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, TypeVar

from daemon import events
from daemon.config import Config, MindPart
from daemon.link.virtual import VirtualLink
from daemon.loop import Cycle
from daemon.parts import make_cycle
from daemon.speaking.silent import SilentVoice
from daemon.store import Store
from daemon.writer import AtOnce, Keeper
from firmware_proto.frame import FrameReader
from firmware_proto.messages import Message, unpack
from kernel.bodies.forklift.faults import PROFILES
from kernel.memory.meaning import Utterance

TICK_S: Final = 1 / 30

E = TypeVar("E", bound=events.Event)


class Bench:
    """Time passes only in `run`; everything told is kept in `told`."""

    def __init__(
        self,
        store: Store | None = None,
        *,
        seed: int = 0,
        faults: str = "none",
        keeper: Keeper | None = None,
    ) -> None:
        self.told: list[events.Event] = []
        self.store = store or Store.in_memory()
        self.link = VirtualLink(seed=seed, faults=PROFILES[faults])
        self.cycle: Cycle = make_cycle(
            Config(mind=MindPart(seed=seed)),
            self.store.load(),
            self.link,
            SilentVoice(),
            keeper or AtOnce(self.store),
            self.told.append,
        )
        self.run(until=lambda: self.link.connected)
        self.run(0.3)  # the first telemetry is there

    def run(
        self, seconds: float = 60.0, *, until: Callable[[], bool] | None = None, step: bool = True
    ) -> None:
        """Let time pass: so long, or until something is so (which then must come true)."""
        end_s = self.link.now_s + seconds
        while self.link.now_s < end_s:
            self.link.advance(TICK_S)
            if step:
                self.cycle.step(self.link.now_s)
            if until is not None and until():
                return
        assert until is None, f"not within {seconds} s: {self.lines()}"

    def say(self, text: str, speaker: str = "", *, wait: bool = True) -> None:
        """Somebody types it; time passes until nothing is going on."""
        self.cycle.hear(Utterance(text, speaker, 1e9))
        if wait:
            self.run(until=lambda: self.cycle.idle)

    def all(self, kind: type[E]) -> list[E]:
        """Every event of a kind, in order."""
        return [event for event in self.told if isinstance(event, kind)]

    def lines(self) -> list[dict[str, object]]:
        """Everything told, for comparing and for failures."""
        return [events.as_dict(event) for event in self.told]

    @property
    def x_cm(self) -> float:
        """Where the robot really is."""
        return self.link.simulated.world.truth().x_cm

    def sent(self) -> list[tuple[float, Message]]:
        """Messages written to the wire, with their times."""
        reader, messages = FrameReader(), []
        for at_s, data in self.link.sent:
            for frame in reader.feed(data):
                messages.append((at_s, unpack(frame.number, frame.payload)))
        return messages
