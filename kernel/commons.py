"""What every running focus shares with the mind."""

from __future__ import annotations

import random
from dataclasses import dataclass, field
from typing import Final, Literal

from kernel.action.arbiter import Claim
from kernel.action.call import Bid, Tick
from kernel.action.trace import Record, What
from kernel.memory.asking import Asking
from kernel.memory.attention import Attention, Failure, Focus, Progress
from kernel.memory.change import Change
from kernel.memory.experience import Experience
from kernel.memory.lesson import Lesson, Operator, Rule
from kernel.memory.operators import Operators
from kernel.memory.policy import Policy, Shift
from kernel.memory.reply import LessonTaken, Reason, Reply
from kernel.memory.settings import Settings
from kernel.memory.working import WorkingMemory
from kernel.net.node import Node

STEPS_A_TICK: Final = 1000  # mind.md: then a tick yields and logs


@dataclass(slots=True, eq=False)
class Doing:
    """A DO under way: for which focus, its act; stopped: it ends at its next turn (kernel.stopping)."""

    focus: Focus
    node: Node
    stopped: bool = False


@dataclass(slots=True)
class Commons:
    """Memory, policy, the present, and what this tick brings forth.

    Attributes:
        attention: all foci.
        asking: which thing is meant: the question that is open.
        policy: what is in force of all that was learned; facts: the node of each stored fact in force, by lesson.
        pending: changes the store has not answered for: the focus each came from, by key.
        struck: tickets that must end at their next turn, and why: "ended" as if they were done, "stopped" for good,
            all other reasons as failures.
        doing: every DO under way.
        interrupted: commands that a stop or a cancel broke off, the one to go on with last (kernel.steering).
        steps: directives carried out in this tick.
        experience: what was done, and who told what.
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
    persist: list[tuple[int, Change]] = field(default_factory=list)
    attention: Attention = field(default_factory=Attention)
    asking: Asking | None = None
    shift: Shift = field(default_factory=Shift)
    pending: dict[int, Focus] = field(default_factory=dict)
    policy: Policy = field(default_factory=Policy)
    facts: dict[int, Node] = field(default_factory=dict)
    struck: dict[int, Reason | Literal["ended"]] = field(default_factory=dict)
    doing: list[Doing] = field(default_factory=list)
    interrupted: list[Progress] = field(default_factory=list)
    tickets: int = 0
    steps: int = 0
    experience: Experience = field(default_factory=Experience)

    def next_number(self) -> int:
        """A fresh number for a ticket or a pending lesson."""
        self.tickets += 1
        return self.tickets

    @property
    def out_of_breath(self) -> bool:
        """So much was done in this tick that the rest has to wait for the next."""
        return self.steps >= STEPS_A_TICK

    def record(self, what: What, focus: Focus | None, **data: object) -> None:
        """Leave a trace record."""
        number, words = (focus.number, focus.words) if focus else (0, "")
        self.trace.append(Record(self.tick.now_s, what, number, words, data))

    @property
    def lessons(self) -> dict[int, Lesson]:
        """Lessons in force, by number."""
        return self.policy.lessons

    def keep(self, focus: Focus, change: Change) -> int:
        """Ask the store to keep a change of the policy; the key of its answer."""
        key = self.next_number()
        self.persist.append((key, change))
        self.pending[key] = focus
        return key

    def kept(self, key: int, change: Change) -> None:
        """The change is durable: it counts, even if its focus was stopped meanwhile."""
        if key not in self.pending:
            return
        focus = self.pending.pop(key)
        shift = self.change(change)
        self.shift += shift
        for lesson in shift.entered:
            self.record("lesson", focus, ident=lesson.ident, kind=lesson.kind)
        for lesson in shift.left:
            self.record("retracted", focus, ident=lesson.ident)
        self.replies += [
            LessonTaken(x) for x in change.learned if x.kind != "fact" and not x.origins
        ]

    def not_kept(self, key: int, why: str) -> None:
        """The store could not keep it."""
        if key in self.pending:
            self.pending.pop(key).failure = Failure("not_stored", None, why)

    def bear(self, lesson: Lesson) -> None:
        """Put a lesson in force that was there from the start."""
        self.policy.bear(lesson)
        self._enforce(lesson)

    def change(self, change: Change) -> Shift:
        """Let a stored change take effect."""
        shift = self.policy.apply(change)
        for lesson in shift.left:
            self._retire(lesson)
        for lesson in shift.entered:
            self._enforce(lesson)
        self.memory.changed()
        return shift

    def _enforce(self, lesson: Lesson) -> None:
        if isinstance(lesson.content, Rule):
            self.memory.rules.add(lesson)
        elif isinstance(lesson.content, Operator):
            self.operators.add(lesson)
        else:
            self.facts[lesson.ident] = self.memory.recall_fact(lesson.content)

    def _retire(self, lesson: Lesson) -> None:
        if isinstance(lesson.content, Rule):
            self.memory.rules.remove(lesson)
        elif isinstance(lesson.content, Operator):
            self.operators.remove(lesson)
        else:
            self.memory.retract(self.facts.pop(lesson.ident))
