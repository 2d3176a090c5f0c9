"""What the mind wants a person to know, as values made of nets; grammars.replies puts them into English."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from kernel.memory.explanation import Explanation
from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Question, Social
from kernel.net.graphlet import Graphlet

Reason = Literal[
    "no_way",  # no operator applies: "I don't know how to salute"
    "given_up",  # a way to do it that was taught ends in PUNT
    "not_grounded",  # the body has no such direction, thing or word: detail is the word or what was missing
    "prohibited",  # by a lesson (Refused says which)
    "nothing_found",  # no such thing is known
    "no_sense",  # nothing on this body can perceive it
    "nothing_gripped",
    "too_much",  # a limit of the body; detail names it
    "link_lost",
    "stuck",
    "stopped",
    "resource_lost",
    "recursion",
    "too_deep",
    "runaway",  # a loop went round and round and no time passed
    "not_achieved",  # no way known, or none left, to make something so
    "conflict",  # two parts of one play want the same thing; detail names it
    "no_room",
    "not_yours",  # a prohibition of somebody else's: detail is who taught it, "" for the owner
    "not_stored",  # a lesson could not be made durable; detail says why
    "not_so",  # a CHK failed; about says of what
    "not_known",  # a CHK or FIND could not find out; about says what
    "not_answered",  # the person did not say which one is meant; about describes it
    "crashed",  # a grounding function broke; the log has it
]


@dataclass(frozen=True, slots=True)
class LessonTaken:
    """A lesson is durable and in force."""

    lesson: Lesson


@dataclass(frozen=True, slots=True)
class FactTaken:
    """A fact was noted."""

    fact: Graphlet
    about: tuple[Graphlet, ...] = ()


@dataclass(frozen=True, slots=True)
class Refused:
    """An act was vetoed by a prohibition that said nothing itself. because: conclusions that led to it, if any."""

    act: Graphlet
    by: Lesson
    because: tuple[Graphlet, ...] = ()


@dataclass(frozen=True, slots=True)
class Failed:
    """An act came to nothing. act may lack descriptions of its objects; about has them."""

    act: Graphlet | None
    reason: Reason
    detail: str = ""
    about: tuple[Graphlet, ...] = ()


@dataclass(frozen=True, slots=True)
class Answer:
    """Attributes:
    question: what was asked.
    verdict: "yes", "no", "unknown", or "found" for questions with a question word.
    found: what was found, as nets: facts, or names and descriptions of the things asked for.
    """

    question: Question
    verdict: Literal["yes", "no", "unknown", "found"]
    found: tuple[Graphlet, ...] = ()


@dataclass(frozen=True, slots=True)
class AskWhich:
    """Several things fit equally well: which is meant? Handed to parse while it is open.

    Attributes:
        wanted: the description as it was said.
        options: the things, with all that is known of them.
    """

    wanted: Graphlet
    options: tuple[Graphlet, ...]


@dataclass(frozen=True, slots=True)
class Saw:
    """What a look found: the nearest thing, or nothing (distance_m None).

    Attributes:
        bearing_deg: from straight ahead, counterclockwise positive.
        swept: it looked to both sides as well.
    """

    distance_m: float | None
    bearing_deg: float = 0.0
    swept: bool = False


@dataclass(frozen=True, slots=True)
class Met:
    """The speaker is now known under this name, "" forgets him; or the robot is."""

    name: str
    robot: bool = False


@dataclass(frozen=True, slots=True)
class Greeted:
    """Manners returned."""

    social: Social
    name: str = ""


@dataclass(frozen=True, slots=True)
class Halted:
    """Everything was stopped, or all that `about` describes. was_busy: something (of the sort) was going on."""

    was_busy: bool
    about: Graphlet | None = None


@dataclass(frozen=True, slots=True)
class Dropped:
    """A request was given up. request: its words, "" where there was none."""

    request: str


@dataclass(frozen=True, slots=True)
class Resumed:
    """A request that was broken off goes on. request: its words, "" where there was none; afresh: from its start."""

    request: str
    afresh: bool = False


Why = Literal[
    "contradicts", "both", "always_excepted", "only_itself", "denies_itself", "nothing_new"
]


@dataclass(frozen=True, slots=True)
class AskKeep:
    """What is to be done with a lesson that contradicts another one, or can never come to anything?"""

    lesson: Lesson
    why: Why
    other: Lesson | None = None


@dataclass(frozen=True, slots=True)
class KnownAlready:
    """The lesson was in force before; nothing was stored."""

    lesson: Lesson


@dataclass(frozen=True, slots=True)
class LessonDropped:
    """The lesson asked about was not kept."""

    lesson: Lesson


@dataclass(frozen=True, slots=True)
class Revised:
    """The lesson took the place of another."""

    lesson: Lesson


@dataclass(frozen=True, slots=True)
class Forgotten:
    """Lessons taken out of force. about: the act or thing they were asked for by; none: there was nothing to forget.

    resting: how many besides, which were not in force and which only the store can read.
    """

    lessons: tuple[Lesson, ...]
    about: Graphlet | None = None
    resting: int = 0


@dataclass(frozen=True, slots=True)
class TakenBack:
    """A change was undone: lessons that are out of force now, that are in force again, and of their former strength."""

    left: tuple[Lesson, ...] = ()
    entered: tuple[Lesson, ...] = ()
    moved: tuple[Lesson, ...] = ()


@dataclass(frozen=True, slots=True)
class NothingToDo:
    """There is nothing to undo, revise, repeat or answer.

    "motion": it was a motion, which cannot be undone; "inborn": a skill of the body's own, which cannot be forgotten;
    "later": no lesson says how it is to be done next time.
    """

    what: Literal["undo", "revise", "repeat", "answer", "motion", "inborn", "later"]


@dataclass(frozen=True, slots=True)
class FeedbackTaken:
    """Praise or blame; lesson: whose preference it moved, if any."""

    good: bool
    lesson: Lesson | None = None


Reply = (
    LessonTaken
    | FactTaken
    | Refused
    | Failed
    | Answer
    | AskWhich
    | Saw
    | Met
    | Greeted
    | Halted
    | Dropped
    | Resumed
    | Explanation
    | AskKeep
    | KnownAlready
    | LessonDropped
    | Revised
    | Forgotten
    | TakenBack
    | NothingToDo
    | FeedbackTaken
)
