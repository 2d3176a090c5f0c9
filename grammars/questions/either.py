"""Questions which of two is so: "is the gripper open or closed", "did you turn left or right"."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from grammars.alist import AList
from grammars.alternatives import APART
from grammars.build import Build, NoMeaningError
from grammars.doings import PAST
from grammars.questions.clause import YOU
from grammars.relatives import predicate
from kernel.memory.meaning import Question
from kernel.net.graphlet import Graphlet, Term

TOPICS: Final = ("", "did", "doing", "allowed")  # that there may be two of
YOU_TOO: Final = f"obj-{2 * APART}"


def either_so(build: Build, body: AList) -> Question:
    """ "Is the gripper open or closed": both are drawn, and one of them is so."""
    np = body.find("np") or YOU
    who = build.thing(np)
    mains = [predicate(build, who, pred, negated=False) for pred in body.all("pred")]
    mains += [build.place("loc", who, loc) for loc in body.all("loc")]
    if any(build.sketch.terms[name].kind == "obj" for name in mains):  # "are you Tim or Oscar"
        raise NoMeaningError(str(body))
    for doing in body.all("gerunding"):
        mains.append(build.action(doing))
        build.sketch.link(mains[-1], "agt", who)
    return Question("which", build.graphlet(mains[0]), mains[1], "either")


def one_of(first: Question, second: Question) -> Question:
    """Which of the two is so, each of which may be asked by itself.

    Raises:
        NoMeaningError: they are no such questions.
    """
    if first.ask != "yesno" or second.ask != "yesno" or first.topic != second.topic:
        raise NoMeaningError("two questions")
    if first.topic not in TOPICS:
        raise NoMeaningError(first.topic)
    if any(main.startswith("obj") for main in (first.about.main, second.about.main)):
        raise NoMeaningError("a name")  # "is the gripper open or Sally"
    one, other = _by_somebody(first), _by_somebody(_apart(first, second))
    known = {term.name for term in one}
    terms = (*one, *(term for term in other if term.name not in known))
    return Question("which", Graphlet(terms, one.main), other.main, "either")


def _apart(first: Question, second: Question) -> Question:
    """The second, with other names for all that it does not say of the same things."""
    names = {}
    for name in second.about.mentioned - _shared(first.about, second.about):
        kind, _, at = name.rpartition("-")
        names[name] = f"{kind}-{int(at) + APART}"
    return replace(second, about=second.about.renamed(names))


def _shared(first: Graphlet, second: Graphlet) -> set[str]:
    """Names of what is the same in both: they were drawn alike up to where they part."""
    shared = {term.name for term in first if term in second.terms} - {first.main, second.main}
    while True:
        odd = {name for name in shared if not _said_alike(first, second, name) <= shared}
        if not odd:
            return shared
        shared -= odd


def _said_alike(first: Graphlet, second: Graphlet, name: str) -> set[str]:
    """What describes the thing in either of them; itself is none of that."""
    said = [
        {t for t in about if t.name != about.main and any(o == name for _, o in t.links)}
        for about in (first, second)
    ]
    return {term.name if term in said[0] & said[1] else "" for term in said[0] | said[1]}


def _by_somebody(question: Question) -> Graphlet:
    """What is asked about, with the robot as the agent of its own deeds."""
    about = question.about
    head = about.head
    if head is None or not question.topic or dict(head.links).get("agt"):
        return about
    act = replace(head, links=tuple(sorted((*head.links, ("agt", YOU_TOO)))))
    more: tuple[Term, ...] = (Term(YOU_TOO, frozenset(("you",))),)
    if question.topic == "did":
        was = f"mod-{2 * APART + int(about.main.rpartition('-')[2])}"
        more += (Term(was, frozenset((PAST,)), links=(("mod", about.main),)),)
    return Graphlet((*(act if term is head else term for term in about), *more), about.main)
