"""What somebody told the robot to do, and on which occasions it does something; which of two things is so."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Final

from kernel.asking import Asking, answers
from kernel.memory.experience import Deed
from kernel.memory.explanation import Allowed, Lessons, Taught
from kernel.memory.meaning import Question
from kernel.memory.meant import description, is_like, together
from kernel.memory.recall import THINGS
from kernel.memory.recall import answer as recalled
from kernel.memory.reply import Answer, Reply
from kernel.net.graphlet import Graphlet
from kernel.net.match import holds, matches
from kernel.net.node import REMEMBERED

PAST: Final = frozenset(("past",))


@answers("ordered")
def ordered(asking: Asking) -> Reply:
    """The newest order of that person, or of anybody, for that act, or for any."""
    deed = next(_orders(asking), None)
    if deed is not None:
        return Taught(asking.question, asking.asked, told=deed.source)
    return Answer(asking.question, "no" if asking.question.ask == "yesno" else "unknown")


@answers("orders")
def may_order(asking: Asking) -> Reply:
    """Whether that person's order would be followed: a dry run tells; of nobody in particular, what is taught."""
    act = _ordered(asking)
    teller = min(_names(asking), default="")
    if asking.question.ask != "yesno" or not teller or not act.words():
        return Lessons(asking.question, tuple(asking.about_acts(act, "ANTE", "ALLOW")))
    trouble = asking.imagine(asking.command(act), teller).trouble
    return Allowed(replace(asking.question, about=act), trouble)


@answers("every")
def every(asking: Asking) -> Answer:
    """Whether each of the things that are known to fit is so."""
    question, net = asking.question, asking.commons.memory.net
    about = question.about
    name = next(other for _, other in asking.main.links if other.startswith("obj"))
    described = description(about, name)
    fitting = [] if len(described.terms) < 2 else list(matches(described, net, REMEMBERED, {}))
    things = {match[name] for match in fitting if match[name].kind in THINGS}
    so = bool(things) and all(holds(about, net, REMEMBERED, {name: thing}) for thing in things)
    return Answer(question, "yes" if so else "unknown")


def _orders(asking: Asking) -> Iterator[Deed]:
    act, names = _ordered(asking), _names(asking)
    for deed in asking.commons.experience:
        source = deed.source
        if source is None or not asking.commons.experience.is_whole(deed):
            continue
        if (not names or source.teacher.lower() in names) and is_like(act, deed.understood):
            yield deed


def _names(asking: Asking) -> set[str]:
    """Who gave the order, or may give it."""
    return {
        name.lower()
        for role, other in asking.main.links
        for term in asking.question.about
        if role == "agt" and term.name == other
        for name in (asking.commons.memory.speaker_names if "me" in term.lex else term.lex)
    }


def _ordered(asking: Asking) -> Graphlet:
    links = asking.main.links
    return _ordered_act(asking.question.about, next((o for role, o in links if role == "cmd"), ""))


def _ordered_act(about: Graphlet, name: str) -> Graphlet:
    """The act that was ordered, with all that is said of it."""
    linked = [other for term in about if term.name == name for _, other in term.links]
    others = [t for t in about if t.name != about.main]
    terms = [t for t in others if t.name == name or any(other == name for _, other in t.links)]
    terms += [t for other in linked for t in description(about, other).terms if t not in terms]
    return Graphlet(tuple(terms), name)


@answers("occasion")
def occasion(asking: Asking) -> Lessons:
    """The lessons that have the act as a step."""
    act = asking.act
    return Lessons(asking.question, tuple(asking.with_step(act)) if act is not None else ())


@answers("either")
def either(asking: Asking) -> Reply:
    """Whichever of the two is known to be so, or was done last."""
    question, memory = asking.question, asking.commons.memory
    both = (question.about.main, question.wanted)
    for main, other in (both, both[::-1]):
        terms = tuple(t for t in question.about if other not in (t.name, *dict(t.links).values()))
        about = together(Graphlet(terms, main))
        found = recalled(Question("yesno", about), memory)
        if found.verdict == "yes" or _was_done(asking.of(_undated(about))):
            return Answer(question, "found", (about,))
    return Answer(question, "unknown")


def _was_done(asking: Asking) -> bool:
    """The robot did so."""
    return asking.about_act and any(deed.done for deed in asking.deeds())


def _undated(act: Graphlet) -> Graphlet:
    """Without saying that it is over."""
    return Graphlet(tuple(term for term in act if term.lex != PAST), act.main)
