"""What is in force of all that was ever learned: the journal folded, one change after another.

A change counts unless a later one that counts takes it back; a lesson is in force if the change that taught it counts
and none that counts retracts it; its strength is that of the last adaptation that counts (all ours).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from kernel.memory.change import Change
from kernel.memory.lesson import Lesson


@dataclass(frozen=True, slots=True)
class Shift:
    """What a change made of the policy: lessons now in force, out of force, and of another strength."""

    entered: tuple[Lesson, ...] = ()
    left: tuple[Lesson, ...] = ()
    moved: tuple[Lesson, ...] = ()

    def __add__(self, later: Shift) -> Shift:
        return Shift(self.entered + later.entered, self.left + later.left, self.moved + later.moved)


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

    def bear(self, lesson: Lesson) -> None:
        """Put a lesson in force that no change taught: it was born with."""
        self._known[lesson.ident] = self.lessons[lesson.ident] = lesson

    def apply(self, change: Change) -> Shift:
        """Take a stored change into account."""
        self._changes[change.ident] = change
        touched = dict.fromkeys(self._file(change))
        for other in change.undone:
            touched |= dict.fromkeys(self._touched(other))
        entered, left, moved = [], [], []
        for ident in touched:
            lesson = self._known.get(ident)
            if lesson is None:
                continue
            before, after = ident in self.lessons, self._holds(ident)
            if after and not before:
                self.lessons[ident] = lesson
                entered.append(lesson)
            elif before and not after:
                del self.lessons[ident]
                left.append(lesson)
            if self._restrengthen(lesson) and after and before:
                moved.append(lesson)
        return Shift(tuple(entered), tuple(left), tuple(moved))

    def counts(self, change: int) -> bool:
        """Whether the change of that number is not taken back."""
        return not any(self.counts(later) for later in self._undone_by.get(change, ()))

    def strength(self, lesson: Lesson) -> float:
        """Adapted preference or belief; the taught one where nothing moved it."""
        return self._strengths.get(lesson.ident, lesson.strength)

    def known(self, ident: int) -> Lesson | None:
        """The lesson of that number, in force or not."""
        return self._known.get(ident)

    def changes(self) -> Iterator[Change]:
        """Newest first, those taken back as well."""
        return reversed(self._changes.values())

    def teaching(self, lesson: Lesson) -> Change | None:
        """The change that taught the lesson."""
        return self._changes.get(self._learned_by.get(lesson.ident, 0))

    def _file(self, change: Change) -> Iterable[int]:
        for lesson in change.learned:
            self._known[lesson.ident] = lesson
            self._learned_by[lesson.ident] = change.ident
        for ident in change.retracted:
            self._retracted_by.setdefault(ident, []).append(change.ident)
        for adapted in change.adapted:
            self._adapted_by.setdefault(adapted.lesson, []).append(change.ident)
        for other in change.undone:
            self._undone_by.setdefault(other, []).append(change.ident)
        return _lessons(change)

    def _touched(self, number: int) -> Iterator[int]:
        """Lessons whose standing hangs on whether that change counts."""
        change = self._changes.get(number)
        if change is not None:
            yield from _lessons(change)
            for other in change.undone:
                yield from self._touched(other)

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


def _lessons(change: Change) -> Iterator[int]:
    yield from (lesson.ident for lesson in change.learned)
    yield from change.retracted
    yield from (adapted.lesson for adapted in change.adapted)
