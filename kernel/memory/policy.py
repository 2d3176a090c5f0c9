"""What is in force of all that was ever learned: the journal folded, one change after another.

A change counts unless a later one that counts takes it back; a lesson is in force if the change that taught it counts
and none that counts retracts it; its strength is that of the last adaptation that counts (all ours).

Memory is bounded, while the store has it all: of the robot's own adaptations of a lesson the last one is kept (none is
ever taken back alone), and of lessons out of force the last RETIRED_KEPT; what is older cannot be brought back before a
restart.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Final, TypeVar

from kernel.memory.change import SESSION, Change
from kernel.memory.lesson import Lesson

RETIRED_KEPT: Final = 1000
V = TypeVar("V")


@dataclass(frozen=True, slots=True)
class Shift:
    """What a change made of the policy: lessons now in force, out of force, and of another strength."""

    entered: tuple[Lesson, ...] = ()
    left: tuple[Lesson, ...] = ()
    moved: tuple[Lesson, ...] = ()

    def __add__(self, later: Shift) -> Shift:
        return Shift(self.entered + later.entered, self.left + later.left, self.moved + later.moved)

    def lasting(self) -> Shift:
        """Without facts of the session."""
        return Shift(*(tuple(x for x in part if x.ident < SESSION) for part in
                       (self.entered, self.left, self.moved)))  # fmt: skip


class Policy:
    """Lessons and changes by number.

    Attributes:
        lessons: in force, by number, in the order they came into force.
    """

    def __init__(self) -> None:
        self.lessons: dict[int, Lesson] = {}
        self._known: dict[int, Lesson] = {}
        self._changes: dict[int, Change] = {}
        self._learned_by: dict[int, int] = {}
        self._retracted_by: dict[int, list[int]] = {}
        self._undone_by: dict[int, list[int]] = {}
        self._adapted_by: dict[int, list[int]] = {}
        self._strengths: dict[int, float] = {}
        self._retired: dict[int, None] = {}
        self._gone: set[int] = set()

    def bear(self, lesson: Lesson) -> None:
        """Put a lesson in force that no change taught: it was born with."""
        self._known[lesson.ident] = self.lessons[lesson.ident] = lesson

    def apply(self, change: Change) -> Shift:
        """Take a stored change into account."""
        self._changes[change.ident] = change
        touched = dict.fromkeys(self._file(change))
        for other in self._turn(change.undone):
            touched |= dict.fromkeys(_lessons(self._changes[other]))
        entered, left, moved = [], [], []
        for ident in touched:
            lesson = self._known.get(ident)
            if lesson is None:
                continue
            before, after = ident in self.lessons, self._holds(ident)
            if after and not before:
                self.lessons[ident] = lesson
                self._retired.pop(ident, None)
                entered.append(lesson)
            elif before and not after:
                del self.lessons[ident]
                self._retired[ident] = None
                left.append(lesson)
            if self._restrengthen(lesson) and after and before:
                moved.append(lesson)
        while len(self._retired) > RETIRED_KEPT:
            self.lose(next(iter(self._retired)))
        return Shift(tuple(entered), tuple(left), tuple(moved))

    def preview(self, change: Change) -> Shift:
        """What a change would do; nothing is changed."""
        other, changes = Policy(), self._undone_with(change)
        lessons = dict.fromkeys(n for c in (change, *changes.values()) for n in _lessons(c))
        for number in [n for ident in lessons for n in self._adapted_by.get(ident, ())]:
            changes[number] = self._changes[number]
        other._changes, other._gone = changes, set(self._gone)
        other.lessons, other._known = _some(self.lessons, lessons), _some(self._known, lessons)
        other._learned_by = _some(self._learned_by, lessons)
        other._strengths = _some(self._strengths, lessons)
        for mine, others, names in (
            (self._retracted_by, other._retracted_by, lessons),
            (self._adapted_by, other._adapted_by, lessons),
            (self._undone_by, other._undone_by, changes),
        ):
            others |= {name: list(by) for name, by in _some(mine, names).items()}
        return other.apply(replace(change, ident=2 * SESSION))

    def beyond(self, change: Change) -> bool:
        """Whether it takes back, or brings back, a lesson that only the store knows: one that rests."""
        return any(ident not in self._known for ident in change.retracted) or any(
            self.beyond(self._changes[number])
            for number in change.undone
            if number in self._changes
        )

    def _undone_with(self, change: Change) -> dict[int, Change]:
        """The changes that it takes back, and those that these take back in turn."""
        found: dict[int, Change] = {}
        pending = list(change.undone)
        while pending:
            number = pending.pop()
            if number in self._changes and number not in found:
                found[number] = self._changes[number]
                pending += found[number].undone
        return found

    def lose(self, ident: int) -> None:
        """Drop a lesson from memory, with the changes that concern nothing else."""
        for place in (self._known, self.lessons, self._retired, self._strengths):
            place.pop(ident, None)
        taught = self._learned_by.pop(ident, None)
        concerning = {*self._retracted_by.pop(ident, ()), *self._adapted_by.pop(ident, ())}
        for number in sorted(concerning | ({taught} if taught else set())):
            self._shrink(number, ident)

    def _shrink(self, number: int, ident: int) -> None:
        """Take a lesson out of a change; a change without content goes, and those that took back only it."""
        pending = [number]
        while pending:
            number = pending.pop()
            if number not in self._changes:
                continue
            change = self._changes[number]
            change = replace(
                change,
                learned=tuple(x for x in change.learned if x.ident != ident),
                retracted=tuple(n for n in change.retracted if n != ident),
                adapted=tuple(a for a in change.adapted if a.lesson != ident),
            )
            self._changes[number] = change
            undoes = any(other in self._changes for other in change.undone)
            if not (change.learned or change.retracted or change.adapted or undoes):
                del self._changes[number]
                self._gone.discard(number)
                pending += self._undone_by.pop(number, ())

    def counts(self, change: int) -> bool:
        """Whether the change of that number is not taken back."""
        return change not in self._gone

    def strength(self, lesson: Lesson) -> float:
        """Adapted preference or belief; the taught one where nothing moved it."""
        return self._strengths.get(lesson.ident, lesson.strength)

    def known(self, ident: int) -> Lesson | None:
        """The lesson of that number, in force or not."""
        return self._known.get(ident)

    def changes(self) -> Iterator[Change]:
        """Newest first, those taken back as well."""
        return reversed(self._changes.values())

    def _file(self, change: Change) -> Iterable[int]:
        for lesson in change.learned:
            self._known[lesson.ident] = lesson
            self._learned_by[lesson.ident] = change.ident
        for ident in change.retracted:
            self._retracted_by.setdefault(ident, []).append(change.ident)
        for adapted in change.adapted:
            if change.own:
                self._supersede(adapted.lesson)
            self._adapted_by.setdefault(adapted.lesson, []).append(change.ident)
        for other in change.undone:
            self._undone_by.setdefault(other, []).append(change.ident)
        return _lessons(change)

    def _supersede(self, ident: int) -> None:
        """A new adaptation of the robot's own makes those before it needless."""
        numbers = self._adapted_by.get(ident, [])
        for number in [n for n in numbers if self._changes[n].own]:
            numbers.remove(number)
            change = self._changes[number]
            left = tuple(a for a in change.adapted if a.lesson != ident)
            self._changes[number] = replace(change, adapted=left)
            if not (left or change.learned or change.retracted or change.undone):
                del self._changes[number]

    def _turn(self, undone: Iterable[int]) -> Iterator[int]:
        """Work out anew which of these changes count, and of those they take back in turn; yields all that turned."""
        pending = list(undone)
        while pending:
            number = pending.pop()
            if number not in self._changes:
                continue
            counts = not any(map(self.counts, self._undone_by.get(number, ())))
            if counts != self.counts(number):
                (self._gone.discard if counts else self._gone.add)(number)
                yield number
                pending += self._changes[number].undone

    def _holds(self, ident: int) -> bool:
        taught = self._learned_by.get(ident)
        return (taught is None or self.counts(taught)) and not any(
            map(self.counts, self._retracted_by.get(ident, ()))
        )

    def _restrengthen(self, lesson: Lesson) -> bool:
        """Set the strength by the last adaptation that counts; whether that moved it."""
        before = self.strength(lesson)
        self._strengths.pop(lesson.ident, None)
        for number in reversed(self._adapted_by.get(lesson.ident, ())):
            if self.counts(number):
                adapted = self._changes[number].adapted
                self._strengths[lesson.ident] = next(
                    a.after for a in adapted if a.lesson == lesson.ident
                )
                break
        return self.strength(lesson) != before


def _some(values: Mapping[int, V], names: Iterable[int]) -> dict[int, V]:
    """Those of these names."""
    return {name: values[name] for name in names if name in values}


def _lessons(change: Change) -> Iterator[int]:
    yield from (lesson.ident for lesson in change.learned)
    yield from change.retracted
    yield from (adapted.lesson for adapted in change.adapted)
