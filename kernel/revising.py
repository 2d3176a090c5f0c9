"""Revision: a correction of what was taught, or of what was just commanded (all ours).

Which lesson is meant: the one named ("when you wiggle ..."); else that of the last deed or the last one taught,
whichever was later; else, where the step to be replaced is named, the newest one that has it. A correction that fits
the last command and no lesson behind it is done now, instead of it, and lowers the operator that the command chose.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Literal

from kernel.action.chain import Chain, Directive
from kernel.action.step import Run
from kernel.action.verdict import Verdict
from kernel.adapting import judge
from kernel.commons import Commons
from kernel.managing import last_taught, with_chunks
from kernel.memory.attention import Focus
from kernel.memory.editing import (
    alteration,
    altered,
    has_step,
    keeping,
    meant,
    with_more,
    with_other_end,
    with_other_step,
    with_other_thing,
)
from kernel.memory.lesson import INNATE, LEARNING, Lesson, Operator
from kernel.memory.likeness import covers
from kernel.memory.meaning import Command, Revision
from kernel.memory.ordering import reordered
from kernel.memory.reply import NothingToDo, Revised
from kernel.net.graphlet import Graphlet
from kernel.reporting import commanded
from kernel.running import Frame


def revise(commons: Commons, focus: Focus, revision: Revision) -> Run:
    """Change the lesson or do the other thing; where there is nothing to correct, say so."""
    if revision.chain.plays and all(d.tag == "FIND" for d in revision.chain.directives()):
        return (yield from _other_thing(commons, focus, revision))
    while commons.pending:  # what is corrected may just have been taught
        focus.waits.add("store")
        yield
    edited = _edited(commons, revision)
    if edited is not None:
        return (yield from _edit(commons, focus, *edited))
    if revision.later:
        return _nothing(commons, "later")
    command = commons.recent.command
    if revision.chain.tagged("KEEP") and not revision.chain.tagged("DO"):
        if command is None:
            return _nothing(commons)
        return (yield from _instead(commons, focus, keeping(command.chain, revision.chain)))
    if revision.moved:
        return _nothing(commons)
    if alteration(revision.chain) is not None:
        chain = None if command is None else _altered_command(command, revision)
        return _nothing(commons) if chain is None else (yield from _instead(commons, focus, chain))
    fits = revision.instead_of is None or (
        command is not None and has_step(command.chain, revision.instead_of)
    )
    if command is None or not revision.chain.plays or revision.of is not None or not fits:
        return _nothing(commons)
    return (yield from _instead(commons, focus, revision.chain))


def _altered_command(command: Command, revision: Revision) -> Chain | None:
    """The command with its last step otherwise, or with the one that is named."""
    chain, old = command.chain, revision.instead_of
    drawn = [d.graphlet for d in chain.directives() if d.graphlet]
    return altered(chain, revision.chain, None if old is None else meant(old, chain, drawn))


def _nothing(commons: Commons, what: Literal["revise", "later"] = "revise") -> Verdict:
    commons.replies.append(NothingToDo(what))
    return Verdict.SUCCEEDED


def _edited(commons: Commons, revision: Revision) -> tuple[Lesson, Operator] | None:
    """The lesson that is meant, and what it becomes; None where it is the last command that is meant, or nothing."""
    old, recent = revision.instead_of, commons.recent
    commanded = recent.thing in ("command", "motion")
    if revision.of is not None:
        for lesson, operator in _named(commons, revision.of):
            if old is None and alteration(revision.chain) is not None:
                other = altered(operator.chain, revision.chain, lambda _: True)
                return None if other is None else (lesson, replace(operator, chain=other))
            if old is None and not revision.moved:
                return lesson, with_more(operator, revision.chain, last=revision.last)
            changed = _changed(operator, revision)
            if changed is not None:
                return lesson, changed
        return None
    if old is None:
        taught = None if commanded else _taught(commons)
        if taught is None or not isinstance(taught.content, Operator):
            return None
        if revision.moved:
            changed = _changed(taught.content, revision)
            return None if changed is None else (taught, changed)
        if revision.last:
            return taught, with_more(taught.content, revision.chain, last=True)
        if alteration(revision.chain) is not None:
            other = altered(taught.content.chain, revision.chain)
            return None if other is None else (taught, replace(taught.content, chain=other))
        changed = with_other_end(taught.content, revision.chain)
        return None if changed is None else (taught, changed)
    likely = [recent.deed, _taught(commons)]
    for guess in likely if commanded else reversed(likely):
        if (found := _with_step(commons, guess, revision)) is not None:
            return found
    if commanded and recent.command is not None and has_step(recent.command.chain, old):
        return None
    for lesson in reversed(list(commons.lessons.values())):
        if (found := _with_step(commons, lesson, revision)) is not None:
            return found
    return None


def _with_step(
    commons: Commons, lesson: Lesson | None, revision: Revision
) -> tuple[Lesson, Operator] | None:
    if lesson is None or lesson.ident <= INNATE or lesson.ident not in commons.lessons:
        return None
    if not isinstance(lesson.content, Operator):
        return None
    changed = _changed(lesson.content, revision)
    return None if changed is None else (lesson, changed)


def _changed(operator: Operator, revision: Revision) -> Operator | None:
    """The operator with another step, or with its steps in another order; None where it has no such step."""
    old = revision.instead_of
    if revision.moved:
        (step,) = revision.chain.tagged("DO")
        return reordered(operator, step, old, revision.beside)
    if old is None:
        return None
    return with_other_step(operator, old, revision.chain, revision.beside)


def _named(commons: Commons, act: Graphlet) -> Iterator[tuple[Lesson, Operator]]:
    """Taught ways of doing that, newest first."""
    for lesson in reversed(list(commons.lessons.values())):
        operator = lesson.content
        if lesson.ident <= INNATE or not isinstance(operator, Operator):
            continue
        if (done := operator.does) is not None and covers(act, (done,), done):
            yield lesson, operator


def _taught(commons: Commons) -> Lesson | None:
    """The last lesson that a person taught and that is in force."""
    return next(iter(last_taught(commons)), None)


def _edit(commons: Commons, focus: Focus, old: Lesson, operator: Operator) -> Run:
    """One change: the old lesson goes, the new one comes, with the words and the teacher of the revision."""
    if not commons.may(focus.by, old):
        focus.failure = commons.not_yours(old)
        return Verdict.FAILED
    change = focus.changing()
    new = Lesson(0, old.kind, operator, change.words, change.by, change.at_s)
    gone = tuple(lesson.ident for lesson in with_chunks(commons, [old]))
    focus.change = replace(change, learned=(new,), retracted=gone)
    verdict = yield from Frame(commons, focus, {}).directive(Directive("EDIT", LEARNING))
    if verdict.ok:
        commons.replies.append(Revised(new))
    return verdict


def _other_thing(commons: Commons, focus: Focus, revision: Revision) -> Run:
    """The last command again, with the other thing."""
    command = commons.recent.command
    finds = [d.graphlet for d in revision.chain.directives() if d.graphlet]
    chain = None
    if command is not None and finds:
        chain = with_other_thing(command.chain, revision.instead_of, finds[-1])
    if chain is None:
        return _nothing(commons)
    return (yield from _instead(commons, focus, chain))


def _instead(commons: Commons, focus: Focus, chain: Chain) -> Run:
    """End what the last command is still doing, blame the way it chose, and do this."""
    recent = commons.recent
    if recent.focus is not None and recent.focus.ended_s is None:
        recent.focus.dismissed = True
    yield from judge(commons, focus, good=False)
    return (yield from obey(commons, focus, Command(chain)))


def obey(commons: Commons, focus: Focus, command: Command) -> Run:
    """Carry a command out; from now on it is the last one."""
    commons.recent.begin(command, focus)
    return (yield from commanded(Frame(commons, focus, {}), command.chain))


def repeat(commons: Commons, focus: Focus) -> Run:
    """Say or do the last thing again, whichever came last."""
    recent = commons.recent
    if recent.reply is not None and recent.answered:
        commons.replies.append(recent.reply)
    elif recent.command is not None:
        return (yield from obey(commons, focus, recent.command))
    else:
        commons.replies.append(NothingToDo("repeat"))
    return Verdict.SUCCEEDED
