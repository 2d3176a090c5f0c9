"""Answers to questions about the robot itself, as values made of nets; grammars.replies puts them into English."""

from __future__ import annotations

from dataclasses import dataclass

from kernel.action.verdict import Verdict
from kernel.memory.experience import Deed, Source, Trouble
from kernel.memory.inference import Inference
from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Question
from kernel.net.graphlet import Graphlet


@dataclass(frozen=True, slots=True)
class Asked:
    """When the question was asked: wall time, s since 1970, and how far the wall clock is ahead of UTC, s."""

    at_s: float = 0.0
    utc_offset_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Because:
    """Why something was done, is being done, was not done, or may not be done.

    Attributes:
        deed: what is explained; None: no such deed is remembered.
        root: the deed that it is a step of in the end.
        way: the lesson that says how it is done, where it has steps.
        trouble: what stands in the way of a deed that was never attempted.
    """

    question: Question
    asked: Asked
    deed: Deed | None = None
    root: Deed | None = None
    trouble: Trouble | None = None
    way: Lesson | None = None


@dataclass(frozen=True, slots=True)
class Taught:
    """Who taught or told something, when, and in which words.

    Attributes:
        lessons: newest first.
        told: a fact that was told for the session.
        steps: how it was concluded, where nobody told it.
        noticed: the senses say so. born: the robot never had to learn it.
    """

    question: Question
    asked: Asked
    lessons: tuple[Lesson, ...] = ()
    told: Source | None = None
    steps: tuple[Inference, ...] = ()
    noticed: bool = False
    born: bool = False


@dataclass(frozen=True, slots=True)
class Knowledge:
    """What is known about a thing: what was told or noticed, what follows, what was taught."""

    question: Question
    facts: tuple[Graphlet, ...] = ()
    inferred: tuple[Graphlet, ...] = ()
    lessons: tuple[Lesson, ...] = ()


@dataclass(frozen=True, slots=True)
class Lessons:
    """Lessons that answer the question.

    revised: those of them whose words are but a correction of what was taught before.
    """

    question: Question
    lessons: tuple[Lesson, ...] = ()
    revised: tuple[Lesson, ...] = ()


@dataclass(frozen=True, slots=True)
class Abilities:
    """What the robot can do: verbs it was born with, acts that it was taught."""

    born: tuple[str, ...]
    taught: tuple[Graphlet, ...] = ()


@dataclass(frozen=True, slots=True)
class Counted:
    """How often something was done."""

    question: Question
    times: int


@dataclass(frozen=True, slots=True)
class Moment:
    """When something was done; None: not that the robot remembers."""

    question: Question
    asked: Asked
    deed: Deed | None = None


@dataclass(frozen=True, slots=True)
class Extent:
    """How far or how long something was done. deed: None where it was not, as far as the robot remembers."""

    question: Question
    deed: Deed | None = None


@dataclass(frozen=True, slots=True)
class Allowed:
    """Whether an act is allowed. trouble: what forbids it, or stands in its way otherwise."""

    question: Question
    trouble: Trouble | None = None


@dataclass(frozen=True, slots=True)
class PlanStep:
    """One deed of a plan; times from its beginning, s."""

    act: Graphlet
    begin_s: float
    end_s: float
    verdict: Verdict


@dataclass(frozen=True, slots=True)
class Plan:
    """What would be done.

    Attributes:
        steps: deeds of the body and the voice, in the order of their beginning.
        whole_s: until all is over. unfinished: it was still going on when the robot stopped thinking it through.
        trouble: why it would fail or be refused.
    """

    question: Question
    steps: tuple[PlanStep, ...] = ()
    whole_s: float = 0.0
    unfinished: bool = False
    trouble: Trouble | None = None


@dataclass(frozen=True, slots=True)
class Contrary:
    """The words that say the opposite of a word; none where no such word is known."""

    word: str
    contraries: tuple[str, ...] = ()


Explanation = (
    Because
    | Taught
    | Knowledge
    | Lessons
    | Abilities
    | Counted
    | Moment
    | Extent
    | Allowed
    | Plan
    | Contrary
)
