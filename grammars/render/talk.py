"""What is neither lesson, command nor question: manners, praise, names, steering and corrections."""

from __future__ import annotations

from typing import Final

from grammars.render.deeds import deed
from grammars.render.procedures import procedure
from grammars.render.telling import Telling, Voice
from grammars.render.things import proper
from kernel.memory.meaning import Control, Feedback, Identity, Revision, Social
from kernel.net.graphlet import Graphlet

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
    graphlets = [d.graphlet for d in meaning.chain.directives()]
    known: list[Graphlet] = [
        g for g in (*graphlets, meaning.instead_of, meaning.of) if g is not None
    ]
    telling = Telling(tuple(known), (), voice)
    said = f"no, {procedure(telling, meaning.chain)} instead"
    if meaning.instead_of is not None:
        said += f" of {deed(telling, meaning.instead_of.main, 'gerund')}"
    return said
