"""What was done, attempted and refused: the firing record that "why", "when" and "how often" are answered from."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from kernel.action.verdict import Verdict
from kernel.memory.inference import Inference
from kernel.memory.lesson import Lesson, Operator
from kernel.net.graphlet import Graphlet
from kernel.net.node import Node

if TYPE_CHECKING:
    from kernel.memory.reply import Reason

ROOM: Final = 1000  # deeds; ours
SOURCES: Final = (
    2000  # told facts whose teller is remembered; twice what working memory keeps of them
)


@dataclass(frozen=True, slots=True)
class Source:
    """Who said something: the person ("" if not identified), the exact words, and wall time, s since 1970."""

    teacher: str = ""
    words: str = ""
    at_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Occasion:
    """What a reaction reacted to.

    Attributes:
        lesson: the NOTE operator.
        fact: what was noticed.
        steps: conclusions through which the fact met the operator.
    """

    lesson: Lesson
    fact: Graphlet
    steps: tuple[Inference, ...] = ()


@dataclass(frozen=True, slots=True)
class Trouble:
    """Why a deed came to nothing.

    Attributes:
        act: the deed that failed, this one or one of its steps.
        by: the prohibition, for a refusal; steps: the conclusions that led to it.
    """

    reason: Reason
    act: Graphlet | None = None
    detail: str = ""
    by: Lesson | None = None
    steps: tuple[Inference, ...] = ()


@dataclass(frozen=True, slots=True)
class Deed:
    """One DO.

    Attributes:
        act: as it was told; understood: the same with every word that the rules concluded then.
        focus: number of the focus it was done in; parent: the deed that it is a step of, 0 for none.
        began_s: monotonic; wall_s: the same moment in s since 1970, None while nobody has told the time.
        source: the utterance it descends from, None for the robot's own.
        within: the operators it was done within, outermost first.
        ended_s, verdict: None while it is going on.
    """

    number: int
    act: Graphlet
    understood: Graphlet
    focus: int
    began_s: float
    parent: int = 0
    wall_s: float | None = None
    source: Source | None = None
    within: tuple[Lesson, ...] = ()
    occasion: Occasion | None = None
    ended_s: float | None = None
    verdict: Verdict | None = None
    trouble: Trouble | None = None

    def is_around(self, *tags: str) -> bool:
        """It is no part of the deed above it: it goes before that (ANTE) or after it (POST)."""
        last = self.within[-1].content if self.within else None
        return isinstance(last, Operator) and last.trigger.tag in tags

    @property
    def going_on(self) -> bool:
        """It has not ended."""
        return self.verdict is None

    @property
    def done(self) -> bool:
        """It succeeded."""
        return self.verdict is Verdict.SUCCEEDED


class Experience:
    """The last deeds, and who told which fact.

    Attributes:
        sources: who told what, by the main node of the fact.
    """

    def __init__(self, room: int = ROOM) -> None:
        self._room = room
        self._deeds: dict[int, Deed] = {}
        self._count = 0
        self._wall_ahead_s: float | None = None
        self.sources: dict[Node, Source] = {}

    def __iter__(self) -> Iterator[Deed]:
        """Newest first."""
        return reversed(list(self._deeds.values()))

    def __len__(self) -> int:
        return len(self._deeds)

    def clock(self, wall_s: float, now_s: float) -> None:
        """Somebody told the time: an utterance that ended at wall_s reaches the mind at now_s. 0 tells nothing."""
        if wall_s > 0:
            self._wall_ahead_s = wall_s - now_s

    def told(self, main: Node, source: Source) -> None:
        """Remember who told a fact; what was told again was told by whoever said it last."""
        self.sources.pop(main, None)
        self.sources[main] = source
        while len(self.sources) > SOURCES:
            del self.sources[next(iter(self.sources))]

    def begin(self, deed: Deed) -> Deed:
        """Add a deed under a number of its own, with the wall time of its beginning; the oldest makes room."""
        self._count += 1
        ahead_s = self._wall_ahead_s
        wall_s = None if ahead_s is None else deed.began_s + ahead_s
        kept = replace(deed, number=self._count, wall_s=wall_s)
        self._deeds[self._count] = kept
        while len(self._deeds) > self._room:
            del self._deeds[next(iter(self._deeds))]
        return kept

    def end(self, number: int, now_s: float, verdict: Verdict, trouble: Trouble | None) -> None:
        """The deed is over; one that was forgotten meanwhile stays forgotten."""
        deed = self._deeds.get(number)
        if deed is not None:
            self._deeds[number] = replace(deed, ended_s=now_s, verdict=verdict, trouble=trouble)

    def root(self, deed: Deed) -> Deed:
        """The deed that this one is a step of in the end, itself if it is none."""
        while (above := self._deeds.get(deed.parent)) is not None:
            deed = above
        return deed

    def way(self, deed: Deed) -> Lesson | None:
        """The lesson by which its newest step was done, if that says how to do the deed."""
        for step in self:
            if step.parent == deed.number and len(step.within) > len(deed.within):
                lesson = step.within[len(deed.within)]
                if isinstance(lesson.content, Operator) and lesson.content.trigger.tag == "DO":
                    return lesson
        return None

    def ancestors(self, deed: Deed) -> Iterator[Deed]:
        """What it is a step of, from the nearest on."""
        while (above := self._deeds.get(deed.parent)) is not None:
            yield above
            deed = above

    def is_whole(self, deed: Deed) -> bool:
        """It is no step of another deed."""
        return deed.parent == 0
