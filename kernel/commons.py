"""What every running focus shares with the mind."""

from __future__ import annotations

import random
from dataclasses import dataclass, field, replace

from kernel.action.arbiter import Claim
from kernel.action.call import Bid, Tick
from kernel.action.trace import Record, What
from kernel.memory.attention import Failure, Focus
from kernel.memory.lesson import Lesson, Operator, Rule
from kernel.memory.operators import Operators
from kernel.memory.reply import LessonTaken, Reason, Reply
from kernel.memory.settings import Settings
from kernel.memory.working import WorkingMemory


@dataclass(slots=True)
class Commons:
    """Memory, policy, the present, and what this tick brings forth.

    Attributes:
        lessons: in force, by number.
        pending: lessons the store has not answered for, by key, with the focus each came from.
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
    pending: dict[int, tuple[Focus, Lesson]] = field(default_factory=dict)
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

    def keep(self, focus: Focus, lesson: Lesson) -> int:
        """Ask the store to keep a lesson; the key of its answer."""
        key = self.next_number()
        self.persist.append((key, lesson))
        self.pending[key] = (focus, lesson)
        return key

    def kept(self, key: int, ident: int) -> None:
        """The lesson is durable: it is in force, even if its focus was stopped meanwhile."""
        if key not in self.pending:
            return
        focus, lesson = self.pending.pop(key)
        lesson = replace(lesson, ident=ident)
        self.enforce(lesson)
        self.record("lesson", focus, ident=ident, kind=lesson.kind)
        if lesson.kind != "fact" and not lesson.origins:  # what it made of rules itself is no news
            self.replies.append(LessonTaken(lesson))

    def not_kept(self, key: int, why: str) -> None:
        """The store could not keep it."""
        if key in self.pending:
            focus, lesson = self.pending.pop(key)
            if not lesson.origins:
                focus.failure = Failure("not_stored", None, why)

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
