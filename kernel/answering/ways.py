"""What can you do, do you know how, how do you, what happens when, are you allowed."""

from __future__ import annotations

from typing import Final

from kernel.action.call import GROUNDINGS
from kernel.asking import Asking, answers
from kernel.memory.explanation import Abilities, Allowed, Lessons, Taught
from kernel.memory.inference import inferences
from kernel.memory.lesson import Lesson, Operator
from kernel.memory.meant import together
from kernel.memory.recall import THINGS
from kernel.memory.reply import Answer, Reply
from kernel.net.graphlet import Graphlet

# Verbs that tell what a grounding function is for, where its first one does not tell all of it.
SHOWN: Final = {"fork_lift": ("raise", "lower"), "fork_grip": ("grab", "release")}
UNSPOKEN: Final = ("base_stop", "see")  # nothing that one could ask the robot to show


@answers("know_how", "yesno")
def knows_how(asking: Asking) -> Reply:
    """Whether any operator would be used for it."""
    act = asking.act
    if act is None:
        return Lessons(asking.question)
    return Answer(asking.question, "yes" if asking.ways_to(act) else "no")


@answers("know_how", "how", "howmany", "what")
def how(asking: Asking) -> Reply:
    """The lessons that say how; or that it is a skill of the body."""
    act = asking.act
    ways = asking.ways_to(act) if act is not None else []
    taught = tuple(filter(asking.was_taught, ways))
    if not taught and (meant := asking.aliases_of(asking.main.lex)):
        return Lessons(asking.question, meant)
    if ways and not taught:
        return Taught(asking.question, asking.asked, born=True)
    corrections = {
        lesson.ident
        for change in asking.commons.policy.changes()
        if change.retracted
        for lesson in change.learned
    }
    revised = tuple(lesson for lesson in taught if lesson.ident in corrections)
    return Lessons(asking.question, taught, revised)


@answers("means")
def means(asking: Asking) -> Reply:
    """What a word was taught to stand for; else how that is done."""
    meant = asking.aliases_of(asking.main.lex)
    return Lessons(asking.question, meant) if meant else how(asking)


@answers("happens")
def happens(asking: Asking) -> Lessons:
    """What is done on the occasion: reactions and rules that such a fact would set off; for words said, what they
    mean."""
    about = together(asking.question.about)
    if (phrase := _said(about)) is not None:
        found = [lesson for lesson in asking.lessons if _is_called(lesson, phrase)]
        return Lessons(asking.question, tuple(found[::-1]))
    with asking.supposed(about) as binding:
        node = binding[about.main]
        facts = tuple(n for n in binding.values() if n.kind not in THINGS)
        reactions = [choice.lesson for choice in asking.applicable("NOTE", node, facts)]
        for ordered in node.to("cmd"):  # "if Rick tells you to turn left"
            reactions += [choice.lesson for choice in asking.applicable("ANTE", ordered)]
        concluded = [n for n in asking.commons.memory.net if n.rule and n.reasons & set(facts)]
        rules = [step.lesson for step in inferences(concluded, asking.commons.lessons)]
    taught = [lesson for lesson in (*reactions, *rules) if lesson.words]
    return Lessons(asking.question, tuple(dict.fromkeys(taught)))


@answers("before")
def before(asking: Asking) -> Lessons:
    """What comes before an act, what forbids it, and what allows it all the same."""
    return _around(asking, "ANTE", "ALLOW")


@answers("after")
def after(asking: Asking) -> Lessons:
    """What comes after an act."""
    return _around(asking, "POST")


def _around(asking: Asking, *tags: str) -> Lessons:
    found = asking.about_acts(asking.act, *tags) if asking.act is not None else []
    return Lessons(asking.question, tuple(found))


def _said(about: Graphlet) -> str | None:
    """The words in "what happens when I say ..."."""
    main = about.head
    if main is None or not ("say" in main.lex or len(about.terms) == 1):
        return None
    return next((term.literal for term in about if term.literal), None)


def _is_called(lesson: Lesson, phrase: str) -> bool:
    operator = lesson.content
    done = operator.does if isinstance(operator, Operator) else None
    return done is not None and done.head is not None and phrase.lower() in done.head.lex


@answers("abilities")
def abilities(asking: Asking) -> Abilities:
    """Verbs of the body, and taught acts, newest first."""
    born = [
        verb
        for name, grounding in sorted(GROUNDINGS.items())
        if name not in UNSPOKEN
        for verb in SHOWN.get(name, grounding.verbs[:1])
    ]
    acts = [
        lesson.content.does
        for lesson in reversed(asking.lessons)
        if isinstance(lesson.content, Operator)
    ]
    verbs: dict[frozenset[str], Graphlet] = {}
    for act in acts:
        if act is not None:
            verbs.setdefault(act.words(), act)
    return Abilities(tuple(born), tuple(verbs.values()))


@answers("allowed")
def allowed(asking: Asking) -> Reply:
    """A dry run finds whatever would forbid it, also a step of it; without an act, the prohibitions there are."""
    act, chain = asking.act, asking.question.chain
    if chain is not None:  # "are you allowed to touch the vase when nobody is watching"
        act = next(chain.graphlets())
        if told := asking.about_acts(act, "ANTE", "ALLOW"):
            return Lessons(asking.question, tuple(told))
    if act is not None and asking.question.ask != "yesno":  # "what are you not allowed to touch"
        return Lessons(asking.question, tuple(asking.about_acts(act, "ANTE", "ALLOW")))
    if act is None:
        forbidding = [lesson for lesson in reversed(asking.lessons) if lesson.prohibits]
        return Lessons(asking.question, tuple(forbidding))
    return Allowed(asking.question, asking.imagine(asking.command(act)).trouble)
