"""What is neither lesson, command nor question: manners, praise, names, steering and corrections."""

from __future__ import annotations

from typing import Final

from grammars.render.deeds import deed
from grammars.render.procedures import procedure
from grammars.render.telling import Telling, Voice
from grammars.render.things import pronoun, proper, thing
from kernel.memory.meaning import Control, Feedback, Identity, Revision, Social

_MANNERS: Final = {"hello": "hello", "thanks": "thank you", "bye": "goodbye", "sorry": "sorry"}
_STEERING: Final = {
    "stop": "stop",
    "cancel": "never mind",
    "undo": "undo that",
    "forget": "forget that",
    "resume": "go on",
    "repeat": "repeat that",
    "learned": "what did you learn today",
}


def social(meaning: Feedback | Identity | Social, voice: Voice) -> str:
    """Manners, praise and blame, and names, as they are said to the robot."""
    match meaning:
        case Identity(name):
            return f"{'you are' if voice == 'robot' else 'I am'} {proper(name)}"
        case Social(act):
            return _MANNERS[act]
        case Feedback(good, stop):
            return "hey, stop that" if stop else "good robot" if good else "bad robot"


def control(meaning: Control, voice: Voice) -> str:
    """Steering, with what it is about: "forget how to dance", "stop turning"."""
    if meaning.about is None:
        return _STEERING[meaning.act]
    telling = Telling((meaning.about,), (), voice)
    main = meaning.about.main
    if meaning.act == "stop":
        return f"stop {deed(telling, main, 'gerund')}"
    return f"forget how to {deed(telling, main)}"


def revision(meaning: Revision, voice: Voice) -> str:
    """A correction: "no, turn right instead of turning left"."""
    found = [d.graphlet for d in meaning.chain.directives() if d.graphlet]
    known = [g for g in (*found, meaning.instead_of, meaning.of) if g is not None]
    telling = Telling(tuple(known), (), voice)
    steps = procedure(telling, meaning.chain)
    old = meaning.instead_of
    if meaning.of is not None:
        return f"when {pronoun(telling, 'you', 'subject')} {deed(telling, meaning.of.main)}, {steps} first"
    if old is None:
        return f"no, {steps} instead"
    if telling.term(old.main).kind == "act":
        return f"no, {steps} instead of {deed(telling, old.main, 'gerund')}"
    return f"not {thing(telling, old.main)}, {thing(telling, found[-1].main) if found else steps}"
