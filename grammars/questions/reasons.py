"""Questions why something was done or is so, and who says so."""

from __future__ import annotations

from dataclasses import replace

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.questions.clause import BLANK, drawn, order_topic
from grammars.questions.topics import DEEDS, of_topic
from kernel.memory.meaning import Question


def why(build: Build, body: AList) -> Question:
    """Why the robot did it, or why it is so."""
    if (asks := body.find("asks")) is None:
        return of_topic(build, body)
    so = drawn(build, asks)
    if so.own:
        return Question("why", build.graphlet(so.main), "", "did")
    return Question("why", build.graphlet(so.main), "", order_topic(so) or "taught")


def what_for(build: Build, body: AList) -> Question:
    """ "What did you turn left for"; "what are you waiting for" asks for something else."""
    asks = body.first("asks")
    deed = asks.find(*DEEDS, *BLANK)
    if deed is None or not (deed.has("np") or deed.has("dir") or deed.name in BLANK):
        raise NoMeaningError(str(body))
    return replace(why(build, body), ask="what", topic="why")


def how_known(build: Build, body: AList) -> Question:
    """ "How do you know that Tim is tall": who said so."""
    return replace(why(build, body), ask="who", topic="taught")


def what_thinks(build: Build, body: AList) -> Question:
    """ "What makes you think the jar is heavy": who said so."""
    return replace(why(build, body), ask="what", topic="taught")


def what_stops(build: Build, body: AList) -> Question:
    """ "What stopped you from turning": why it did not."""
    act = build.action(body.first("gerunding"))
    build.sketch.change(act, negated=True)
    return Question("what", build.graphlet(act), "", "why")
