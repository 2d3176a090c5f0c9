"""Random use of the robot in English: lessons, commands, questions, management, stops, and a world that changes.

Used by the robustness test and by benchmarks/soak.py. The same random source gives the same lines.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Final, Literal

from grammars.errors import NotUnderstoodError
from grammars.knowledge import born
from grammars.parse import parse
from grammars.vocabulary import Vocabulary, from_policy
from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Meaning, Teach
from kernel.memory.reply import AskKeep, AskWhich

VERBS: Final = ("florp", "blick", "dance", "zaggle", "wiggle", "salute")
PERSONS: Final = ("mary", "rick", "olga", "")
NAMES: Final = ("mary", "rick", "janey")
KINDS: Final = ("girl", "person", "block", "cup", "cat")
QUALITIES: Final = ("red", "heavy", "happy", "empty")
SKILLS: Final = (
    "drive forward", "drive backward slowly", "turn left", "turn right", "raise the lift", "lower the lift",
    "say hello", "say I am here", "grab the block", "release it", "open the gripper", "wait one second", "stop",
    "turn left twice", "drive forward very slowly", "find out what is near", "turn left while saying excuse me",
    "drive forward and turn left", "grab a red block", "stop turning",
)  # fmt: skip
STATES: Final = (
    "something is very close", "something is close", "you are holding something", "the light is green",
    "mary is near", "janey is happy", "a cup is empty", "nothing is close", "a block is red",
)  # fmt: skip
FORBIDDEN: Final = "never turn right"  # taught by the owner at the start: nobody else may lift it
VETO: Final = 10**9  # its number, out of the way of those that a store gives
OWNER: Final = "olga"
MOST_KEPT: Final = 512  # sentences whose meanings are remembered

Do = Literal["say", "stop", "feel", "wait", "store", "link", "reach", "battery", "restart", "clear"]


@dataclass(frozen=True, slots=True)
class Line:
    """One thing that happens.

    Attributes:
        do: "say" the text; "stop" on the wire; "feel": the range changes; "wait"; "store": how long it takes, or that
            it fails; "link": it breaks or comes back; "reach": whether there is something to grip; "battery";
            "restart": the mind begins anew from what was stored; "clear": the owner has old lessons and
            everything that is forbidden forgotten.
        text, speaker, candidates: what is said, by whom, and between whom that is unsure.
        value: range in m (0: nothing), time in s, volts, or 0 for down and 1 for up; below 0 the store fails;
            how many of the newest lessons stay.
        after_s: how much time passes before the next line.
    """

    do: Do
    text: str = ""
    speaker: str = ""
    candidates: tuple[str, ...] = ()
    value: float = 0.0
    after_s: float = 2.0


def a_line(chance: random.Random, restarts: bool = True) -> Line:
    """One thing that happens; speakers are anybody but the owner."""
    sort = chance.random()
    if sort < 0.05:
        return Line("stop")
    if sort < 0.17:
        return Line("feel", value=chance.choice((0.0, 0.03, 0.04, 0.1, 0.2, 0.35)))
    if sort < 0.25:
        return Line("wait", value=chance.choice((0.1, 0.1, 1.0, 5.0, 35.0)))
    if sort < 0.31:
        return _trouble(chance, restarts)
    if sort < 0.33:
        return Line("clear", value=chance.choice((50, 100, 200)))
    text, after_s = _sentence(chance), chance.choice((0.0, 0.1, 0.5, 2.0, 2.0, 4.0))
    if chance.random() < 0.05:
        return Line("say", text, candidates=tuple(chance.sample(NAMES, 2)), after_s=after_s)
    return Line("say", text, chance.choice([p for p in PERSONS if p != OWNER]), after_s=after_s)


def _trouble(chance: random.Random, restarts: bool) -> Line:
    """The world around the mind fails, or works again."""
    sort = chance.random()
    if sort < 0.35:
        return Line("store", value=chance.choice((0.0, 0.0, 0.3, 1.5, -1.0)))
    if sort < 0.6:
        return Line("link", value=chance.choice((0.0, 1.0, 1.0)))
    if sort < 0.8:
        return Line("reach", value=chance.choice((0.0, 1.0)))
    if sort < 0.9 or not restarts:
        return Line("battery", value=chance.choice((7.4, 6.2)))
    return Line("restart")


class Words:
    """Words for one sentence."""

    def __init__(self, chance: random.Random) -> None:
        self.chance = chance
        self.verb, self.skill, self.state = (self.one(x) for x in (VERBS, SKILLS, STATES))
        self.act = self.one((self.verb, self.verb, self.skill))
        self.kind, self.name, self.quality = (self.one(x) for x in (KINDS, NAMES, QUALITIES))
        self.negation = self.one(("", "not "))

    def one(self, options: tuple[str, ...]) -> str:
        return self.chance.choice(options)

    @property
    def other_verb(self) -> str:
        return self.one(VERBS)

    @property
    def other_skill(self) -> str:
        return self.one(SKILLS)

    @property
    def other_state(self) -> str:
        return self.one(STATES)

    @property
    def other_kind(self) -> str:
        return self.one(KINDS)

    @property
    def thing(self) -> str:
        return self.one((f"the {self.kind}", f"a {self.quality} {self.kind}", self.name, "it"))


Form = Callable[[Words], str]
COMMANDS: Final[tuple[Form, ...]] = (
    lambda w: w.act,
    lambda w: w.act,
    lambda w: w.verb,
    lambda w: f"{w.verb} slowly",
    lambda w: f"{w.act} then {w.skill}",
    lambda w: f"{w.verb} and say go",
    lambda w: f"grab {w.name}",
    lambda w: f"{w.one(('grab', 'lift', 'release'))} {w.thing}",
    lambda w: f"go to the {w.kind}",
    lambda w: f"{w.skill} until {w.state}",
    lambda w: f"{w.verb} until {w.state}",
    lambda w: f"{w.act} while {w.state}",
    lambda w: f"wait until {w.state}",
    lambda w: f"repeat {w.act} then {w.skill} three times",
    lambda w: f"repeat {w.act} 100 times",
    lambda w: (
        f"keep {w.one(('turning left', 'driving forward', 'the gripper closed', 'backing up'))}"
    ),
    lambda w: f"keep turning left until {w.state}",
    lambda w: "keep the gripper closed while driving forward",
    lambda w: f"grab each {w.kind}",
    lambda w: f"for every {w.kind} {w.act} then say next",
    lambda w: "make sure the gripper is closed",
    lambda w: f"make sure {w.state}",
    lambda w: f"find out whether {w.state}",
    lambda w: f"check whether {w.state} then {w.act}",
    lambda w: f"find out what color the {w.kind} is",
    lambda w: " then ".join(w.other_skill for _ in range(8)),
)
LESSONS: Final[tuple[Form, ...]] = (
    lambda w: f"to {w.verb} {w.act}",
    lambda w: f"to {w.verb} {w.skill} then {w.other_verb}",
    lambda w: f"to {w.verb} you could {w.skill}",
    lambda w: f"to {w.verb} you must always {w.other_verb}",
    lambda w: f"another way to {w.verb} is to {w.skill}",
    lambda w: f"to {w.verb} repeat {w.skill} two times",
    lambda w: f"to {w.verb} something grab it then {w.act}",
    lambda w: f"if {w.state} then {w.act}",
    lambda w: f"when {w.state} {w.skill} unless {w.other_state}",
    lambda w: f"when {w.state} stop",
    lambda w: f"when {w.state} say {w.quality}",
    lambda w: f"before you {w.act} {w.skill}",
    lambda w: f"after you {w.verb} {w.skill}",
    lambda w: f"you may {w.act}",
    lambda w: f"you can {w.act} if {w.state}",
    lambda w: f"if you fail to {w.verb} {w.act}",
    lambda w: "if you fail to grab something say oops",
    lambda w: f"if something is a {w.kind} it is a {w.other_kind}",
    lambda w: f"{w.kind}s are {w.one(('', 'usually ', 'not ', 'definitely '))}{w.quality}",
    lambda w: f"if something is {w.quality} and it is a {w.kind} then it is a {w.other_kind}",
    lambda w: f"{w.verb} means {w.one((*VERBS, 'turn', 'drive'))}",
    lambda w: f"{w.one(('crimson', *QUALITIES))} is the same as {w.quality}",
    lambda w: f"to find out whether {w.state} {w.act}",
    lambda w: f"to find a {w.kind} {w.act}",
    lambda w: "if you want to know what color something is look at it",
    lambda w: "to find out what something is find out what color it is",
    lambda w: f"to make sure the gripper is closed {w.one(('close the gripper', w.act))}",
)
VETOES: Final[tuple[Form, ...]] = (
    lambda w: f"never {w.act}",
    lambda w: f"never {w.act} but instead {w.skill}",
    lambda w: f"never {w.verb} if {w.state}",
    lambda w: f"never grab a {w.kind} unless it is {w.quality}",
)
DISTRUST: Final[tuple[Form, ...]] = (
    lambda w: f"if {w.name} tells you to do something don't but instead {w.act}",
    lambda w: f"only {w.name} may tell you to {w.act}",
    lambda w: f"don't let {w.name} teach you",
)
FACTS: Final[tuple[Form, ...]] = (
    lambda w: f"{w.name} is a {w.kind}",
    lambda w: f"the {w.kind} is {w.negation}{w.quality}",
    lambda w: f"{w.name} is {w.negation}{w.quality}",
    lambda w: f"there is a {w.quality} {w.kind}",
    lambda w: "the light is green",
    lambda w: f"{w.name} has a {w.quality} {w.kind}",
    lambda w: f"this {w.kind} is called pookie",
    lambda w: f"the {w.kind} is {w.name}'s",
)
MANAGEMENT: Final[tuple[Form, ...]] = (
    lambda w: f"forget how to {w.verb}",
    lambda w: f"forget that {w.name} is a {w.kind}",
    lambda w: f"forget what i told you about {w.name}",
    lambda w: "forget the last lesson",
    lambda w: "undo that",
    lambda w: "undo everything from today",
    lambda w: w.one(("good robot", "bad robot", "hey, stop that", "well done")),
    lambda w: w.one(("never mind", "go on", "stop turning", "stop driving", "repeat that", "stop")),
    lambda w: f"no, {w.skill} instead of turning left",
    lambda w: f"no {w.act} instead",
    lambda w: f"{w.skill} instead of driving forward",
    lambda w: f"when you {w.verb} {w.skill} first",
    lambda w: f"when you {w.verb} {w.act} at the end",
    lambda w: "not the red one the blue one",
    lambda w: w.one(("keep both", "replace it", "cancel")),
    lambda w: w.one(("the red one", "red", "the block", "the one on the left")),
)
QUESTIONS: Final[tuple[Form, ...]] = (
    lambda w: w.one(
        ("why did you do that", "why not", "what are you doing", "what did you just do")
    ),
    lambda w: w.one(("why did you turn left", f"why didn't you {w.act}", f"did you {w.act}")),
    lambda w: w.one((f"when did you {w.verb}", "how many times did you turn")),
    lambda w: f"why is {w.name} a {w.kind}",
    lambda w: "what did you learn today",
    lambda w: w.one((f"how do you {w.verb}", f"do you know how to {w.act}")),
    lambda w: w.one((f"who taught you to {w.verb}", f"when did you learn to {w.verb}")),
    lambda w: f"who told you that {w.name} is a {w.kind}",
    lambda w: f"who told you not to {w.act}",
    lambda w: w.one((f"are you allowed to {w.act}", "what are you not allowed to do")),
    lambda w: f"what do you know about {w.one((w.name, f'the {w.kind}'))}",
    lambda w: f"what would you do if i said {w.act}",
    lambda w: f"show me what you would do if {w.state}",
    lambda w: w.one((f"what happens when {w.state}", f"what happens before you {w.act}")),
    lambda w: f"is {w.name} a {w.kind}",
    lambda w: f"is the {w.kind} {w.quality}",
    lambda w: w.one(
        (f"who is {w.name}", f"where is the {w.kind}", f"which {w.kind} is {w.quality}")
    ),
    lambda w: f"how many {w.kind}s are there",
    lambda w: w.one(
        ("who am i", "what can you do", "are you turning", f"are you holding a {w.kind}")
    ),
)
MANNERS: Final[tuple[Form, ...]] = (
    lambda w: w.one(("i am rick", "my name is mary", "this is mary speaking")),
    lambda w: w.one(("hello robot", "thank you", "see you later")),
    lambda w: "colorless green ideas sleep furiously",
)
SORTS: Final = (
    (0.32, COMMANDS),
    (0.21, LESSONS),
    (0.03, VETOES),
    (0.01, DISTRUST),
    (0.11, FACTS),
    (0.17, MANAGEMENT),
    (0.13, QUESTIONS),
    (0.03, MANNERS),
)


def _sentence(chance: random.Random) -> str:
    (forms,) = chance.choices([forms for _, forms in SORTS], [weight for weight, _ in SORTS])
    return chance.choice(forms)(Words(chance))


@lru_cache(1)
def vocabulary() -> Vocabulary:
    """As if every verb of the session had been taught."""
    words = tuple(parse(f"to {verb} drive forward").meaning for verb in VERBS)
    return from_policy([Lesson(1, "procedure", w.content) for w in words if isinstance(w, Teach)])


@lru_cache(MOST_KEPT)
def understood(text: str) -> Meaning | None:
    """What a sentence means; None where it means nothing."""
    return answered(text, None)


def answered(text: str, expecting: AskWhich | AskKeep | None) -> Meaning | None:
    """The same while a question is open."""
    try:
        return parse(text, vocabulary(), expecting).meaning
    except NotUnderstoodError:
        return None


def at_birth() -> list[Lesson]:
    """What the robot of a session starts with: born knowledge, and what its owner forbids."""
    meaning = understood(FORBIDDEN)
    assert isinstance(meaning, Teach)
    return [*born(), Lesson(VETO, meaning.kind, meaning.content, FORBIDDEN, OWNER)]
