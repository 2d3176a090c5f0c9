"""Answers: yes, no, unknown, or what was found."""

from __future__ import annotations

from grammars.render import act_in_words, claim_in_words, definite, thing_in_words
from grammars.render.clauses import clause
from grammars.render.names import proper
from grammars.render.questions import claim, indirect
from grammars.render.telling import SAYING, Telling, is_predicate
from grammars.replies import Said, both, listed, renders
from kernel.memory.meaning import Question
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
        case "doing":
            return f"I am {'' if holds else 'not '}{act_in_words(asked.about, (), 'gerund')}"
        case "ordered":
            return "nobody told me to do that, as far as I remember"
        case "did":
            done = act_in_words(asked.about, (), "past" if holds else "base")
            return f"I {'' if holds else 'did not '}{done}"
    negated = asked.about.term(main).negated if main in asked.about.names else False
    so = asked.about if holds or negated else asked.about.denied()
    return str(claim(Telling((so,), (), "robot"), so))


def _unknown(asked: Question) -> str:
    """Not knowing, with what is not known."""
    match asked.topic, asked.ask:
        case "identity", _:
            return "I don't know who you are"
        case "doing", _:
            return "I am doing nothing"
        case "ordered", ask:
            return "nobody told me to do that, as far as I remember"
        case "did", "what":
            return "I did nothing"
        case "did", ask:
            head = {"yesno": "whether", "howmany": "how many times"}.get(ask, ask)
            return f"I don't know {head} I {act_in_words(asked.about, (), 'past')}"
    return f"I don't know {indirect(asked, 'robot')}"


def _is_act(about: Graphlet) -> bool:
    return Telling((about,)).term(about.main).kind == "act"


def _found(asked: Question, found: tuple[Graphlet, ...]) -> str:
    told = [_told(asked, graphlet) for graphlet in found]
    if not told:
        return "I am doing nothing" if asked.topic == "doing" else "nothing that I know of"
    answer = listed(told)
    match asked.topic:
        case "identity":
            return f"you are {answer}"
        case "doing":
            return f"I am {answer}"
        case "did":
            return f"I {answer}"
    return answer


def _told(asked: Question, graphlet: Graphlet) -> str:
    """One thing found, in words: an action, a name, what is so of the thing asked about, or which thing it is."""
    main = Telling((graphlet,)).term(graphlet.main)
    if _is_act(graphlet) and asked.topic in ("doing", "did"):
        return act_in_words(graphlet, (), "gerund" if asked.topic == "doing" else "past")
    if asked.ask == "who" and "you" in main.lex:
        return f"I am {proper(min(main.lex - {'you'}, default='')) or 'the robot'}"
    if asked.topic == "identity":
        return proper(min(main.lex - {"me", "you"}, default="somebody"))
    if is_predicate(main):
        return claim_in_words(graphlet)
    if main.literal is not None:
        return main.literal
    return _news(asked, graphlet) or _which(asked, graphlet)


def _news(asked: Question, graphlet: Graphlet) -> str:
    """What a description says of its thing that the question did not; "" where the question asks which thing it is."""
    wanted = asked.wanted or asked.about.main
    known = [t for t in asked.about if (t.name == wanted and t.lex) or ("ako", wanted) in t.links]
    if asked.ask not in ("who", "what") or not known:
        return ""
    new = [t for t in _said_of(graphlet) if not t.lex & asked.about.words()]
    if not new:
        return ""
    telling = Telling((definite(graphlet),), (), "robot")
    telling.hold_back(new)
    clauses = [clause(telling, term, "") for term in new]
    subject, verb = clauses[0].subject, clauses[0].verb
    return f"{subject} {verb} {listed([said.asked for said in clauses])}"


def _which(asked: Question, graphlet: Graphlet) -> str:
    """The thing by what the question did not say of it: "a red block"."""
    said = {t.name for t in _said_of(graphlet) if t.lex & asked.about.words()}
    rest = Graphlet(tuple(t for t in graphlet if t.name not in said), graphlet.main)
    return thing_in_words(graphlet.main, (rest,))


def _said_of(graphlet: Graphlet) -> list[Term]:
    return [t for t in graphlet if any((role, graphlet.main) in t.links for role in SAYING)]
