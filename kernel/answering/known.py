"""What do you know about X: facts, conclusions, lessons. What did you learn today."""

from __future__ import annotations

from kernel.asking import Asking, answers
from kernel.memory.explanation import Knowledge, Lessons
from kernel.memory.inference import says_something
from kernel.memory.lesson import Lesson
from kernel.memory.meant import description
from kernel.memory.recall import THINGS
from kernel.net.describing import describe
from kernel.net.graphlet import Graphlet
from kernel.net.match import matches
from kernel.net.node import REMEMBERED, Node


@answers("know_about")
def know_about(asking: Asking) -> Knowledge:
    """Everything that is so of the things described, and the lessons that mention them."""
    about, memory = asking.question.about, asking.commons.memory
    said = description(about, about.main)
    things = [
        match[about.main]
        for match in matches(said, memory.net, REMEMBERED, memory.persons(said, {}))
        if match[about.main].kind in THINGS
    ]
    things = _meant(asking, list(dict.fromkeys(things))) if said.terms else []
    asking.call_to_mind(things)
    facts: list[Graphlet] = []
    inferred: list[Graphlet] = []
    words = about.words()
    for thing in things:
        for node in dict.fromkeys(other for _, other in thing.into):
            new = says_something(node) and node.kind not in ("said", "input") and node.lex
            if not new or node.lex <= words or memory.is_part(node):
                continue
            (inferred if node.rule else facts).append(describe(node))
    return Knowledge(asking.question, tuple(facts), tuple(inferred), _lessons(asking, words))


def _meant(asking: Asking, things: list[Node]) -> list[Node]:
    """Of several that fit, "the cup" is the one mentioned last; about "cups" none of them has anything to say."""
    if len(things) < 2 or asking.main.lex:
        return things
    return [max(things, key=lambda thing: thing.stamp)] if asking.main.ref else []


def _lessons(asking: Asking, words: frozenset[str]) -> tuple[Lesson, ...]:
    """Rules and operators that speak of it by its name or kind, newest first; facts were told already."""
    nouns = _nouns(asking.question.about) or words
    there = asking.commons.shelves.mentioning(nouns)
    return tuple(lesson for lesson in there if asking.was_taught(lesson))


def _nouns(about: Graphlet) -> frozenset[str]:
    """Its name, or its kind with the qualities that the question names."""
    kinds = ("obj", "ako", "hq")
    return frozenset(word for term in about if term.kind in kinds for word in term.lex)


def _by_person(asking: Asking) -> Lessons:
    """Lessons and facts of the session that one person taught."""
    memory = asking.commons.memory
    me = "me" in asking.main.lex
    names = memory.speaker_names if me else asking.main.lex
    found = [
        lesson
        for lesson in reversed(list(asking.commons.lessons.values()))
        if lesson.words and lesson.ident > 0 and lesson.teacher.lower() in (names or {""})
    ]
    return Lessons(asking.question, tuple(found))


@answers("learned")
def learned(asking: Asking) -> Lessons:
    """Lessons of the day on which it is asked, newest first; a day begins at midnight of the clock on the wall. Where a
    person is named: everything in force that the person taught or told."""
    if asking.main.kind == "obj":
        return _by_person(asking)
    day = asking.commons.settings.day
    today = day(asking.asked.at_s)
    of_today = [x for x in reversed(asking.lessons) if x.words and day(x.at_s) == today]
    return Lessons(asking.question, tuple(of_today))
