"""`render` and `gist`: which sentence a meaning or a lesson is."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from grammars.render import lessons, operators, talk
from grammars.render.deeds import VerbForm, deed
from grammars.render.procedures import procedure
from grammars.render.questions import claim, question
from grammars.render.telling import Telling, Voice
from grammars.render.things import thing
from kernel.memory.lesson import Content, Operator, Rule
from kernel.memory.meaning import (
    Choice,
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
from kernel.net.graphlet import Graphlet, Term

GIST_WORDS: Final = 6


def render(meaning: Meaning | Content, voice: Voice) -> str:
    """The English sentence for a net: without a capital at its head or a full stop."""
    match meaning:
        case Operator() | Rule():
            return lessons.taught((meaning,), voice)
        case Graphlet():
            return lessons.fact(meaning, (), voice)
        case Fact(fact, finds):
            return lessons.fact(fact, finds, voice)
        case Teach():
            return lessons.taught(meaning.contents, voice)
        case Command(chain):
            told = tuple(chain.graphlets())
            return procedure(Telling(told, (), voice), chain)
        case Question():
            return question(meaning, voice)
        case Choice(described):
            return thing(Telling((described,), (), voice), described.main)
        case Revision():
            return talk.revision(meaning, voice)
        case Control(told=told) if told is not None:
            return f"forget that {render(told, voice)}"
        case Control():
            return talk.control(meaning, voice)
        case Feedback() | Identity() | Social():
            return talk.social(meaning, voice)


def gist(content: Content | Fact) -> str:
    """The heart of a lesson in at most 6 words, in the robot's voice: "I know how to dance"."""
    shortened = [render(content, "robot")]
    if isinstance(content, Operator):
        main = content.trigger.graphlet
        told = main and content.trigger.tag != "NOTE"
        act = deed(Telling((main,), (), "robot"), main.main) if main and told else ""
        shortened = [*operators.shortened(content, act), *shortened, "I will remember that"]
    elif isinstance(content, Rule):
        shortened = [*filter(None, [lessons.generic(content)]), *shortened]
    return next((s for s in shortened if len(s.split()) <= GIST_WORDS), "I will remember that")


def act_in_words(act: Graphlet, about: tuple[Graphlet, ...] = (), form: VerbForm = "base") -> str:
    """An action that was really to be done, in the robot's voice: "grab the red block"."""
    return deed(Telling(tuple(map(definite, (act, *about))), (), "robot"), act.main, form)


def thing_in_words(name: str, described: tuple[Graphlet, ...]) -> str:
    """A thing as a noun phrase in the robot's voice: "the red block"."""
    return thing(Telling(described, (), "robot"), name)


def claim_in_words(said: Graphlet) -> str:
    """Only what the main node says, of things that are known: "the block is red"."""
    return str(claim(Telling((definite(said),), (), "robot"), said))


def definite(described: Graphlet) -> Graphlet:
    """The same, the things it describes spoken of as known: "the block"."""
    kinds = {other for term in described for role, other in term.links if role == "ako"}
    whole = [*described, *map(Term, sorted(kinds - described.names))]
    terms = (replace(t, ref=t.ref or "the") if t.name in kinds else t for t in whole)
    return Graphlet(tuple(terms), described.main)
