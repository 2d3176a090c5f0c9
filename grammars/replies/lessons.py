"""Lessons that answer a question: how, what happens, what is forbidden, what was learned today."""

from __future__ import annotations

from itertools import groupby
from typing import Final

from grammars.render import render, thing_in_words
from grammars.render.reasons import asked_act, exact_words, lines, teacher
from grammars.replies import Said, both, renders
from kernel.memory.explanation import Lessons
from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Question

MOST: Final = 5
_NONE: Final = {
    "learned": "nobody taught me anything today",
    "happens": "nothing that I was taught",
    "before": "nothing that I was taught",
    "after": "nothing that I was taught",
    "allowed": "nobody has forbidden me anything",
    "occasion": "nothing that I was taught",
    "orders": "anybody, as far as I was taught",
}


@renders(Lessons)
def lessons(reply: Lessons) -> Said:
    """ "Freddy taught me: to bow lower the lift then raise the lift; never turn right. And 3 more." """
    if not reply.lessons:
        return both(lines([_none(reply.question)]))
    return both(lines(_told(reply.lessons, reply.revised)))


def _told(found: tuple[Lesson, ...], revised: tuple[Lesson, ...]) -> list[str]:
    told = [
        f"{who}: {'; '.join(_words(lesson, revised) for lesson in group)}"
        for who, group in groupby(found[:MOST], key=teacher)
    ]
    more = len(found) - MOST
    if more > 0:
        told[-1] += f", and {more} more"
    return told


def _words(lesson: Lesson, revised: tuple[Lesson, ...]) -> str:
    return render(lesson.content, "teacher") if lesson in revised else exact_words(lesson)


def _none(question: Question) -> str:
    if question.topic == "learned" and question.about.main.startswith("obj"):
        return f"{thing_in_words(question.about.main, (question.about,))} taught me nothing"
    if question.topic in _NONE:
        return _NONE[question.topic]
    if question.topic == "means":
        return f"I don't know what {min(question.about.words(), default='that')} means"
    if question.topic == "know_how" and any(term.lex for term in question.about):
        return f"I don't know how to {asked_act(question.about)}"
    return "I don't know"
