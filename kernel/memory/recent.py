"""What the talk was about last (all ours): what "that" means to a person who praises, corrects, repeats or undoes, how
a fact was told, and the doubt about a lesson that a person is asked to settle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Literal

from kernel.memory.explanation import Taught
from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Command, Fact
from kernel.memory.reply import Answer, AskKeep, FeedbackTaken, Greeted, Reply, Why
from kernel.net.graphlet import Graphlet
from kernel.net.node import Node

if TYPE_CHECKING:
    from kernel.memory.attention import Focus

PATIENCE_S: Final = 30.0  # mind.md: how long an open question waits


@dataclass(frozen=True, slots=True)
class Saying:
    """A fact as it was told, and the things that it was about."""

    fact: Fact
    about: Mapping[str, Node]


@dataclass(slots=True, eq=False)
class Doubt:
    """What to do with a lesson: the robot has asked, and the question is open.

    Attributes:
        focus: number of the focus that waits for the answer.
        answer: "" while it is open.
    """

    lesson: Lesson
    why: Why
    other: Lesson | None
    focus: int
    answer: Literal["", "keep", "replace", "cancel"] = ""

    @property
    def question(self) -> AskKeep:
        """As it is put."""
        return AskKeep(self.lesson, self.why, self.other)


@dataclass(slots=True)
class Recent:
    """The last things that were done.

    Attributes:
        thing: the last thing: a command, one that has moved the body, or a change of what is known.
        command: the last one, and its focus.
        deed: the operator that the last DO or reaction was begun with.
        reply: the last one that said something; answered: it came after the last command.
        claim: what was last said to be so, or not so, for as long as only that is talked about;
            claim_s: when, monotonic.
    """

    thing: Literal["", "command", "motion", "change"] = ""
    command: Command | None = None
    focus: Focus | None = None
    deed: Lesson | None = None
    reply: Reply | None = None
    answered: bool = False
    claim: Graphlet | None = None
    claim_s: float = 0.0

    def begin(self, command: Command, focus: Focus) -> None:
        """A command is being carried out."""
        self.thing, self.command, self.focus = "command", command, focus
        self.deed, self.answered = None, False

    def say(self, replies: list[Reply], now_s: float) -> None:
        """Something was replied; manners and thanks are nothing to say again."""
        for reply in replies:
            if not isinstance(reply, Greeted | FeedbackTaken):
                self.reply, self.answered = reply, True
            if isinstance(reply, Answer) and not reply.question.topic:
                about = reply.question.about
                self.claim = {"yes": about, "no": about.denied()}.get(reply.verdict)
                self.claim_s = now_s
            elif not isinstance(reply, Taught):
                self.claim = None
