"""Who taught you, who told you, when did you learn, how do you know: provenance."""

from __future__ import annotations

from kernel.asking import Asking, answers
from kernel.memory.experience import Source
from kernel.memory.explanation import Taught
from kernel.memory.inference import inferences
from kernel.memory.lesson import Lesson, Rule
from kernel.memory.meant import grounded, words_alike
from kernel.memory.recall import THINGS, is_so
from kernel.net.graphlet import Graphlet
from kernel.net.match import holds, matches
from kernel.net.node import REMEMBERED, Node


@answers("taught")
def taught(asking: Asking) -> Taught:
    """For an act, who taught it, or forbade it where it is denied; for "that", the newest lesson or told fact; for what
    is so, who said it or what it follows from."""
    if not asking.about_act:
        return provenance(asking)
    act = asking.act
    if act is None:
        claim = asking.just_claimed
        return _newest(asking) if claim is None else provenance(asking.of(claim))
    tags = ("ANTE",) if asking.main.negated else ("DO",)
    lessons = asking.about_acts(act, *tags)
    if asking.main.negated:
        lessons = [lesson for lesson in lessons if lesson.prohibits]
    if not lessons and not asking.main.negated:
        ways = asking.ways_to(act)
        lessons = list(filter(asking.was_taught, ways))
        if ways and not lessons:
            lessons = list(asking.aliases_of(asking.main.lex)) or _steps_of(asking, act)
            ordered = next((d.source for d in asking.deeds() if d.source), None)
            if not lessons:
                return Taught(asking.question, asking.asked, told=ordered, born=True)
        lessons = lessons or asking.about_acts(act, "NOTE", "ANTE", "POST", "ALLOW")
    return Taught(asking.question, asking.asked, tuple(lessons))


def _steps_of(asking: Asking, act: Graphlet) -> list[Lesson]:
    """For a particular act of the body ("say phew"; not "drive"): the lesson by which it was done last, unless that was
    a plain order; where it was never done, lessons that have it as a step."""
    if len(act.terms) < 2:
        return []
    deed = next(asking.deeds(), None)
    if deed is not None:
        return [lesson for lesson in deed.within[-1:] if lesson.words]
    return asking.with_step(act)


def _newest(asking: Asking) -> Taught:
    lesson = next((x for x in reversed(asking.lessons) if not x.origins), None)
    told = next(reversed(asking.commons.experience.sources.values()), None)
    if told is not None and (lesson is None or told.at_s > lesson.at_s):
        return Taught(asking.question, asking.asked, told=told)
    return Taught(asking.question, asking.asked, (lesson,) if lesson is not None else ())


def provenance(asking: Asking) -> Taught:
    """Where it has from what the question says is so."""
    commons, about = asking.commons, asking.question.about
    memory = commons.memory
    known = grounded(about, memory)
    asking.call_to_mind(known.values())
    start = {name: node for name, node in known.items() if name in about.mentioned}
    if not start and (rules := _rules(asking, about)):  # "a girl is a person": nobody in particular
        return Taught(asking.question, asking.asked, tuple(rules))
    for binding in filter(is_so, matches(about, memory.net, REMEMBERED, start, 0.0)):
        node = binding[about.main]
        if node.kind in THINGS:  # "who told you about the block"
            return Taught(asking.question, asking.asked, told=_told_about(asking, node))
        if node.rule:
            steps = inferences([node], commons.lessons, None, commons.news)
            return Taught(asking.question, asking.asked, steps=steps)
        if (lesson := fact_lesson(asking, node)) is not None:
            return Taught(asking.question, asking.asked, (lesson,))
        told = commons.experience.sources.get(node)
        noticed = told is None and node not in memory.told
        return Taught(asking.question, asking.asked, told=told, noticed=noticed)
    return Taught(asking.question, asking.asked)


def fact_lesson(asking: Asking, node: Node) -> Lesson | None:
    """The stored lesson that says of the node what it says."""
    commons = asking.commons
    for ident in sorted(commons.facts, reverse=True):
        lesson = commons.lessons[ident]
        fact = lesson.content
        if not asking.was_taught(lesson) or not isinstance(fact, Graphlet):
            continue
        if holds(fact, commons.memory.net, REMEMBERED, {fact.main: node}, 0.0):
            return lesson
    return None


def _told_about(asking: Asking, thing: Node) -> Source | None:
    """Who told the newest fact about a thing."""
    facts = sorted((node for _, node in thing.into), key=lambda node: -node.stamp)
    for node in facts:
        if (lesson := fact_lesson(asking, node)) is not None:
            return Source(lesson.teacher, lesson.words, lesson.at_s)
        if (told := asking.commons.experience.sources.get(node)) is not None:
            return told
    return None


def _rules(asking: Asking, about: Graphlet) -> list[Lesson]:
    """Rules and aliases that say just that: "who told you that a girl is a person"."""
    return [
        lesson
        for lesson in reversed(asking.lessons)
        if isinstance(lesson.content, Rule)
        and words_alike(
            lesson.content.condition.words() | lesson.content.conclusion.words(), about.words()
        )
    ]
