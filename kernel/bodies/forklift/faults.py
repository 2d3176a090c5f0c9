"""A bad line: what happens to frames between host and robot, by chance from a seed."""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import dataclass, fields
from heapq import heappop, heappush

from kernel.errors import KernelError

LATENCY_S = 0.003


class FaultsError(KernelError):
    """A text names no faults."""

    def __init__(self, text: str, problem: str) -> None:
        super().__init__(f"faults={text}: {problem}")
        self.text, self.problem = text, problem


@dataclass(frozen=True, slots=True)
class Faults:
    """Chance of each fault, per frame and direction (disconnect: per second).

    drop: lost. duplicate: arrives twice. flip: one bit is wrong. reorder: overtaken by what follows. delay: arrives
    100 to 250 ms late, and all after it waits. split: arrives in two pieces. disconnect: the line is dead for 2 s.
    """

    drop: float = 0.0
    duplicate: float = 0.0
    flip: float = 0.0
    reorder: float = 0.0
    delay: float = 0.0
    split: float = 0.0
    disconnect: float = 0.0


PROFILES: Mapping[str, Faults] = {
    "none": Faults(),
    "hc05": Faults(delay=0.01, split=0.3),
    "lossy": Faults(drop=0.05, duplicate=0.02, flip=0.02, reorder=0.02, delay=0.01, split=0.2),
}


def read(text: str) -> Faults:
    """Faults by profile ("hc05") or one by one ("drop=0.05,flip=0.01").

    Raises:
        FaultsError: neither.
    """
    if text in PROFILES:
        return PROFILES[text]
    known = [field.name for field in fields(Faults)]
    chances = {}
    for part in text.split(","):
        name, _, value = part.partition("=")
        if name not in known:
            raise FaultsError(
                text,
                f"{name!r} is neither a profile ({', '.join(PROFILES)}) nor a fault ({', '.join(known)})",
            )
        try:
            chances[name] = float(value)
        except ValueError:
            raise FaultsError(text, f"{name}: expected a number from 0 to 1") from None
        if not 0 <= chances[name] <= 1:
            raise FaultsError(text, f"{name}: expected a number from 0 to 1")
    return Faults(**chances)


class Line:
    """One direction. Bytes go in at a time and come out later, or not."""

    def __init__(self, faults: Faults, chance: random.Random) -> None:
        self._faults, self._chance = faults, chance
        self._partial = bytearray()
        self._travelling: list[tuple[float, int, bytes]] = []
        self._count = 0
        self._free_s = 0.0
        self._plain = faults == Faults()

    def push(self, data: bytes, now_s: float) -> None:
        """Bytes enter the line."""
        if self._plain:
            self._arrive(data, now_s + LATENCY_S)
            return
        self._partial += data
        *whole, rest = bytes(self._partial).split(b"\0")
        self._partial[:] = rest
        for frame in whole:
            self._frame(frame + b"\0", now_s)

    def pop(self, now_s: float) -> bytes:
        """Bytes that have arrived by now."""
        arrived = bytearray()
        while self._travelling and self._travelling[0][0] <= now_s:
            arrived += heappop(self._travelling)[2]
        return bytes(arrived)

    def cut(self) -> None:
        """What is on the line is lost."""
        self._travelling.clear()
        self._partial.clear()

    def _frame(self, frame: bytes, now_s: float) -> None:
        faults, chance = self._faults, self._chance.random
        at_s = now_s + LATENCY_S
        if chance() < faults.drop:
            return
        if chance() < faults.flip:
            bit = self._chance.randrange(8 * len(frame))
            flipped = bytearray(frame)
            flipped[bit // 8] ^= 1 << bit % 8
            frame = bytes(flipped)
        if chance() < faults.delay:
            self._free_s = max(self._free_s, at_s + self._chance.uniform(0.1, 0.25))
        at_s = max(at_s, self._free_s)
        copies = 2 if chance() < faults.duplicate else 1
        for copy in range(copies):
            late_s = self._chance.uniform(0.005, 0.1) if chance() < faults.reorder else 0.0
            arrival_s = at_s + late_s + copy * self._chance.uniform(0.0, 0.1)
            if len(frame) > 2 and chance() < faults.split:
                cut = self._chance.randrange(1, len(frame))
                self._arrive(frame[:cut], arrival_s)
                self._arrive(frame[cut:], arrival_s + 0.004)
            else:
                self._arrive(frame, arrival_s)

    def _arrive(self, data: bytes, at_s: float) -> None:
        if data:
            self._count += 1
            heappush(self._travelling, (at_s, self._count, data))
