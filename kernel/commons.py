"""What every running focus shares with the mind."""

from __future__ import annotations

import random
from dataclasses import dataclass, field

from kernel.action.arbiter import Claim
from kernel.action.call import Bid, Tick
from kernel.action.trace import Record, What
from kernel.memory.attention import Focus
from kernel.memory.lesson import Lesson, Operator, Rule
from kernel.memory.operators import Operators
from kernel.memory.reply import Reason, Reply
from kernel.memory.settings import Settings
from kernel.memory.working import WorkingMemory


@dataclass(slots=True)
class Commons:
    """Memory, policy, the present, and what this tick brings forth.

    Attributes:
        lessons: in force, by number.
        persisted, persist_failed: the store's answers, by the key of the pending lesson.
        struck: tickets that must fail at their next turn, and why.
    """

    memory: WorkingMemory
    operators: Operators
    chance: random.Random
    settings: Settings
    tick: Tick = field(default_factory=Tick)
    claims: list[Claim] = field(default_factory=list)
    speech: list[Bid] = field(default_factory=list)
    trace: list[Record] = field(default_factory=list)
    replies: list[Reply] = field(default_factory=list)
    persist: list[tuple[int, Lesson]] = field(default_factory=list)
    persisted: dict[int, int] = field(default_factory=dict)
    persist_failed: dict[int, str] = field(default_factory=dict)
    lessons: dict[int, Lesson] = field(default_factory=dict)
    struck: dict[int, Reason] = field(default_factory=dict)
    tickets: int = 0

    def next_number(self) -> int:
        """A fresh number for a ticket or a pending lesson."""
        self.tickets += 1
        return self.tickets

    def record(self, what: What, focus: Focus | None, **data: object) -> None:
        """Leave a trace record."""
        number, words = (focus.number, focus.words) if focus else (0, "")
        self.trace.append(Record(self.tick.now_s, what, number, words, data))

    def enforce(self, lesson: Lesson) -> None:
        """Put a lesson in force."""
        self.lessons[lesson.ident] = lesson
        if isinstance(lesson.content, Rule):
            self.memory.rules.add(lesson)
        elif isinstance(lesson.content, Operator):
            self.operators.add(lesson)
        else:
            self.memory.recall_fact(lesson.content)
        self.memory.changed()
