"""Lessons as rows: what `sayso lessons` lists, `export` writes and the control socket carries."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import Final, Literal, cast

import msgspec

from daemon.store import Loaded
from grammars.render import render
from kernel.errors import NotationError
from kernel.memory.change import Change
from kernel.memory.lesson import Content, Lesson, LessonKind, Resting
from kernel.memory.notation import read, write
from kernel.memory.policy import Policy

Standing = Literal["in force", "taken back", "rests"]
IN_FORCE: Final = "in force"


class Row(msgspec.Struct, frozen=True, kw_only=True, dict=True):
    """One lesson and how it stands.

    Attributes:
        ident: its number.
        kind: kind of sentence it came from.
        notation: the lesson itself; "" where it rests, for then it may be unreadable.
        words: the teacher's exact words; teacher: his name, "" if not identified; at_s: wall time, s since 1970.
        origins: numbers of the lessons the robot made it from by itself.
        strength: preference or belief now, adaptation included.
        standing: whether it counts; why: what is wrong with one that rests.
    """

    ident: int
    kind: str = ""
    notation: str = ""
    words: str = ""
    teacher: str = ""
    at_s: float = 0.0
    origins: tuple[int, ...] = ()
    strength: float = 1.0
    standing: Standing = "in force"
    why: str = ""

    @property
    def counts(self) -> bool:
        """It is in force."""
        return self.standing == IN_FORCE

    @cached_property
    def lesson(self) -> Lesson:
        """The lesson of a row that does not rest.

        Raises:
            NotationError: it was written by a newer Sayso.
        """
        content: Content = read(self.notation)
        kind = cast(LessonKind, self.kind)
        return Lesson(self.ident, kind, content, self.words, self.teacher, self.at_s, self.origins)

    @cached_property
    def taught(self) -> float:
        """The strength it was taught with; as it is now where the notation cannot be read."""
        try:
            return self.lesson.strength
        except NotationError:
            return self.strength

    @cached_property
    def text(self) -> str:
        """The lesson in English, in the teacher's voice; his words where the net cannot be read."""
        try:
            return render(self.lesson.content, "teacher")
        except (NotationError, ValueError):
            return self.words


def rows(
    changes: Sequence[Change],
    resting: Iterable[Resting] = (),
    after: int = 0,
    most: int | None = None,
) -> tuple[Row, ...]:
    """Lessons of a journal, by number, those taken back as well; and those that rest.

    Only those with a number greater than `after`, at most `most`: to write a net costs more than to find it.
    """
    policy = Policy()
    for change in changes:
        policy.apply(change)
    retracted = {n for c in changes if policy.counts(c.ident) for n in c.retracted}
    learned = (lesson for change in changes for lesson in change.learned)
    everything: list[Lesson | Resting] = [*learned, *resting]
    found = [x for x in everything if x.ident > after]
    return tuple(
        _asleep(x, policy, retracted) if isinstance(x, Resting) else _awake(x, policy)
        for x in sorted(found, key=lambda x: x.ident)[:most]
    )


def _awake(lesson: Lesson, policy: Policy) -> Row:
    return Row(
        ident=lesson.ident,
        kind=lesson.kind,
        notation=write(lesson.content),
        words=lesson.words,
        teacher=lesson.teacher,
        at_s=lesson.at_s,
        origins=lesson.origins,
        strength=policy.strength(lesson),
        standing="in force" if lesson.ident in policy.lessons else "taken back",
    )


def _asleep(sleeper: Resting, policy: Policy, retracted: set[int]) -> Row:
    gone = sleeper.ident in retracted or not policy.counts(sleeper.change)
    return Row(
        ident=sleeper.ident,
        kind=sleeper.kind,
        words=sleeper.words,
        teacher=sleeper.teacher,
        at_s=sleeper.at_s,
        standing="taken back" if gone else "rests",
        why=sleeper.why,
    )


def rows_of(loaded: Loaded) -> tuple[Row, ...]:
    """The rows of a store."""
    return rows(loaded.changes, loaded.resting)


def missing(numbers: Iterable[int], known: Iterable[Row]) -> list[str]:
    """What is wrong with numbers of lessons that are to be forgotten, for a person; empty where nothing is."""
    standing = {row.ident: row.standing for row in known}
    return [
        f"lesson {n} was taken back already" if n in standing else f"there is no lesson {n}"
        for n in numbers
        if standing.get(n, "taken back") == "taken back"
    ]
