"""How experience and feedback move strengths: preferences of operators, beliefs of rules.

Failure of an operator after which another one succeeded lowers its preference; success moves a lowered one back toward
the taught value, never above; only praise raises above it. What prepares, tidies up, forbids or permits never adapts
(mind.md). Taught strengths stay with the lessons; every move is a change of the journal.
"""

from __future__ import annotations

from collections.abc import Generator, Iterable
from dataclasses import replace
from typing import Final

from kernel.action.step import Run
from kernel.action.verdict import Verdict
from kernel.commons import Commons
from kernel.memory.attention import Focus
from kernel.memory.change import LEAST, MOST, SESSION, Adapted, Change
from kernel.memory.lesson import INNATE, Lesson, Operator, Rule
from kernel.memory.meaning import Command, Fact, Revision
from kernel.memory.reply import FeedbackTaken
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding, matches
from kernel.net.node import BAND_2

SUREST: Final = 1.0
ADAPTING: Final = ("NOTE", "DO", "FIND", "CHK", "ACH")


def adapts(lesson: Lesson) -> bool:
    """Whether its preference may move: advice does, the body's own skills and the law do not."""
    operator = lesson.content
    return (
        isinstance(operator, Operator)
        and operator.trigger.tag in ADAPTING
        and INNATE < lesson.ident < SESSION
    )


def begun(commons: Commons, focus: Focus, lesson: Lesson) -> None:
    """A focus has begun to follow an operator on its top level: what "that" is in praise and blame.

    A reaction to being praised is not what is praised.
    """
    if focus.meaning is None or isinstance(focus.meaning, Command | Fact | Revision):
        commons.recent.deed = lesson


def ended(
    commons: Commons, focus: Focus, lesson: Lesson, failed: list[Lesson], verdict: Verdict
) -> None:
    """An operator has ended. failed: those tried before it for the same directive; it joins them or ends the list."""
    if not adapts(lesson):
        return
    if verdict is Verdict.FAILED:
        failed.append(lesson)
    elif verdict is Verdict.SUCCEEDED:
        moves = [_lowered(commons, x, commons.settings.failure_step) for x in failed]
        strength = commons.policy.strength(lesson)
        recovered = min(lesson.strength, strength + commons.settings.recovery_step)
        if strength < lesson.strength:
            moves.append(Adapted(lesson.ident, strength, recovered))
        failed.clear()
        _adapt(commons, focus, moves)


def feedback(commons: Commons, focus: Focus, *, good: bool, answered: bool = False) -> Run:
    """Praise or blame the operator of the last deed, and answer; a person's change, so it can be undone.

    answered: it was a stop as well, and the robot has said that it stopped.
    """
    judged = yield from judge(commons, focus, good=good)
    if not answered:
        commons.replies.append(FeedbackTaken(good, judged))
    return Verdict.SUCCEEDED


def judge(commons: Commons, focus: Focus, *, good: bool) -> Generator[None, None, Lesson | None]:
    """Praise or blame the operator of the last deed; which one that was, None where none can be."""
    deed = commons.recent.deed
    if deed is None or not adapts(deed) or deed.ident not in commons.lessons:
        return None
    yield from commons.commit(focus, _feedback_change(commons, focus, deed, good=good))
    return deed


def _feedback_change(commons: Commons, focus: Focus, lesson: Lesson, *, good: bool) -> Change:
    """One word of praise or blame, within the bounds."""
    strength = commons.policy.strength(lesson)
    if good:
        raised = max(strength, min(MOST, strength + commons.settings.praise_step))
        move = Adapted(lesson.ident, strength, raised)
    else:
        move = _lowered(commons, lesson, commons.settings.blame_step)
    return replace(focus.changing(), adapted=(move,))


def weigh(commons: Commons, focus: Focus, fact: Graphlet, binding: Binding) -> None:
    """A person says that something is so: rules that had concluded it, or its opposite, are believed more, or less."""
    memory, step = commons.memory, commons.settings.belief_step
    memory.refresh()
    known = {n: node for n, node in memory.persons(fact, binding).items() if n in fact.mentioned}
    moves: dict[int, Adapted] = {}
    for pattern, way in ((fact, step), (fact.denied(), -step)):
        for found in matches(pattern, memory.net, BAND_2, known, 0.0):
            lesson = commons.lessons.get(found[fact.main].rule)
            if lesson is None or not isinstance(lesson.content, Rule):
                continue
            belief = commons.policy.strength(lesson)
            after = max(min(LEAST, belief), min(SUREST, belief + way))
            moves[lesson.ident] = Adapted(lesson.ident, belief, after)
    _adapt(commons, focus, moves.values())


def _lowered(commons: Commons, lesson: Lesson, step: float) -> Adapted:
    strength = commons.policy.strength(lesson)
    return Adapted(lesson.ident, strength, max(min(LEAST, strength), strength - step))


def _adapt(commons: Commons, focus: Focus, moves: Iterable[Adapted]) -> None:
    """Journal what the robot made of it by itself; nobody waits for it."""
    moved = tuple(move for move in moves if move.after != move.before)
    if moved:
        commons.keep(focus, replace(focus.changing(), adapted=moved, own=True))
