"""Questions whether something is so: "did you turn left", "isn't it heavy", "can you see the ball"."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.clauses import clause
from grammars.doings import WISHES
from grammars.mentions import EVERY, compounded
from grammars.questions.clause import YOU, Said, by_robot, drawn, of_clause, order_topic, topic_of
from grammars.questions.topics import DEEDS
from grammars.sorts import kind
from kernel.memory.meaning import Question

# What is asked with a "not" is no request: "couldn't you find it".
DID_NOT: Final = {"could": "did", "can": "know_how"}
IDLE: Final = frozenset("could would might shall".split())  # of others: nobody asks a robot


def whether(build: Build, asks: AList) -> Question:
    """Whether it is so: also "isn't it", "didn't you"."""
    mild = ("neg", "negq") if asks.find(*DEEDS) is not None else ("negq",)
    so = drawn(build, AList(asks.name, tuple(part for part in asks if part.name not in mild)))
    subject, modal = asks.find("np") or YOU, asks.slot("modal_q")
    others = not so.own and subject.slot("pron") != "i"
    unasked = (modal in IDLE and not so.past) or (modal == "may" and not subject.has("name"))
    idle = others and unasked
    if so.own and so.topic == "request" and asks.has("negq") and modal in DID_NOT:
        return Question("yesno", build.graphlet(so.main), "", DID_NOT[modal])
    if idle or (so.topic == "request" and so.own) or _says_nothing(build, so):
        raise NoMeaningError(str(asks))
    lesson = asks.find("instructing")
    if lesson is not None and lesson.find(*DEEDS) is not None:  # "did Mary teach you to bow"
        taught = dict(build.sketch.terms[so.main].links)["cmd"]
        return Question("yesno", build.graphlet(taught), "", "taught")
    if so.own and so.going and build.sketch.terms[so.main].lex:  # "are you holding it" is no deed
        by_robot(build, so.main)
        return Question("yesno", build.graphlet(so.main))
    topic = topic_of(build, so)
    whole = subject.has("whole") or subject.slot("vague") in EVERY
    if not topic and whole:  # "are both of the cups empty"
        about = build.sketch.terms[so.main].links
        name = next(
            (other for role, other in about if role in ("agt", "hq", "loc", "own", "ako")), ""
        )
        if not name:  # "were everybody folded"
            raise NoMeaningError(str(asks))
        build.sketch.change(name, ref="every")
        topic = "every"
    return Question("yesno", build.graphlet(so.main), "", topic)


def _says_nothing(build: Build, so: Said) -> bool:
    """ "Did you say", "do you like": what is said, liked or had is missing."""
    term = build.sketch.terms[so.inner or so.main]
    return not term.lex.isdisjoint(("say", "have", *WISHES)) and not {"obj", "dest"} & {
        role for role, _ in term.links
    }


def cleft(build: Build, body: AList) -> Question:
    """ "Was it Tom who moved the box"."""
    clefted = body.first("clefted")
    who = build.thing(clefted.first("np"), person=True)
    so = drawn(build, AList("asks", tuple(part for part in body if part.name != "clefted")), who)
    return Question("yesno", build.graphlet(so.main), "", order_topic(so))


def same_thing(build: Build, body: AList) -> Question:
    """ "Is this the box you dropped"."""
    thing, one = build.thing(body.first("np")), body.first("related")
    for qual in one.all("qual"):
        build.quality(thing, qual)
    if not (called := kind(one)):
        raise NoMeaningError(str(body))
    build.kind(thing, called, compounded(one))
    of_clause(build, one, thing)
    return Question("yesno", build.graphlet(thing))


def yesno(build: Build, body: AList) -> Question:
    """Whether what a clause says is so, in whatever words it is asked."""
    if (said := body.find("clause")) is not None:
        return Question("yesno", build.graphlet(clause(build, said)))
    if (asks := body.find("asks")) is not None:
        return whether(build, asks)
    if (done := body.find("gerunding")) is not None:  # "have you finished turning"
        return Question("yesno", build.graphlet(build.action(done)), "", "did")
    if (way := body.find("action")) is not None:  # "you know how to waltz, don't you"
        return Question("yesno", build.graphlet(build.action(way)), "", "know_how")
    subject = body.find("np")
    agent = build.oneself("you") if subject is None else build.thing(subject)
    if body.has("pred"):  # "are all birds animals"
        return Question("yesno", build.graphlet(clause(build, body)))
    things = body.all("np")
    if not things or body.has("name"):
        raise NoMeaningError(str(body))
    verb = "see" if body.has("seen") else "have"
    owned = build.thing(things[-1])
    owner = agent if len(things) > 1 else build.oneself("you")
    return Question("yesno", build.graphlet(build.add("act", verb, agt=owner, obj=owned)))


def seeing(build: Build, body: AList) -> Question:
    """ "Can you see the ball": whether it does."""
    both = body.find("both_of") or AList("both_of")
    agent, *things = [build.thing(np) for np in (*body.all("np"), *both.all("np"))]
    see, *_ = [build.add("act", body.slot("perceiving"), agt=agent, obj=each) for each in things]
    build.modifiers(see, body)
    return Question("yesno", build.graphlet(see))
