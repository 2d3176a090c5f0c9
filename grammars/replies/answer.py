"""Answers: yes, no, unknown, or what was found."""

from __future__ import annotations

from dataclasses import replace

from grammars.render import act_in_words, render, thing_in_words
from grammars.render.questions import claim, indirect
from grammars.render.telling import SAYING, Telling, is_predicate
from grammars.render.things import proper
from grammars.replies import Said, both, renders
from kernel.memory.meaning import Fact, Question
from kernel.memory.reply import Answer
from kernel.net.graphlet import Graphlet, Term


@renders(Answer)
def answer(reply: Answer) -> Said:
    """ "Yes, Mary is a person." """
    asked = reply.question
    match reply.verdict:
        case "unknown":
            return both(_unknown(asked))
        case "found":
            return both(_found(asked, reply.found))
        case verdict:
            return both(f"{verdict}, {_claimed(asked, verdict == 'yes')}")


def _claimed(asked: Question, holds: bool) -> str:
    """What a yes/no question asks, affirmed or denied."""
    main = asked.about.main
    match asked.topic:
        case "know_how":
            return f"I {'' if holds else 'do not '}know how to {act_in_words(asked.about)}"
        case "did":
            done = act_in_words(asked.about, (), "past" if holds else "base")
            return f"I {'' if holds else 'did not '}{done}"
    said = claim(Telling((asked.about,), (), "robot"), asked.about)
    negated = asked.about.term(main).negated if main in asked.about.names else False
    if holds or negated:
        return str(said)
    return f"{said.subject} {said.verb} not {said.asked}"


def _unknown(asked: Question) -> str:
    if asked.topic == "identity":
        return "I don't know who you are"
    if asked.topic == "taught":
        return f"nobody taught me to {act_in_words(asked.about)}"
    if asked.topic == "know_how":
        return f"I don't know how to {act_in_words(asked.about)}"
    if asked.topic == "know_about":
        return f"I know nothing about {thing_in_words(asked.about.main, (asked.about,))}"
    if asked.topic in ("doing", "did", "learned"):
        return {"doing": "I am doing nothing", "did": "I did nothing"}.get(
            asked.topic, "nobody taught me anything"
        )
    return "I don't know why" if asked.ask == "why" else f"I don't know {indirect(asked, 'robot')}"


def _found(asked: Question, found: tuple[Graphlet, ...]) -> str:
    told = [_told(asked, graphlet) for graphlet in found]
    if not told:
        return {
            "doing": "I am doing nothing",
            "did": "I did nothing",
            "learned": "nobody taught me anything today",
        }.get(asked.topic, "nothing that I know of")
    listed = " and ".join(filter(None, (", ".join(told[:-1]), told[-1])))
    match asked.topic:
        case "identity":
            return f"you are {listed}"
        case "doing":
            return f"I am {listed}"
        case "did":
            return f"I {listed}"
        case "taught":
            return f"{listed} taught me to {act_in_words(asked.about)}"
    return f"because {listed}" if asked.ask == "why" else listed


def _told(asked: Question, graphlet: Graphlet) -> str:
    """One thing found, in words: an action, a name, what is so of the thing asked about, or which thing it is."""
    main = Telling((graphlet,)).term(graphlet.main)
    if asked.topic in ("doing", "did"):
        return act_in_words(graphlet, (), "gerund" if asked.topic == "doing" else "past")
    if asked.topic == "identity":
        return proper(min(main.lex - {"me", "you"}, default="somebody"))
    if is_predicate(main):
        return render(_definite(graphlet, main), "robot")
    if main.literal is not None:
        return main.literal
    return _news(asked, graphlet) or thing_in_words(graphlet.main, (graphlet,))


def _definite(graphlet: Graphlet, main: Term) -> Graphlet:
    """The same, its subject spoken of as known: "the block is red"."""
    subjects = {other for role, other in main.links if role in (*SAYING, "agt")}
    terms = (replace(t, ref="the") if t.name in subjects else t for t in graphlet)
    return Graphlet(tuple(terms), graphlet.main)


def _news(asked: Question, graphlet: Graphlet) -> str:
    """What a description says of its thing that the question did not; "" where the question asks which thing it is."""
    wanted = asked.wanted or asked.about.main
    roles = ("loc",) if asked.ask == "where" else SAYING
    known = [t for t in asked.about if (t.name == wanted and t.lex) or ("ako", wanted) in t.links]
    if asked.ask not in ("where", "who", "what") or not known:
        return ""
    new = [
        term
        for term in graphlet
        if any((role, graphlet.main) in term.links for role in roles)
        and not term.lex & asked.about.words()
    ]
    if not new:
        return ""
    modifying = [t for t in graphlet if any(other.name in dict(t.links).values() for other in new)]
    claimed = [*new, *(t for t in modifying if t not in new)]
    main = replace(Telling((graphlet,)).term(graphlet.main), ref="the")
    rest = (main, *(t for t in graphlet if t not in claimed and t.name != graphlet.main))
    return render(
        Fact(Graphlet(tuple(claimed), new[0].name), (Graphlet(rest, graphlet.main),)), "robot"
    )
