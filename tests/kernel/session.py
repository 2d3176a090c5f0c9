"""Random use of the robot in English: lessons, commands, questions, management, stops, and a world that changes.

Used by the robustness test and by benchmarks/soak.py. The same random source gives the same lines.
"""

from __future__ import annotations

import random
from dataclasses import dataclass
from functools import cache
from typing import Final

from grammars.errors import NotUnderstoodError
from grammars.parse import parse
from grammars.vocabulary import Vocabulary, from_policy
from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Meaning, Teach

VERBS: Final = ("florp", "blick", "dance", "zaggle", "wiggle", "salute")
PERSONS: Final = ("mary", "rick", "olga", "")
NAMES: Final = ("mary", "rick", "janey")
KINDS: Final = ("girl", "person", "block", "cup", "cat")
QUALITIES: Final = ("red", "heavy", "happy", "empty")
SKILLS: Final = (
    "drive forward", "drive backward slowly", "turn left", "turn right", "raise the lift", "lower the lift",
    "say hello", "say I am here", "grab the block", "release it", "open the gripper", "wait one second", "stop",
)  # fmt: skip
STATES: Final = (
    "something is very close", "something is close", "you are holding something", "the light is green",
    "mary is near", "janey is happy", "a cup is empty",
)  # fmt: skip
FORBIDDEN: Final = "never turn right"  # taught by the owner at the start: nobody else may lift it
OWNER: Final = "olga"


@dataclass(frozen=True, slots=True)
class Line:
    """do: "say", "stop", "feel" or "wait"; text: the sentence; speaker; value: metres of range (0: nothing), or s."""

    do: str
    text: str = ""
    speaker: str = ""
    value: float = 0.0


def a_line(chance: random.Random) -> Line:
    """One thing that happens."""
    sort = chance.random()
    if sort < 0.05:
        return Line("stop")
    if sort < 0.20:
        return Line("feel", value=chance.choice((0.0, 0.03, 0.04, 0.1, 0.2, 0.35)))
    if sort < 0.30:
        return Line("wait", value=chance.choice((0.1, 1.0, 5.0, 35.0)))
    return Line("say", _sentence(chance), chance.choice([p for p in PERSONS if p != OWNER]))


def _sentence(chance: random.Random) -> str:
    def one(options: tuple[str, ...]) -> str:
        return chance.choice(options)

    verb, skill, state = one(VERBS), one(SKILLS), one(STATES)
    act = one((verb, verb, skill))
    forms = (
        lambda: act,
        lambda: act,
        lambda: f"{verb} slowly",
        lambda: f"{act} then {skill}",
        lambda: f"{verb} and say go",
        lambda: f"grab {one(NAMES)}",
        lambda: f"to {verb} {act}",
        lambda: f"to {verb} {skill} then {one(VERBS)}",
        lambda: f"to {verb} you could {skill}",
        lambda: f"to {verb} repeat {skill} two times",
        lambda: f"if {state} then {act}",
        lambda: f"when {state} {skill} unless {one(STATES)}",
        lambda: f"before you {act} {skill}",
        lambda: f"after you {verb} {skill}",
        lambda: f"never {act}",
        lambda: f"never {act} but instead say no",
        lambda: f"never {verb} if {state}",
        lambda: f"you may {act}",
        lambda: f"you can {act} if {state}",
        lambda: f"if {one(NAMES)} tells you to do something don't but instead say no",
        lambda: f"if something is a {one(KINDS)} it is a {one(KINDS)}",
        lambda: f"{one(KINDS)}s are usually {one(QUALITIES)}",
        lambda: f"{verb} means {one(VERBS)}",
        lambda: f"{one(NAMES)} is a {one(KINDS)}",
        lambda: f"the {one(KINDS)} is {one(('', 'not '))}{one(QUALITIES)}",
        lambda: "the light is green",
        lambda: f"{skill} until {state}",
        lambda: f"{verb} until {state}",
        lambda: f"repeat {act} then {skill} three times",
        lambda: f"keep {one(('turning left', 'driving forward', 'the gripper closed'))}",
        lambda: "make sure the gripper is closed",
        lambda: f"find out whether {state}",
        lambda: f"to find out whether {state} {skill}",
        lambda: f"forget how to {verb}",
        lambda: one(("undo that", "undo that", "forget that", "undo everything from today")),
        lambda: one(("good robot", "bad robot", "hey, stop that")),
        lambda: one(("never mind", "go on", "stop turning", "repeat that")),
        lambda: f"no, {skill} instead of turning left",
        lambda: one(("why did you do that", "what are you doing", "what did you just do")),
        lambda: one(
            ("what did you learn today", f"how do you {verb}", f"who taught you to {verb}")
        ),
        lambda: f"what do you know about {one(NAMES)}",
        lambda: f"what would you do if i said {act}",
        lambda: f"is {one(NAMES)} a {one(KINDS)}",
        lambda: one(("keep both", "replace it", "cancel", "the red one")),
        lambda: one(("i am rick", "my name is mary", "hello robot", "thank you")),
    )
    return chance.choice(forms)()


@cache
def vocabulary() -> Vocabulary:
    """As if every verb of the session had been taught."""
    words = tuple(parse(f"to {verb} drive forward").meaning for verb in VERBS)
    return from_policy([Lesson(1, "procedure", w.content) for w in words if isinstance(w, Teach)])


@cache
def understood(text: str) -> Meaning | None:
    """What a sentence means; None where it means nothing."""
    try:
        return parse(text, vocabulary()).meaning
    except NotUnderstoodError:
        return None
