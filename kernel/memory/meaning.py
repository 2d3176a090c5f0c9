"""What an utterance can mean: made by grammars.forms, taken by the mind. Stateless: kind and words alone."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from kernel.action.chain import Chain
from kernel.memory.lesson import LessonKind, Operator, Rule
from kernel.net.graphlet import Graphlet


@dataclass(frozen=True, slots=True)
class Command:
    """Do it now. Look-ups of the things mentioned stand in the chain as FIND before the DO that needs them."""

    chain: Chain


@dataclass(frozen=True, slots=True)
class Fact:
    """Something is so. Look-ups ("the block") stand in `finds`, in order; the fact links to their main names."""

    fact: Graphlet
    finds: tuple[Graphlet, ...] = ()


@dataclass(frozen=True, slots=True)
class Teach:
    """A rule or operator to be learned; others: those that the same sentence teaches, "or" tells so: of another thing,
    on another condition."""

    kind: LessonKind
    content: Rule | Operator
    others: tuple[Rule | Operator, ...] = ()

    @property
    def contents(self) -> tuple[Rule | Operator, ...]:
        """All of them."""
        return (self.content, *self.others)

    def kind_of(self, content: Rule | Operator) -> LessonKind:
        """Kind of one of them: what is allowed and what is not may be told in one breath."""
        first = self.content
        if not (isinstance(first, Operator) and isinstance(content, Operator)):
            return self.kind
        if first.trigger.tag == content.trigger.tag:
            return self.kind
        return "permission" if content.trigger.tag == "ALLOW" else "prohibition"


Ask = Literal["what", "where", "who", "howmany", "yesno", "why", "which", "how", "when"]


@dataclass(frozen=True, slots=True)
class Question:
    """Attributes:
    ask: the question word.
    about: what is asked; the graphlet's main node is the predicate, or the thing described.
    wanted: name of the node asked for ("" for yesno).
    topic: "" for what is so; else what the question is about: "identity" (who am I), "doing", "did", "know_about",
        "know_how", "taught", "learned", "happens", "would" ...
    chain: what is supposed to be commanded: "what would you do if I said dance"; what is done on the occasion that it
        is about: "do you dance when I sing".
    """

    ask: Ask
    about: Graphlet
    wanted: str = ""
    topic: str = ""
    chain: Chain | None = None


@dataclass(frozen=True, slots=True)
class Feedback:
    """Praise or blame of what was just done; stop: it also halts what is going on."""

    good: bool
    stop: bool = False


@dataclass(frozen=True, slots=True)
class Identity:
    """The speaker says who he is: "I am Rick"; or what the robot is called. name as said, lower case."""

    name: str
    robot: bool = False


@dataclass(frozen=True, slots=True)
class Social:
    """Greetings and manners."""

    act: Literal["hello", "thanks", "bye", "sorry"]


Act = Literal[
    "stop",
    "cancel",
    "undo",
    "undo_today",
    "forget",
    "keep",
    "replace",
    "resume",
    "repeat",
    "learned",
]


@dataclass(frozen=True, slots=True)
class Control:
    """Steering the robot's mind, not its body.

    Attributes:
        act: "undo_today" takes back all that was changed today; "keep" and "replace" answer what to do with a lesson.
        about: what is to be stopped or forgotten: an act, or a thing that facts are about.
        lessons: numbers of the lessons to be forgotten, where these were given instead.
        told: the lesson or fact to be forgotten, told again.
        more: further acts to be forgotten.
    """

    act: Act
    about: Graphlet | None = None
    lessons: tuple[int, ...] = ()
    told: Teach | Fact | None = None
    more: tuple[Graphlet, ...] = ()


@dataclass(frozen=True, slots=True)
class Choice:
    """The answer to "which one": a description of the thing meant. Understood only while that is asked."""

    described: Graphlet


Beside = Literal["", "before", "after"]


@dataclass(frozen=True, slots=True)
class Revision:
    """A correction of the last command or lesson.

    Do this (chain) instead of that (instead_of), or when doing that verb (of): first, or last; or beside that, which
    stays: before or after it. A chain of nothing but KEEP is what is to be so meanwhile. Later: not now, but next time.
    Moved: the step that the chain tells is in the lesson already and goes there; beside nothing, the two change places.
    """

    chain: Chain
    instead_of: Graphlet | None = None
    of: Graphlet | None = None
    last: bool = False
    beside: Beside = ""
    later: bool = False
    moved: bool = False


Meaning = (
    Command | Fact | Teach | Question | Feedback | Identity | Social | Control | Choice | Revision
)


@dataclass(frozen=True, slots=True)
class Utterance:
    """What was heard or typed.

    Attributes:
        text: the words, as typed or as recognised.
        speaker: name of the person, "" if not identified.
        at_s: wall time of its end, s since 1970.
        confidence: 0 to 1; 1 for typed text.
        alternatives: other hypotheses, best first.
        candidates: where the voice is one of several known ones, their names; speaker is "" then.
    """

    text: str
    speaker: str = ""
    at_s: float = 0.0
    confidence: float = 1.0
    alternatives: tuple[str, ...] = ()
    candidates: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Heard:
    """An utterance with its meaning: what reaches the mind."""

    utterance: Utterance
    meaning: Meaning
