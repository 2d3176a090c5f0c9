"""What can be learned: rules, operators, facts; and a lesson, which is one of them with its provenance."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final, Literal

from kernel.action.chain import Chain, Directive
from kernel.net.graphlet import Graphlet, Term

# Number of the first operator of the body's own skills; the others are below.
INNATE: Final = -1_000_000
LEARN: Final = "learn"  # the act of taking a lesson or a fact: a person may forbid it as any other
LEARNING: Final = Graphlet((Term("act-1", frozenset((LEARN,))),), "act-1")  # what ADD and EDIT do


@dataclass(frozen=True, slots=True)
class Rule:
    """If the condition holds and none of the exceptions, conclude.

    An alias is a rule whose conclusion describes the condition's main node again, with another lexical item.

    Source: Connell 2019, section 3, figure 3; exceptions ("unless") are ours.
    """

    condition: Graphlet
    conclusion: Graphlet
    unless: tuple[Graphlet, ...] = ()
    belief: float = 1.0

    @property
    def is_alias(self) -> bool:
        """Condition and conclusion name the same node and say nothing else."""
        return self.condition.main == self.conclusion.main and all(
            len(side.terms) == 1 and side.terms[0].lex and not side.terms[0].links
            for side in (self.condition, self.conclusion)
        )


@dataclass(frozen=True, slots=True)
class Operator:
    """When the trigger's directive is posted and the enablement holds, the chain is advice on what to do.

    Attributes:
        trigger: tag and pattern. NOTE: all conditions in one graphlet. DO ANTE POST: the main node is the action, the
            other terms describe its arguments or the speech act it came from. ALLOW: voids prohibitions it matches.
        enablement: patterns that must hold as well.
        unless: patterns that must not hold.
        preference: 1.0 plain, 0.8 "you could", 1.2 "you must always".
        chain: what to do; empty for ALLOW.
    """

    trigger: Directive
    chain: Chain
    enablement: tuple[Graphlet, ...] = ()
    unless: tuple[Graphlet, ...] = ()
    preference: float = 1.0

    @property
    def patterns(self) -> tuple[Graphlet, ...]:
        """What must match for it to apply: its trigger, then its enablement."""
        trigger = self.trigger.graphlet
        return (trigger, *self.enablement) if trigger is not None else self.enablement

    @property
    def does(self) -> Graphlet | None:
        """The act that it says how to do; None for what is no way of doing anything."""
        return self.trigger.graphlet if self.trigger.tag == "DO" else None

    @property
    def prohibits(self) -> bool:
        """An ANTE operator that ends in PUNT."""
        return self.trigger.tag == "ANTE" and any(d.tag == "PUNT" for d in self.chain.directives())

    @property
    def forbids(self) -> bool:
        """It prohibits without looking first: no CHK stands before its PUNT."""
        return self.prohibits and not any(d.tag == "CHK" for d in self.chain.directives())


Content = Rule | Operator | Graphlet  # a Graphlet is a fact


def graphlets(content: Content) -> Iterator[Graphlet]:
    """Every graphlet of it; what is done comes after what is asked for."""
    match content:
        case Graphlet():
            yield content
        case Rule(condition, conclusion, unless):
            yield from (condition, conclusion, *unless)
        case Operator():
            yield from (*content.patterns, *content.unless)
            yield from content.chain.graphlets()


LessonKind = Literal[
    "procedure", "reaction", "before", "after", "prohibition", "permission", "rule", "alias", "fact"
]


@dataclass(frozen=True, slots=True)
class Lesson:
    """One thing the robot was taught.

    Attributes:
        ident: number in the store; 0 before it is stored; negative for what the robot was born with.
        kind: kind of sentence it came from.
        content: the rule, operator or fact: this is the lesson.
        words: the teacher's exact words: this is evidence.
        teacher: name of the person, "" if not identified.
        at_s: wall time, s since 1970.
        origins: numbers of the lessons the robot made it from by itself (chunking); empty for what was taught.
    """

    ident: int
    kind: LessonKind
    content: Content
    words: str = ""
    teacher: str = ""
    at_s: float = 0.0
    origins: tuple[int, ...] = ()

    @property
    def prohibits(self) -> bool:
        """It forbids something."""
        return isinstance(self.content, Operator) and self.content.prohibits

    @property
    def strength(self) -> float:
        """As taught: an operator's preference, a rule's belief, 1 for a fact."""
        match self.content:
            case Operator(preference=preference):
                return preference
            case Rule(belief=belief):
                return belief
        return 1.0


@dataclass(frozen=True, slots=True)
class Resting:
    """A lesson that is kept but not in force, as its content cannot be read or followed any more.

    why: what is wrong with it; change: the one that taught it; the rest as of a lesson.
    """

    ident: int
    words: str
    why: str
    kind: str = ""
    teacher: str = ""
    at_s: float = 0.0
    change: int = 0

    @property
    def prohibits(self) -> bool:
        """It may forbid something: of these kinds are the vetoes (ours: who cannot read it takes it for one)."""
        return self.kind in ("prohibition", "permission")
