"""Taking a lesson or a fact: what is known already, what cannot go together, what may not be taught by whom."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import replace

from kernel.adapting import weigh
from kernel.commons import Commons
from kernel.memory.attention import Focus
from kernel.memory.change import Change
from kernel.memory.lesson import Lesson
from kernel.memory.likeness import never_fires
from kernel.memory.recent import PATIENCE_S, Doubt
from kernel.memory.reply import KnownAlready, LessonDropped, LessonTaken, Revised, Why
from kernel.net.graphlet import Graphlet
from kernel.net.match import matches
from kernel.net.node import REMEMBERED

Learning = Generator[None, None, bool]
Taking = Generator[None, None, Change | None]


def learn(commons: Commons, focus: Focus) -> Learning:
    """Learn the focus's lessons in one change, once that is durable; whether nothing went wrong."""
    lesson = focus.lesson
    if lesson is None:
        return False
    if isinstance(lesson.content, Graphlet):
        return (yield from _fact(commons, focus, lesson))
    change = focus.changing()
    revised: list[Lesson] = []
    for each in (lesson, *focus.beside):
        before = change.retracted
        taken = yield from _taken(commons, focus, each, change)
        if taken is None:
            return False
        change = taken
        revised += [each] * (change.retracted != before)
    if not change.learned:
        return True
    stored = yield from commons.commit(focus, change)
    if stored and revised:
        commons.replies += [
            Revised(each) if each in revised else LessonTaken(each) for each in change.learned
        ]
    return stored


def _taken(commons: Commons, focus: Focus, lesson: Lesson, change: Change) -> Taking:
    """The change with the lesson in it, or without if it is known or dropped; None where it may not be learned.

    The same lesson again is known already; where a newer one stands against it, it is the newer now. The same in
    another strength takes the place of the old one. Where it contradicts another or can never come to anything, the
    person is asked; without an answer both are kept, as the newer one wins ties.
    """
    if (veto := commons.lifted(focus.by, lesson.content)) is not None:
        focus.failure = commons.not_yours(veto)
        return None
    gone: tuple[int, ...] = ()
    old = next(iter(commons.shelves.alike(lesson.content)), None)
    if old is not None:
        rival = commons.shelves.contradicting(lesson.content)
        overtaken = rival is not None and rival.ident > old.ident
        if old.strength == lesson.strength and not overtaken:
            commons.replies.append(KnownAlready(old))
            return change
        gone = (old.ident,)
    elif (doubt := _doubt(commons, lesson)) is not None:
        why, other = doubt
        answer = yield from _answer(commons, focus, Doubt(lesson, why, other, focus.number))
        if answer == "cancel":
            commons.replies.append(LessonDropped(lesson))
            return change
        if answer == "replace" and other is not None:
            if not commons.may(focus.by, other):
                focus.failure = commons.not_yours(other)
                return None
            gone = (other.ident,)
    retracted = tuple(dict.fromkeys((*change.retracted, *gone)))
    return replace(change, learned=(*change.learned, lesson), retracted=retracted)


def _fact(commons: Commons, focus: Focus, lesson: Lesson) -> Learning:
    """Take it for true; keep it as a lesson if it is to last, else for the session."""
    memory, saying = commons.memory, focus.saying
    if saying is None:
        return False
    fact = saying.fact.fact
    binding = memory.persons(fact, dict(saying.about))
    weigh(commons, focus, fact, binding)
    opposite = {
        found[fact.main] for found in matches(fact.denied(), memory.net, REMEMBERED, binding, 0.0)
    }
    retracted = tuple(n for n, node in commons.facts.items() if node in opposite)
    _, focus.told = memory.tell(fact, dict(saying.about))
    commons.record("fact", focus, text=" ".join(sorted(fact.words())))
    if focus.told[0] in commons.facts.values():
        return True
    if not _lasts(fact, saying.fact.finds):
        lesson = replace(lesson, ident=commons.session_number())
        commons.note(lesson.ident, saying)
    elif known := commons.shelves.alike(lesson.content):
        commons.facts[known[0].ident] = focus.told[0]  # in force, though memory had lost it
        return True
    change = replace(focus.changing(), learned=(lesson,), retracted=retracted)
    return (yield from commons.commit(focus, change))


def _lasts(fact: Graphlet, finds: tuple[Graphlet, ...]) -> bool:
    """Facts of name or kind about a named individual are kept like lessons (mind.md): "Mary is a girl", "the red block
    is called Bob". A name for what was only pointed at would mean nothing later."""
    head, terms = fact.head, [t for g in (*finds, fact) for t in g.terms]
    if head is None:
        return False
    named = {t.name for t in terms if t.kind == "obj" and t.lex}
    named -= {t.name for t in terms if t.lex & {"you", "me"}}
    if head.name in named:
        return any(to == head.name for t in terms for _, to in t.links)
    return any(role == "ako" and to in named for role, to in head.links)


def _doubt(commons: Commons, lesson: Lesson) -> tuple[Why, Lesson | None] | None:
    """Why it should not be kept without asking, and because of which other lesson."""
    if (never := never_fires(lesson.content)) is not None:
        return never, None
    other = commons.shelves.contradicting(lesson.content)
    return None if other is None else ("contradicts", other)


def _answer(commons: Commons, focus: Focus, doubt: Doubt) -> Generator[None, None, str]:
    """Ask, and wait for the answer: until another utterance, a stop, or time closes the question."""
    until_s = commons.tick.now_s + PATIENCE_S
    commons.doubt = doubt
    commons.replies.append(doubt.question)
    try:
        while commons.doubt is doubt and not doubt.answer and commons.tick.now_s < until_s:
            focus.waits.add("answer")
            yield
    finally:
        if commons.doubt is doubt:
            commons.doubt = None
    return doubt.answer
