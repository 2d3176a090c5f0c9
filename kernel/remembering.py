"""What becomes of a deed, noted down as it happens: its beginning, its end, and what never came to be."""

from __future__ import annotations

from kernel.action.step import Run
from kernel.action.verdict import Verdict
from kernel.commons import Commons
from kernel.memory.attention import Failure, Focus
from kernel.memory.experience import Deed, Occasion, Source, Trouble
from kernel.memory.inference import of_match, told_of
from kernel.memory.lesson import LEARNING, Lesson, Operator
from kernel.memory.meaning import Command
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding
from kernel.net.node import Node


def begin(
    commons: Commons,
    focus: Focus,
    act: Node,
    within: tuple[Lesson, ...],
    occasion: Occasion | None,
    parent: int,
) -> int:
    """A deed begins; its number."""
    commons.memory.refresh()
    deed = Deed(
        number=0,
        act=told_of(act, news=commons.news),
        understood=told_of(act, concluded=True),
        focus=focus.number,
        began_s=commons.tick.now_s,
        parent=parent,
        source=None if occasion is not None else source(focus),
        within=within,
        occasion=occasion,
    )
    return commons.experience.begin(deed).number


def remembered(commons: Commons, focus: Focus, number: int, run: Run) -> Run:
    """Carry it out, and note how it ended, also where it was cut short."""
    verdict = Verdict.STOPPED
    try:
        verdict = yield from run
    finally:
        trouble = None if verdict.ok else trouble_of(commons, focus, verdict)
        commons.experience.end(number, commons.tick.now_s, verdict, trouble)
    return verdict


def unreached(commons: Commons, focus: Focus, verdict: Verdict) -> None:
    """A command has come to nothing: the deeds it asked for that never began are remembered with the reason."""
    meaning = focus.meaning
    if verdict is Verdict.FAILED and focus.lesson is not None:  # it may not be taught
        _never_began(commons, focus, verdict, LEARNING)
    if verdict.ok or not isinstance(meaning, Command):
        return
    wanted = meaning.chain.tagged("DO")
    looked_up = [term for find in meaning.chain.tagged("FIND") for term in find]
    begun = [
        deed
        for deed in commons.experience
        if deed.focus == focus.number and deed.parent == 0 and deed.occasion is None
    ]
    for graphlet in wanted[len(begun) :]:
        terms = {term.name: term for term in (*looked_up, *graphlet)}
        _never_began(commons, focus, verdict, Graphlet(tuple(terms.values()), graphlet.main))


def _never_began(commons: Commons, focus: Focus, verdict: Verdict, act: Graphlet) -> None:
    now_s = commons.tick.now_s
    deed = Deed(0, act, act, focus.number, now_s, source=source(focus))
    number = commons.experience.begin(deed).number
    commons.experience.end(number, now_s, verdict, trouble_of(commons, focus, verdict))


def trouble_of(commons: Commons, focus: Focus, verdict: Verdict) -> Trouble:
    """Why the focus is failing, as a value."""
    if verdict is Verdict.STOPPED:
        return Trouble("stopped")
    failure = focus.failure or Failure("no_way")
    act = told_of(failure.act, news=commons.news) if failure.act is not None else None
    return Trouble(failure.reason, act, failure.detail, failure.by, failure.steps)


def occasion_of(commons: Commons, lesson: Lesson, binding: Binding) -> Occasion | None:
    """What made a NOTE operator apply."""
    operator = lesson.content
    if not isinstance(operator, Operator) or operator.trigger.graphlet is None:
        return None
    trigger = operator.trigger.graphlet
    steps = of_match(operator.patterns, binding, commons.lessons, commons.news)
    return Occasion(lesson, told_of(binding[trigger.main], news=commons.news), steps)


def source(focus: Focus) -> Source | None:
    """The utterance a focus came from."""
    if focus.heard is None:
        return None
    said = focus.heard.utterance
    speakers = focus.speech_act.to("agt") if focus.speech_act is not None else ()
    names = {name for speaker in speakers for name in speaker.lex} - {"me"}
    return Source(min(names, default=""), said.text, said.at_s)
