"""A dialogue as a sequence of acts: one input line, how long time then runs, and what is expected of that time."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from daemon.dialogue import Audio, Expect, Insert, Place, Remove, Step, Wait, You


@dataclass(frozen=True, slots=True)
class Act:
    """Attributes:
    step: the input line; None for expectations before any.
    seconds: for exactly how long time runs after it; None: until nothing is active.
    expected: the `robot:` lines to be checked after that.
    """

    step: Step | None
    seconds: float | None
    expected: tuple[Expect, ...]


def acts(steps: Iterable[Step]) -> tuple[Act, ...]:
    """Cut a dialogue into acts (service.md).

    After a you, audio or world line time runs until nothing is active, unless the next input line is a wait, which
    then belongs to the same act; expectations on either side of it are of that one time.
    """
    found: list[Act] = []
    step: Step | None = None
    seconds: float | None = 0.0
    waited = False
    expected: list[Expect] = []

    def close() -> None:
        if step is not None or expected:
            found.append(Act(step, seconds, tuple(expected)))

    for line in steps:
        if isinstance(line, Expect):
            expected.append(line)
        elif (
            isinstance(line, Wait)
            and isinstance(step, You | Audio | Place | Insert | Remove)
            and not waited
        ):
            seconds, waited = line.seconds, True
        else:
            close()
            step, expected, waited = line, [], False
            if isinstance(line, Wait):
                seconds = line.seconds
            else:
                seconds = None if isinstance(line, You | Audio | Place | Insert | Remove) else 0.0
    close()
    return tuple(found)
