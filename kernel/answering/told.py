"""What somebody told the robot to do, and on which occasions it does something; which of two things is so."""

from __future__ import annotations

from collections.abc import Iterator

from kernel.asking import Asking, answers
from kernel.memory.experience import Deed
from kernel.memory.explanation import Lessons, Taught
from kernel.memory.meaning import Question
from kernel.memory.meant import description, is_like
from kernel.memory.recall import answer as recalled
from kernel.memory.reply import Answer, Reply
from kernel.net.graphlet import Graphlet


@answers("ordered")
def ordered(asking: Asking) -> Reply:
    """The newest order of that person, or of anybody, for that act, or for any."""
    deed = next(_orders(asking), None)
    if deed is not None:
        return Taught(asking.question, asking.asked, told=deed.source)
    return Answer(asking.question, "no" if asking.question.ask == "yesno" else "unknown")


def _orders(asking: Asking) -> Iterator[Deed]:
    about, main = asking.question.about, asking.main
    act = _ordered_act(about, next((other for role, other in main.links if role == "cmd"), ""))
    names = {
        name.lower()
        for role, other in main.links
        for term in about
        if role == "agt" and term.name == other
        for name in (asking.commons.memory.speaker_names if "me" in term.lex else term.lex)
    }
    for deed in asking.commons.experience:
        source = deed.source
        if source is None or not asking.commons.experience.is_whole(deed):
            continue
        if (not names or source.teacher.lower() in names) and is_like(act, deed.understood):
            yield deed


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
    """Whichever of the two is known to be so."""
    question, memory = asking.question, asking.commons.memory
    both = (question.about.main, question.wanted)
    for main, other in (both, both[::-1]):
        about = Graphlet(tuple(term for term in question.about if term.name != other), main)
        found = recalled(Question("yesno", about), memory)
        if found.verdict == "yes":
            return Answer(question, "found", (about,))
    return Answer(question, "unknown")
