"""`render` and `gist`: which sentence a meaning or a lesson is."""

from __future__ import annotations

from typing import Final

from grammars.render import lessons, talk
from grammars.render.deeds import VerbForm, deed
from grammars.render.procedures import procedure
from grammars.render.questions import question
from grammars.render.telling import Telling, Voice
from grammars.render.things import thing
from kernel.memory.lesson import Content, Operator, Rule
from kernel.memory.meaning import (
    Command,
    Control,
    Fact,
    Feedback,
    Identity,
    Meaning,
    Question,
    Revision,
    Social,
    Teach,
)
from kernel.net.graphlet import Graphlet

GIST_WORDS: Final = 6


def render(meaning: Meaning | Content, voice: Voice) -> str:
    """The English sentence for a net: without a capital at its head or a full stop."""
    match meaning:
        case Operator():
            return lessons.operator(meaning, voice)
        case Rule():
            return lessons.rule(meaning, voice)
        case Graphlet():
            return lessons.fact(meaning, (), voice)
        case Fact(fact, finds):
            return lessons.fact(fact, finds, voice)
        case Teach(_, content):
            return render(content, voice)
        case Command(chain):
            told = tuple(d.graphlet for d in chain.directives() if d.graphlet)
            return procedure(Telling(told, (), voice), chain)
        case Question():
            return question(meaning, voice)
        case Revision():
            return talk.revision(meaning, voice)
        case Control():
            return talk.control(meaning, voice)
        case Feedback() | Identity() | Social():
            return talk.social(meaning, voice)


def gist(content: Content | Fact) -> str:
    """The heart of a lesson in at most 6 words, in the robot's voice: "I know how to dance"."""
    shortened = [render(content, "robot")]
    if isinstance(content, Operator):
        main = content.trigger.graphlet
        act = act_in_words(main) if main and content.trigger.tag != "NOTE" else ""
        shortened = [*lessons.shortened(content, act), *shortened, "I will remember that"]
    return next((s for s in shortened if len(s.split()) <= GIST_WORDS), "I will remember that")


def act_in_words(act: Graphlet, about: tuple[Graphlet, ...] = (), form: VerbForm = "base") -> str:
    """An action as a verb phrase in the robot's voice: "grab Mary"."""
    return deed(Telling((act, *about), (), "robot"), act.main, form)


def thing_in_words(name: str, described: tuple[Graphlet, ...]) -> str:
    """A thing as a noun phrase in the robot's voice: "the red block"."""
    return thing(Telling(described, (), "robot"), name)
