"""Questions, as they are asked and as they are taken up in an answer."""

from __future__ import annotations

from grammars.render.clauses import Clause, clause, naming
from grammars.render.deeds import be, deed
from grammars.render.telling import Telling, Voice, is_predicate
from grammars.render.things import thing
from kernel.memory.meaning import Question
from kernel.net.graphlet import Graphlet


def question(asked: Question, voice: Voice) -> str:
    """The question itself: "is Mary a person", "where is the red block"."""
    telling = Telling((asked.about,), (), voice)
    main = asked.about.main
    you, me = ("I", "me") if voice == "robot" else ("you", "you")
    match asked.topic:
        case "identity":
            return "who are you" if voice == "robot" else "who am I"
        case "doing":
            return f"what {be(you)} {you} doing"
        case "know_about":
            return f"what do {you} know about {thing(telling, main)}"
        case "know_how" if asked.ask == "yesno":
            return f"do {you} know how to {deed(telling, main)}"
        case "know_how":
            return f"how do {you} {deed(telling, main)}"
        case "taught":
            return f"who taught {me} to {deed(telling, main)}"
        case "learned":
            return f"what did {you} learn today"
    if asked.topic in ("did", "why") or asked.ask == "why":
        return _past(telling, asked, you)
    return _present(telling, asked)


def _past(telling: Telling, asked: Question, you: str) -> str:
    wh = {"yesno": "", "howmany": "how many times "}.get(asked.ask, f"{asked.ask} ")
    if not telling.term(asked.about.main).lex:
        return f"{wh}did {you} just do" if asked.ask == "what" else f"{wh}did {you} do that"
    return f"{wh}did {you} {deed(telling, asked.about.main)}"


def _present(telling: Telling, asked: Question) -> str:
    match asked.ask:
        case "yesno":
            said = claim(telling, asked.about)
            return f"{said.verb} {said.subject} {said.asked}"
        case "where" | "when" | "how":
            subject = thing(telling, asked.wanted or asked.about.main, "subject")
            return f"{asked.ask} {be(subject)} {subject}"
        case "howmany":
            return f"how many {thing(telling, asked.wanted or asked.about.main)} are there"
        case ask:
            if asked.about.main == asked.wanted or not asked.wanted:
                subject = thing(telling, asked.about.main, "subject")
                return f"{ask} {be(subject)} {subject}"
            said = claim(telling, asked.about)
            return f"{ask} {said.stated}"


def claim(telling: Telling, about: Graphlet) -> Clause:
    """What a graphlet says, as one clause."""
    main = telling.term(about.main)
    if not is_predicate(main):
        return naming(telling, main)
    return clause(telling, main, "")
