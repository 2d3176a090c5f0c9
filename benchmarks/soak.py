#!/usr/bin/env python3
"""The soak: a day of random use in virtual time; does memory stay flat, and the time of a tick?

The mind and the kinematic body (no physics), ticks of 0.1 s, about one line of tests/kernel/session.py every 20 s and
now and then half an hour of nothing; every promise of tests/kernel/watched.py is checked after every tick. Lessons go
to a real store (an SQLite file of its own) and are forgotten again, as random use would teach for ever; at the end a
new mind is made from the store and must know the same.

Memory is flat if, from the end of the second hour on, what is resident grows by less than MOST_GROWTH_MB: what is kept
up to a bound (1,000 deeds, 1,000 lessons that were taken back, 2,000 tellers, the caches of the parser) fills up after
that; and if it grows by less than LATE_GROWTH_MB in the last quarter. The time of a tick is flat if its median in the
second half is at most TIMES that of the first: an hour alone tells little, as its ticks are those of what it is busy
with.
"""

import argparse
import gc
import random
import sys
import tempfile
import time
from collections.abc import Iterable
from pathlib import Path
from statistics import median, quantiles

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from _timing import resident_mb

from daemon.store import Store
from kernel.bodies.forklift.kinematic import Kinematic
from kernel.memory.change import Change
from kernel.memory.exchange import Inputs, Outputs
from tests.kernel.conftest import Robot
from tests.kernel.session import a_line
from tests.kernel.watched import TICK_S, Watched

HOURS = 24.0
HOUR_S = 3600
BETWEEN_S = 20.0  # two lines, on average
QUIET_CHANCE, QUIET_S = 1 / 250, 1800.0
MOST_GROWTH_MB = 16.0
LATE_GROWTH_MB = 2.0
TIMES = 1.25


class Soaked(Robot):
    """The bench's robot with a real store, whose mind is timed."""

    def __init__(self, *arguments: object, **settings: object) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="sayso-soak-")
        self.path = Path(self._folder.name) / "lessons.db"
        self.db = Store.open(self.path)
        self.took_ms: list[float] = []
        super().__init__(*arguments, **settings)  # type: ignore[arg-type]

    def think(self, inputs: Inputs) -> Outputs:
        began_s = time.perf_counter()
        out = super().think(inputs)
        self.took_ms.append((time.perf_counter() - began_s) * 1e3)
        return out

    def store(self, change: Change) -> Change:
        return self.db.add(change)

    def history(self) -> Iterable[Change]:
        return self.db.load().changes

    def close(self) -> None:
        self.db.close()
        self._folder.cleanup()


def report(hour: float, watched: Watched, robot: Soaked, took_ms: list[float]) -> float:
    """A line for what is over; MB resident."""
    gc.collect()
    mind, used = watched.mind, resident_mb()
    stored_kb = sum(path.stat().st_size for path in robot.path.parent.iterdir()) / 1024
    print(
        f"{hour:5.1f} h{used:8.1f} MB{len(mind.memory.net):7}{len(mind.foci):6}{len(mind.policy):9}"
        f"{len(mind.history):9}{len(mind.memory.told):6}{len(mind.experience):7}"
        f"{median(took_ms):9.3f}{quantiles(took_ms, n=100)[98]:9.3f}{max(took_ms):9.1f}{stored_kb:9.0f} kB",
        flush=True,
    )
    return used


def soak(hours: float, seed: int) -> int:
    chance = random.Random(seed)
    watched = Watched(Soaked, seed, Kinematic())
    robot: Soaked = watched.robot
    print(
        f"{'':7}{'resident':>11}{'nodes':>7}{'foci':>6}{'lessons':>9}{'changes':>9}{'told':>6}{'deeds':>7}"
        f"{'median':>9}{'p99':>9}{'worst':>9}{'store':>12}   (ms a tick)"
    )
    end_s = robot.now_s + hours * HOUR_S
    every_s = min(HOUR_S, hours * HOUR_S / 4)
    used: list[float] = []
    medians: list[float] = []
    lines = 0
    while robot.now_s < end_s:
        if robot.now_s >= (len(used) + 1) * every_s:
            used.append(report(robot.now_s / HOUR_S, watched, robot, robot.took_ms))
            medians.append(median(robot.took_ms))
            robot.took_ms.clear()
        watched.play(a_line(chance, restarts=False))
        lines += 1
        quiet = chance.random() < QUIET_CHANCE
        watched.wait(QUIET_S if quiet else chance.expovariate(1 / (BETWEEN_S - 4.0)))
    used.append(report(robot.now_s / HOUR_S, watched, robot, robot.took_ms))
    medians.append(median(robot.took_ms))
    watched.restart()
    robot.close()
    return verdict(used, medians, every_s, lines, round(robot.now_s / TICK_S))


def verdict(used: list[float], medians: list[float], every_s: float, lines: int, ticks: int) -> int:
    """Print it; 0 if all is flat."""
    print(f"{lines:,} lines, {ticks:,} ticks; no promise was broken, and the store has the policy")
    since = min(len(used) - 1, max(1, round(2 * HOUR_S / every_s)) - 1)
    quarter, half = len(used) // 4, len(medians) // 2
    growth_mb, late_mb = used[-1] - used[since], used[-1] - used[-1 - quarter]
    first, second = median(medians[:half]), median(medians[half:])
    flat = growth_mb < MOST_GROWTH_MB and late_mb < LATE_GROWTH_MB
    even = second < TIMES * first
    print(f"memory {'flat' if flat else 'NOT FLAT'}: {growth_mb:+.1f} MB since {(since + 1) * every_s / HOUR_S:.1f} h"
          f" (< {MOST_GROWTH_MB:.0f}), {late_mb:+.1f} MB in the last quarter (< {LATE_GROWTH_MB:.0f})")  # fmt: skip
    print(
        f"time a tick {'flat' if even else 'NOT FLAT'}: {second:.3f} ms in the second half, {first:.3f} in the first"
    )
    return 0 if flat and even else 1


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--hours", type=float, default=HOURS, help="simulated")
    parser.add_argument("--seed", type=int, default=1)
    chosen = parser.parse_args()
    return soak(chosen.hours, chosen.seed)


if __name__ == "__main__":
    sys.exit(main())
