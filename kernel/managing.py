"""Managing what was taught: forgetting, undoing, answering what is to be done with a doubtful lesson (all ours).

Every one of these is a change like teaching: it becomes durable as a whole, and can be undone itself.
"""

from __future__ import annotations

from collections.abc import Generator, Iterable
from dataclasses import replace
from typing import Final

from kernel.action.step import Run
from kernel.action.verdict import Verdict
from kernel.commons import Commons
from kernel.memory.attention import Focus
from kernel.memory.change import LEAST, SESSION, Adapted, Change
from kernel.memory.lesson import INNATE, Lesson, Operator, Resting
from kernel.memory.likeness import covers
from kernel.memory.meaning import Control, Fact, Meaning, Teach
from kernel.memory.notation import canonical
from kernel.memory.policy import Shift
from kernel.memory.reply import Forgotten, NothingToDo, TakenBack
from kernel.memory.teacher import in_own_name
from kernel.net.graphlet import Graphlet

TAUGHT: Final = frozenset(("teach",))


def undo(commons: Commons, focus: Focus) -> Run:
    """Take back the newest change that counts and is a person's; an undo is one too, so "undo that" twice changes
    nothing. A motion cannot be undone."""
    yield from settled(commons, focus)
    if commons.recent.thing == "motion":
        commons.replies.append(NothingToDo("motion"))
        return Verdict.SUCCEEDED
    for change in list(commons.policy.changes()):
        if not change.own and commons.policy.counts(change.ident):
            taking = replace(focus.changing(), undone=_undoing(commons, change))
            resting = commons.policy.beyond(taking)
            if change.adapted or resting or commons.policy.preview(taking) != Shift():
                return (yield from _take_back(commons, focus, taking))
    commons.replies.append(NothingToDo("undo"))
    return Verdict.SUCCEEDED


def settled(commons: Commons, focus: Focus) -> Generator[None, None, None]:
    """Wait for what was said just before: until it has been thought about, and the store has answered."""
    focus.waits.add("next tick")
    yield
    while commons.pending:
        focus.waits.add("store")
        yield


def _undoing(commons: Commons, change: Change) -> tuple[int, ...]:
    """What to take back so that the change does not count: itself; where it takes back mere undos, what these took
    back. So undoing to and fro makes no chain without end."""
    known = {c.ident: c for c in commons.policy.changes()} if change.undone else {}
    undos = [known[n] for n in change.undone if n in known]
    if undos and not change.teaches and all(u.undone and not u.teaches for u in undos):
        return tuple(n for u in undos for n in u.undone)
    return (change.ident,)


def undo_today(commons: Commons, focus: Focus) -> Run:
    """Back to what was in force when the day began; days are those of the robot's place."""
    yield from settled(commons, focus)
    change = focus.changing()
    day = commons.settings.day
    today = day(change.at_s)
    undone = [c.ident for c in commons.policy.changes() if not c.own and day(c.at_s) == today]
    return (yield from _take_back(commons, focus, replace(change, undone=tuple(undone))))


def _take_back(commons: Commons, focus: Focus, change: Change) -> Run:
    change = replace(change, adapted=_amends(commons, change))
    shift = commons.policy.preview(change)
    if shift == Shift() and not commons.policy.beyond(change):
        commons.replies.append(NothingToDo("undo"))
        return Verdict.SUCCEEDED
    for lesson in shift.entered:  # what they may not permit they may not bring back
        if (veto := commons.lifted(focus.by, lesson.content)) is not None:
            focus.failure = commons.not_yours(veto)
            return Verdict.FAILED
    chunks = with_chunks(commons, shift.left)[len(shift.left) :]
    change = replace(change, retracted=tuple(chunk.ident for chunk in chunks))
    if not (yield from changed(commons, focus, change, shift.left)):
        return Verdict.FAILED
    commons.replies.append(TakenBack(_taught(shift.left), _taught(shift.entered), shift.moved))
    return Verdict.SUCCEEDED


def _taught(lessons: tuple[Lesson, ...]) -> tuple[Lesson, ...]:
    """Without what the robot made of them by itself, unless there is nothing else."""
    return tuple(lesson for lesson in lessons if not lesson.origins) or lessons


def _amends(commons: Commons, change: Change) -> tuple[Adapted, ...]:
    """Moves that make up for praise and blame being taken back where the robot has moved the strength since; none of
    them leads above what was taught."""
    policy = commons.policy
    moved = {lesson.ident for lesson in policy.preview(change).moved}
    shift: dict[int, float] = {}
    for earlier in policy.changes():
        if earlier.ident in change.undone and policy.counts(earlier.ident):
            for move in earlier.adapted:
                if move.lesson in commons.lessons and move.lesson not in moved:
                    shift[move.lesson] = shift.get(move.lesson, 0.0) + move.before - move.after
    amends = []
    for ident, by in shift.items():
        now, taught = policy.strength(commons.lessons[ident]), commons.lessons[ident].strength
        amends.append(Adapted(ident, now, max(LEAST, min(max(now, taught), now + by))))
    return tuple(amends)


def changed(
    commons: Commons, focus: Focus, change: Change, leaving: Iterable[Lesson]
) -> Generator[None, None, bool]:
    """Make a change that takes these lessons out of force; False, with the reason, where the speaker may not."""
    touched: list[Lesson | Resting] = [*leaving, *_asleep(commons, change)]
    for lesson in touched:
        if not commons.may(focus.by, lesson):
            focus.failure = commons.not_yours(lesson)
            return False
    return (yield from commons.commit(focus, change))


def _asleep(commons: Commons, change: Change) -> list[Resting]:
    """The lessons it takes or brings back that rest."""
    if not commons.resting:
        return []
    taken_back = set(change.undone)
    undone = [c for c in commons.policy.changes() if c.ident in taken_back]
    idents = {*change.retracted, *(n for c in undone for n in c.retracted)}
    numbers = {c.ident for c in undone}
    return [x for x in commons.resting if x.ident in idents or x.change in numbers]


def forget(commons: Commons, focus: Focus, control: Control) -> Run:
    """Take lessons out of force: how to do something, what was told of something, a lesson told again, the last one.

    What the robot made of them by itself goes with them. The body's own skills cannot be forgotten.
    """
    yield from settled(commons, focus)
    about = control.about
    if control.lessons:
        return (yield from _by_number(commons, focus, control.lessons))
    if control.told is not None:
        found = _told(commons, control.told, focus.by)
    elif about is None:
        found = last_taught(commons)
    elif about.head is not None and about.head.lex == TAUGHT:
        found, about = _of_teacher(commons, about, focus.by), None
    elif control.more:
        found = [lesson for act in (about, *control.more) for lesson in _ways(commons, act)]
        about = None
    elif about.main.startswith("act"):
        found = _ways(commons, about)
        if not found and _inborn(commons, about):
            commons.replies.append(NothingToDo("inborn"))
            return Verdict.SUCCEEDED
    else:
        found = [
            lesson
            for lesson in commons.lessons.values()
            if isinstance(lesson.content, Graphlet) and covers(about, (lesson.content,))
        ]
    if found:
        gone = with_chunks(commons, found)
        change = replace(focus.changing(), retracted=tuple(x.ident for x in gone))
        if not (yield from changed(commons, focus, change, gone)):
            return Verdict.FAILED
    commons.replies.append(Forgotten(tuple(found), about))
    return Verdict.SUCCEEDED


def _by_number(commons: Commons, focus: Focus, numbers: tuple[int, ...]) -> Run:
    """Lessons as the store numbers them; one that rests is known to the store alone."""
    wanted = tuple(n for n in dict.fromkeys(numbers) if 0 < n < SESSION)
    found = [commons.lessons[n] for n in wanted if n in commons.lessons]
    gone = with_chunks(commons, found)
    retracted = dict.fromkeys((*wanted, *(lesson.ident for lesson in gone)))
    change = replace(focus.changing(), retracted=tuple(retracted))
    if not (yield from changed(commons, focus, change, gone)):
        return Verdict.FAILED
    commons.replies.append(Forgotten(tuple(found), resting=len(wanted) - len(found)))
    return Verdict.SUCCEEDED


def _of_teacher(commons: Commons, taught: Graphlet, by: str) -> list[Lesson]:
    """What one person taught, who may be the speaker; nothing where he is not named."""
    links = dict(taught.head.links) if taught.head else {}
    named = taught.term(links["agt"]).lex
    names = {by.lower()} if "me" in named else named
    return [
        lesson
        for lesson in commons.lessons.values()
        if lesson.ident > INNATE and lesson.teacher and lesson.teacher.lower() in names
    ]


def _ways(commons: Commons, act: Graphlet) -> list[Lesson]:
    """Taught operators on doing that, or something more specific; without any, those it would be done by."""
    some = (
        commons.shelves.triggered(act.head.lex)
        if act.head and act.head.lex
        else commons.lessons.values()
    )
    narrow, wide = [], []
    for lesson in some:
        operator = lesson.content
        if lesson.ident <= INNATE or not isinstance(operator, Operator):
            continue
        trigger = operator.does
        if trigger is not None and covers(act, (trigger,), trigger):
            narrow.append(lesson)
        elif trigger is not None and covers(trigger, (act,), act):
            wide.append(lesson)
    return narrow or wide


def _inborn(commons: Commons, act: Graphlet) -> bool:
    """The body can do that: one of its own skills covers it, or is covered by it."""
    for lesson in commons.lessons.values():
        if lesson.ident <= INNATE and isinstance(lesson.content, Operator):
            trigger = lesson.content.trigger.graphlet
            if trigger and (covers(act, (trigger,), trigger) or covers(trigger, (act,), act)):
                return True
    return False


def _told(commons: Commons, told: Teach | Fact, by: str) -> list[Lesson]:
    """Lessons in force that say the same, in whatever strength."""
    contents = told.contents if isinstance(told, Teach) else (whole(told),)
    return [x for content in contents for x in commons.shelves.alike(in_own_name(content, by))]


def last_taught(commons: Commons) -> list[Lesson]:
    """What is in force of the newest change by which a person taught something that is."""
    for change in commons.policy.changes():
        found = [lesson for lesson in change.learned if lesson.ident in commons.lessons]
        if found and not change.own:
            return found
    return []


def with_chunks(commons: Commons, lessons: Iterable[Lesson]) -> list[Lesson]:
    """With what the robot made of them by itself, and of that in turn."""
    gone = {lesson.ident: lesson for lesson in lessons}
    made = [lesson for lesson in commons.lessons.values() if lesson.origins]
    while True:
        more = {
            lesson.ident: lesson
            for lesson in made
            if lesson.ident not in gone and gone.keys() & set(lesson.origins)
        }
        if not more:
            return list(gone.values())
        gone |= more


def whole(fact: Fact) -> Graphlet:
    """The fact with the descriptions of what it is about, as it is kept."""
    terms = {t.name: t for find in fact.finds for t in find.terms}
    for term in fact.fact.terms:  # one that was looked up keeps how it was referred to
        found = terms.get(term.name)
        terms[term.name] = term if found is None else replace(term, ref=term.ref or found.ref)
    return canonical(Graphlet(tuple(terms.values()), fact.fact.main))


def answered(commons: Commons, meaning: Meaning) -> bool:
    """Pass an answer on to the open question; False for what is no answer."""
    if not isinstance(meaning, Control) or commons.doubt is None:
        return False
    match meaning:
        case Control("keep" | "replace" | "cancel" as act):
            commons.doubt.answer = act
        case Control("undo" | "forget", about=None, told=None, lessons=()):  # "forget that"
            commons.doubt.answer = "cancel"
        case _:
            return False
    return True
