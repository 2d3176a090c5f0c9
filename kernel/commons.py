"""What every running focus shares with the mind."""

from __future__ import annotations

import random
from collections.abc import Container, Generator
from dataclasses import dataclass, field, replace
from typing import Final, Literal

from kernel.action.arbiter import Claim
from kernel.action.call import Bid, Tick
from kernel.action.trace import Record, What
from kernel.memory.attention import Attention, Failure, Focus, Progress
from kernel.memory.change import SESSION, Change
from kernel.memory.experience import Experience
from kernel.memory.lesson import Content, Lesson, Operator, Resting, Rule
from kernel.memory.likeness import covers
from kernel.memory.operators import Operators
from kernel.memory.policy import Policy, Shift
from kernel.memory.recent import Doubt, Recent, Saying
from kernel.memory.reply import LessonTaken, Reason, Reply
from kernel.memory.settings import Settings
from kernel.memory.shelves import Shelves
from kernel.memory.which import Which
from kernel.memory.working import TOLD_LIMIT, WorkingMemory
from kernel.net.graphlet import Graphlet
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
        which: the open question, put by the robot, which thing is meant.
        policy: what is in force of all that was learned; facts: the node of each stored fact in force, by lesson.
        resting: stored lessons that cannot be in force.
        shelves: lessons in force by what they might be equal to or contradict.
        sayings: how the facts of the session were told, by lesson.
        pending: changes the store has not answered for: the focus each came from, and the whole change, by key.
        doubt: the open question, put by the robot, what to do with a doubtful lesson; recent: what was done last.
        struck: tickets that must end at their next turn, and why: "ended" as if they were done, "stopped" for good,
            all other reasons as failures.
        doing: every DO under way; begun: acts that are to be noted, as they begin.
        spoken: the nodes of the last utterance's words, and its focus.
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
    which: Which | None = None
    shift: Shift = field(default_factory=Shift)
    pending: dict[int, tuple[Focus, Change]] = field(default_factory=dict)
    shelves: Shelves = field(default_factory=Shelves)
    sayings: dict[int, Saying] = field(default_factory=dict)
    doubt: Doubt | None = None
    recent: Recent = field(default_factory=Recent)
    policy: Policy = field(default_factory=Policy)
    facts: dict[int, Node] = field(default_factory=dict)
    resting: tuple[Resting, ...] = ()
    struck: dict[int, Reason | Literal["ended"]] = field(default_factory=dict)
    doing: list[Doing] = field(default_factory=list)
    begun: list[Node] = field(default_factory=list)
    spoken: list[tuple[Focus, Node]] = field(default_factory=list)
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

    @property
    def news(self) -> Container[Node]:
        """Main nodes of told facts: these do not tell which thing is meant (kernel.memory.inference.told_of)."""
        return self.facts.values()

    def session_number(self) -> int:
        """A fresh number for a lesson or change that is not stored."""
        return SESSION + self.next_number()

    def keep(self, focus: Focus, change: Change) -> int:
        """Ask the store to keep a change of the policy; the key of its answer.

        What is of the session alone counts at once.
        """
        key = self.next_number()
        durable = change.durable()
        if durable is None:
            self._take(focus, replace(change, ident=self.session_number()))
        else:
            self.persist.append((key, durable))
            self.pending[key] = focus, change
        return key

    def commit(self, focus: Focus, change: Change) -> Generator[None, None, bool]:
        """Keep a change and wait until it counts; whether it does."""
        key = self.keep(focus, change)
        while key in self.pending:
            focus.waits.add("store")
            yield
        return focus.failure is None or focus.failure.reason != "not_stored"

    def kept(self, key: int, change: Change) -> None:
        """The change is durable: it counts, even if its focus was stopped meanwhile."""
        if key in self.pending:
            focus, whole = self.pending.pop(key)
            self._take(focus, whole.stored(change))

    def _take(self, focus: Focus, change: Change) -> None:
        shift = self.change(change)
        self.shift += shift.lasting()
        for lesson in shift.entered:
            self.record("lesson", focus, ident=lesson.ident, kind=lesson.kind)
        for lesson in shift.left:
            self.record("retracted", focus, ident=lesson.ident)
        for lesson in shift.moved:
            self.record("adapted", focus, ident=lesson.ident, to=self.policy.strength(lesson))
        if not change.own:
            self.recent.thing = "change"
        if not change.retracted:
            self.replies += [
                LessonTaken(x) for x in change.learned if x.kind != "fact" and not x.origins
            ]

    def not_kept(self, key: int, why: str) -> None:
        """The store could not keep it."""
        if key in self.pending:
            focus, change = self.pending.pop(key)
            if change.own:
                self.record("error", focus, text=f"what I learned myself was not kept: {why}")
            else:
                focus.failure = Failure("not_stored", None, why)

    def may(self, person: str, lesson: Lesson | Resting) -> bool:
        """Whether somebody may lift, forget or undo a prohibition: its teacher or the owner; anybody without owner."""
        owner = self.settings.owner.lower()
        return not (owner and lesson.prohibits) or person.lower() in {
            owner,
            lesson.teacher.lower(),
        } - {""}

    def lifted(self, person: str, content: Content) -> Lesson | None:
        """The prohibition in force that this permission would lift although the person may not.

        Only what the two say of themselves counts here; what inference adds is looked at when acting
        (kernel/selecting.py).
        """
        if not (isinstance(content, Operator) and content.trigger.tag == "ALLOW"):
            return None
        allowed = content.trigger.graphlet
        for veto in self.lessons.values() if self.settings.owner else ():
            if isinstance(veto.content, Operator) and veto.content.prohibits:
                forbidden = veto.content.trigger.graphlet
                if allowed is None or forbidden is None or self.may(person, veto):
                    continue
                pair = (forbidden, (allowed,), allowed), (allowed, (forbidden,), forbidden)
                if any(covers(*one) for one in pair):
                    return veto
        return None

    def not_yours(self, lesson: Lesson | Resting) -> Failure:
        """Why somebody may not do so; the owner is not named beside himself."""
        owners = lesson.teacher.lower() == self.settings.owner.lower()
        return Failure("not_yours", None, "" if owners else lesson.teacher)

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
        for lesson in (*shift.entered, *shift.moved):
            self._strengthen(lesson)
        self.memory.changed()
        return shift

    def note(self, ident: int, saying: Saying) -> None:
        """Remember how a fact of the session was told; beyond the bound the oldest are lost."""
        self.sayings[ident] = saying
        while len(self.sayings) > TOLD_LIMIT:
            oldest = next(iter(self.sayings))
            del self.sayings[oldest]
            if (lesson := self.lessons.get(oldest)) is not None:
                self._retire(lesson)
            self.policy.lose(oldest)

    def _strengthen(self, lesson: Lesson) -> None:
        """An adapted belief takes effect; preferences are asked for when operators are chosen."""
        if isinstance(lesson.content, Rule):
            self.memory.rules.believe(lesson, self.policy.strength(lesson))

    def _enforce(self, lesson: Lesson) -> None:
        self.shelves.add(lesson)
        if isinstance(lesson.content, Rule):
            self.memory.rules.add(lesson)
        elif isinstance(lesson.content, Operator):
            self.operators.add(lesson)
        else:
            self.facts[lesson.ident] = self._recall(lesson.ident, lesson.content)

    def _recall(self, ident: int, fact: Graphlet) -> Node:
        """Take a fact for true, of the very things it was told of as long as they are in memory."""
        saying = self.sayings.get(ident)
        if saying is None or not all(node in self.memory.net for node in saying.about.values()):
            return self.memory.recall_fact(fact)
        _, carrying = self.memory.tell(saying.fact.fact, dict(saying.about))
        return carrying[0]

    def _retire(self, lesson: Lesson) -> None:
        self.shelves.remove(lesson)
        if isinstance(lesson.content, Rule):
            self.memory.rules.remove(lesson)
        elif isinstance(lesson.content, Operator):
            self.operators.remove(lesson)
        else:
            node, saying = self.facts.pop(lesson.ident), self.sayings.get(lesson.ident)
            if saying is not None and node in saying.about.values():
                self.memory.told.pop(node, None)  # a name given to a thing: the thing itself stays
            else:
                self.memory.retract(node)
