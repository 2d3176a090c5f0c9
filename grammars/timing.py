"""Times of day: when a lesson is in force, which is a condition of its own."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from grammars.alist import AList
from grammars.errors import NoMeaningError
from grammars.mentions import is_time
from grammars.sorts import kind
from grammars.usage import AMBIENT, TIMES_OF_DAY
from kernel.net.graphlet import Graphlet

if TYPE_CHECKING:
    from grammars.things import Things


HOURS: Final = 24


def tells_time(pred: AList | None) -> bool:
    """ "It is night": of nothing in particular."""
    qual = None if pred is None else pred.find("qual")
    return qual is not None and (qual.value or qual.slot("hq")) in TIMES_OF_DAY | AMBIENT


def by_time(build: Things, action: AList) -> tuple[AList, tuple[Graphlet, ...]]:
    """A deed without the time of day that it is done at, and that it is that time: "never sing at night"."""
    rest, times = timed(action)
    found = []
    for time in times:
        with build.drawing(pattern=True):
            found.append(build.graphlet(it_is(build, time)))
    return rest, tuple(found)


def timed(said: AList) -> tuple[AList, list[str]]:
    """The same without times of day, and these."""
    times = [part for part in said.all("place") if is_time(part.first("loc"))]
    rest = tuple(part for part in said if part not in times)
    words = [kind(part.first("loc").first("np")) for part in times]
    return (AList(said.name, rest, said.value) if times else said), words


def o_clock(hour: AList | None) -> str:
    """ "After nine": "after 9 o'clock"."""
    if hour is None:
        return ""
    number = hour.slot("num")
    if not number.isdecimal() or not 0 < int(number) <= HOURS:
        raise NoMeaningError(str(hour))
    return f"{hour.slot('time_side')} {number} o'clock".strip()


def it_is(build: Things, time: str) -> str:
    """Node that says what time of day it is."""
    return build.add("hq", time, hq=build.add("obj", ref="it"))
