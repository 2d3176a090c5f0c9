"""What is neither lesson, command nor question: manners, praise, names, steering and corrections."""

from __future__ import annotations

from typing import Final

from grammars.render.deeds import deed
from grammars.render.names import pronoun, proper
from grammars.render.procedures import procedure
from grammars.render.telling import Telling, Voice, linked, word
from grammars.render.things import thing
from kernel.memory.editing import ORDER, OTHER_WAY, alteration
from kernel.memory.meaning import Control, Feedback, Identity, Revision, Social
from kernel.net.graphlet import Graphlet

_MANNERS: Final = {"hello": "hello", "thanks": "thank you", "bye": "goodbye", "sorry": "sorry"}
_STEERING: Final = {
    "stop": "stop",
    "cancel": "never mind",
    "undo": "undo that",
    "undo_today": "undo everything from today",
    "forget": "forget the last lesson",
    "keep": "keep both",
    "replace": "replace it",
    "resume": "go on",
    "repeat": "repeat that",
    "learned": "what did you learn today",
}
_OF_WHAT: Final = {"stop": "stop", "cancel": "never mind about", "resume": "go back to"}


def social(meaning: Feedback | Identity | Social, voice: Voice) -> str:
    """Manners, praise and blame, and names, as they are said to the robot."""
    match meaning:
        case Identity(name, robot=True):
            return f"{'my' if voice == 'robot' else 'your'} name is {proper(name)}"
        case Identity(name):
            return f"{'you are' if voice == 'robot' else 'my name is'} {proper(name)}"
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
    if meaning.act in _OF_WHAT:
        what = deed(telling, main, "gerund") if main.startswith("act") else thing(telling, main)
        return f"{_OF_WHAT[meaning.act]} {what}"
    if meaning.act == "learned":
        me = "me" in telling.term(main).lex
        who = pronoun(telling, "me", "subject") if me else thing(telling, main)
        return f"what did {who} teach {pronoun(telling, 'you', 'object')}"
    if not main.startswith("act"):
        who = pronoun(telling, "me", "subject")
        return f"forget what {who} told {pronoun(telling, 'you', 'object')} about {thing(telling, main)}"
    if telling.term(main).lex == {"teach"}:
        who = thing(telling, linked(telling.term(main), "agt"), "subject")
        return f"forget everything {who} taught {pronoun(telling, 'you', 'object')}"
    more = (deed(Telling((act,), (), voice), act.main) for act in meaning.more)
    return " and how to ".join((f"forget how to {deed(telling, main)}", *more))


def revision(meaning: Revision, voice: Voice) -> str:
    """A correction: "no, turn right instead of turning left"."""
    found = [d.graphlet for d in meaning.chain.directives() if d.graphlet]
    known = [g for g in (*found, meaning.instead_of, meaning.of) if g is not None]
    telling = Telling(tuple(known), (), voice)
    old = meaning.instead_of
    if old is not None and telling.term(old.main).kind != "act":
        return f"not {thing(telling, old.main)}, {thing(telling, found[-1].main)}"
    if (change := alteration(meaning.chain)) is not None:
        bare = next((t.literal for t in change if t.kind == "amt" and not t.lex), None)
        how = bare or deed(telling, change.main).removeprefix("do something ")
        how = how.replace(OTHER_WAY, "the other way")
        if meaning.of is not None:
            doing = deed(telling, meaning.of.main)
            it = "it" if old is None else _step(telling, old)
            return f"when {pronoun(telling, 'you', 'subject')} {doing}, do {it} {how}"
        if old is not None:
            return f"do {_step(telling, old)} {how}"
        return f"do it {how} next time" if meaning.later else f"make it {how}"
    if meaning.of is None and found and all(d.tag == "FIND" for d in meaning.chain.directives()):
        return f"I meant {thing(telling, found[-1].main)}"
    if meaning.chain.tagged("KEEP") and not meaning.chain.tagged("DO"):
        return f"do it again while {procedure(telling, meaning.chain, 'gerund')}"
    if meaning.of is None:
        return _correction(telling, meaning)
    you = pronoun(telling, "you", "subject")
    return f"when {you} {deed(telling, meaning.of.main)}, {_correction(telling, meaning)}"


def _correction(telling: Telling, meaning: Revision) -> str:
    """What is to be done, instead of what or beside what."""
    old, no = meaning.instead_of, "" if meaning.of is not None else "no, "
    step = "" if old is None else _step(telling, old)
    if meaning.moved:
        return _reordering(telling, meaning, step)
    if not meaning.chain.plays:
        return f"leave out {step}"
    steps = procedure(telling, meaning.chain)
    if meaning.beside:
        return f"add {steps} {meaning.beside} {step}"
    if old is not None and _order(old):
        return f"make {step} {steps}"
    if old is not None:
        return f"{no}{steps} instead of {step}"
    if meaning.of is None:
        when = "next time" if meaning.later else "instead"
        return f"add {steps} at the end" if meaning.last else f"no, {steps} {when}"
    return f"{steps} {'at the end' if meaning.last else 'first'}"


def _order(step: Graphlet) -> str:
    """Its place in the lesson: "second"."""
    return next((o for t in step if t.kind == "hq" for o in ORDER if o in t.lex), "")


def _step(telling: Telling, step: Graphlet) -> str:
    """A step of a lesson: "the first step", "the second turn", "turning left"."""
    if not (at := _order(step)):
        return deed(telling, step.main, "gerund")
    act = telling.term(step.main)
    ways = [word(way) for way in telling.take(act.name, "dir")]
    return " ".join(("the", at, *ways, word(act) or "step"))


def _reordering(telling: Telling, meaning: Revision, step: str) -> str:
    (moving,) = meaning.chain.tagged("DO")
    if meaning.last:
        return f"move {_step(telling, moving)} to the end"
    if meaning.beside:
        return f"move {_step(telling, moving)} {meaning.beside} {step}"
    return f"swap {step} and {_step(telling, moving)}"
