"""What a body really did, read from samples of where it really was: runs of travel, turning, lifting and gripping.

Judging by these, and never by what was commanded, is what makes a rehearsal worth something.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final, Literal

MoveKind = Literal["forward", "backward", "left", "right", "up", "down", "close", "open"]

SLOWEST: Final = {"travel": 1.0, "turn": 4.0, "lift": 20.0, "grip": 20.0}
"""Below this it counts as standing still: cm/s, degrees/s, permille/s."""
SMALLEST: Final = {"travel": 1.0, "turn": 4.0, "lift": 50.0, "grip": 50.0}
"""A run shorter than this is settling or noise: cm, degrees, permille."""
NAMES: Final[dict[str, tuple[MoveKind, MoveKind]]] = {
    "travel": ("forward", "backward"),
    "turn": ("left", "right"),
    "lift": ("up", "down"),
    "grip": ("open", "close"),
}
SAME_RUN_S: Final = 0.12


@dataclass(frozen=True, slots=True)
class Sample:
    """Where the body was at t_s: cm, degrees counterclockwise, permille as in the `pose` event.

    held: what is in the gripper ("red block"), "" for nothing.
    """

    t_s: float
    x_cm: float
    y_cm: float
    heading_deg: float
    lift_permille: float
    grip_permille: float
    held: str = ""


@dataclass(frozen=True, slots=True)
class Run:
    """One uninterrupted motion of one sort: amount in cm, degrees or permille, always positive."""

    kind: MoveKind
    began_s: float
    ended_s: float
    amount: float

    def overlap_s(self, other: Run) -> float:
        """For how long both went on."""
        return min(self.ended_s, other.ended_s) - max(self.began_s, other.began_s)


def runs(samples: Sequence[Sample]) -> tuple[Run, ...]:
    """All runs, earliest first."""
    found = [run for sort in NAMES for run in _runs(sort, samples)]
    return tuple(sorted(found, key=lambda run: (run.began_s, run.ended_s)))


def groups(all_runs: Sequence[Run], kind: MoveKind, pieces: bool = False) -> tuple[Run, ...]:
    """Runs of one kind, joined where no wheel or servo did anything else between them.

    "Turn left twice" is one group of 180 degrees. With pieces every stretch of a group counts too.
    """
    mine = [run for run in all_runs if run.kind == kind]
    chains: list[list[Run]] = []
    for run in mine:
        if chains and not _between(all_runs, chains[-1][-1], run):
            chains[-1].append(run)
        else:
            chains.append([run])
    stretches: list[list[Run]] = []
    for chain in chains:
        ends = range(1, len(chain) + 1)
        stretches += (
            [chain[a:b] for a in range(len(chain)) for b in ends if b > a] if pieces else [chain]
        )
    return tuple(_join(stretch) for stretch in stretches)


def arcs(all_runs: Sequence[Run], side: MoveKind) -> tuple[Run, ...]:
    """Turns to that side most of which went on while the body travelled."""
    travels = [run for run in all_runs if run.kind in NAMES["travel"]]
    return tuple(
        turn
        for turn in all_runs
        if turn.kind == side
        and any(turn.overlap_s(t) > 0.5 * (turn.ended_s - turn.began_s) for t in travels)
    )


def still(samples: Sequence[Sample], after_s: float = -math.inf) -> bool:
    """Nothing moved by more than a settling's worth from its first place after that time."""
    late = [sample for sample in samples if sample.t_s >= after_s]
    first = late[0] if late else None
    return first is None or all(
        math.hypot(s.x_cm - first.x_cm, s.y_cm - first.y_cm) < SMALLEST["travel"]
        and abs(_turned(first, s)) < SMALLEST["turn"]
        and abs(s.lift_permille - first.lift_permille) < SMALLEST["lift"]
        and abs(s.grip_permille - first.grip_permille) < SMALLEST["grip"]
        for s in late
    )


def _runs(sort: str, samples: Sequence[Sample]) -> Iterable[Run]:
    positive, negative = NAMES[sort]
    found: list[Run] = []
    for before, after in pairwise(samples):
        seconds = after.t_s - before.t_s
        change = _change(sort, before, after)
        if seconds <= 0 or abs(change) / seconds < SLOWEST[sort]:
            continue
        run = Run(positive if change > 0 else negative, before.t_s, after.t_s, abs(change))
        last = found[-1] if found else None
        if last and last.kind == run.kind and run.began_s - last.ended_s <= SAME_RUN_S:
            found[-1] = _join([last, run])
        else:
            found.append(run)
    return (run for run in found if run.amount >= SMALLEST[sort])


def _change(sort: str, before: Sample, after: Sample) -> float:
    if sort == "turn":
        return _turned(before, after)
    if sort == "lift":
        return after.lift_permille - before.lift_permille
    if sort == "grip":
        return after.grip_permille - before.grip_permille
    heading = math.radians(before.heading_deg + _turned(before, after) / 2)
    ahead = (after.x_cm - before.x_cm) * math.cos(heading)
    return ahead + (after.y_cm - before.y_cm) * math.sin(heading)


def _turned(before: Sample, after: Sample) -> float:
    return (after.heading_deg - before.heading_deg + 180) % 360 - 180


def _between(all_runs: Sequence[Run], first: Run, second: Run) -> bool:
    return any(
        run.kind != first.kind and first.ended_s < (run.began_s + run.ended_s) / 2 < second.began_s
        for run in all_runs
    )


def _join(stretch: Sequence[Run]) -> Run:
    total = sum(run.amount for run in stretch)
    return Run(stretch[0].kind, stretch[0].began_s, stretch[-1].ended_s, total)
