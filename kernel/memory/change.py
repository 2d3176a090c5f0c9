"""Changes of what was learned: the journal, of which every lesson in force is a consequence (mind.md)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

from kernel.memory.lesson import Lesson

SESSION: Final = (
    10**12
)  # numbers from here on are of this session alone: nothing of theirs is stored
LEAST: Final = 0.1  # mind.md: bounds of an adapted preference
MOST: Final = 1.5


@dataclass(frozen=True, slots=True)
class Adapted:
    """A lesson's strength moved: an operator's preference, a rule's belief. The taught one stays with the lesson."""

    lesson: int
    before: float
    after: float


@dataclass(frozen=True, slots=True)
class Change:
    """One entry of the journal; all of it becomes durable at once, or none of it does.

    Attributes:
        ident: number in the store, in the order of time; 0 before it is stored; from SESSION on it is not stored.
        by: who asked for it, "" if not identified; words: the exact words; at_s: wall time, s since 1970.
        learned: lessons it put in force; stored ones carry their numbers.
        retracted: numbers of lessons it took out of force.
        adapted: strengths it moved.
        undone: numbers of earlier changes it takes back; a change that is taken back itself takes nothing back.
        own: the robot's own doing (adaptation, chunking), which "undo that" passes over.
    """

    ident: int = 0
    by: str = ""
    words: str = ""
    at_s: float = 0.0
    learned: tuple[Lesson, ...] = ()
    retracted: tuple[int, ...] = ()
    adapted: tuple[Adapted, ...] = ()
    undone: tuple[int, ...] = ()
    own: bool = False

    @property
    def teaches(self) -> bool:
        """It does more than taking other changes back."""
        return bool(self.learned or self.retracted or self.adapted)

    def durable(self) -> Change | None:
        """What of it is to be stored; None where nothing is (told facts are of the session)."""
        kept = replace(
            self,
            learned=tuple(x for x in self.learned if x.ident < SESSION),
            retracted=tuple(n for n in self.retracted if n < SESSION),
            undone=tuple(n for n in self.undone if n < SESSION),
        )
        return kept if kept.learned or kept.retracted or kept.adapted or kept.undone else None

    def stored(self, durable: Change) -> Change:
        """The whole of it, with the numbers that the store gave to what is durable."""
        of_session = tuple(x for x in self.learned if x.ident >= SESSION)
        return replace(self, ident=durable.ident, learned=(*durable.learned, *of_session))
