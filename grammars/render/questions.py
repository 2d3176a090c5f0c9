"""Questions, as they are asked and as they are taken up in an answer."""

from __future__ import annotations

from grammars.morphology import plural
from grammars.render.clauses import Clause, clause, conditions, naming
from grammars.render.deeds import be, deed
from grammars.render.procedures import procedure
from grammars.render.telling import Telling, Voice, is_predicate, linked, word
from grammars.render.things import description, thing
from kernel.memory.meaning import Question
from kernel.net.graphlet import Graphlet


def question(asked: Question, voice: Voice) -> str:
    """The question itself: "is Mary a person", "where is the red block"."""
    telling = Telling((asked.about,), (), voice)
    main = asked.about.main
    you, me = ("I", "me") if voice == "robot" else ("you", "you")
    match asked.topic:
        case "taught":
            return _taught(telling, asked, you, me)
        case "would":
            return _would(telling, asked, you)
        case "allowed" if telling.term(main).lex:
            return f"{be(you)} {you} allowed to {deed(telling, main)}"
        case "allowed":
            return f"what {be(you)} {you} not allowed to do"
        case "abilities":
            return f"what can {you} do"
        case "identity":
            return "who are you" if voice == "robot" else "who am I"
        case "doing" if asked.ask == "yesno":
            return f"{be(you)} {you} {deed(telling, main, 'gerund')}"
        case "doing":
            return f"what {be(you)} {you} doing"
        case "know_about" if asked.ask == "yesno":
            return f"do {you} know anything about {thing(telling, main)}"
        case "know_about":
            return f"what do {you} know about {thing(telling, main)}"
        case "know_how" if asked.ask == "yesno":
            return f"do {you} know how to {deed(telling, main)}"
        case "know_how":
            return f"how do {you} {deed(telling, main)}"
        case "means":
            return f"what does {min(telling.term(main).lex, default='that')} mean"
        case "before" | "after":
            return f"what happens {asked.topic} {you} {deed(telling, main)}"
        case "happens":
            return f"what happens when {conditions(telling, asked.about)}"
        case "learned":
            return f"what did {you} learn today"
    if asked.topic in ("did", "why") or asked.ask == "why":
        return _past(telling, asked, you)
    return _present(telling, asked)


def _taught(telling: Telling, asked: Question, you: str, me: str) -> str:
    """Who said so, why it is so, when that was."""
    main = telling.term(asked.about.main)
    if is_predicate(main) and (main.kind != "act" or linked(main, "agt")):
        said = claim(telling, asked.about)
        if asked.ask == "why":
            return f"why {said.verb} {said.subject} {said.asked}"
        return f"who told {me} that {said}"
    what = f"to {deed(telling, main.name)}" if main.lex else "that"
    if asked.ask == "when":
        return f"when did {you} learn {what}"
    return f"who told {me} not {what}" if main.negated else f"who taught {me} {what}"


def _would(telling: Telling, asked: Question, you: str) -> str:
    """What is supposed, said or so."""
    if asked.chain is None:
        return f"what would {you} do if {conditions(telling, asked.about)}"
    steps = procedure(Telling(tuple(asked.chain.graphlets()), (), telling.voice), asked.chain)
    return f"what would {you} do if {'you' if you == 'I' else 'I'} said {steps}"


def _past(telling: Telling, asked: Question, you: str) -> str:
    wh = {"yesno": "", "howmany": "how many times "}.get(asked.ask, f"{asked.ask} ")
    denied = "not " if telling.term(asked.about.main).negated else ""
    main = telling.term(asked.about.main)
    if asked.ask == "why" and not main.lex and not main.ref:
        return f"why {denied}".strip()
    if not main.lex:
        return f"{wh}did {you} just do" if asked.ask == "what" else f"{wh}did {you} {denied}do that"
    return f"{wh}did {you} {denied}{deed(telling, asked.about.main)}"


def _present(telling: Telling, asked: Question) -> str:
    head, said = _asked(telling, asked)
    if asked.ask == "yesno":
        return f"{said.verb} {said.subject} {said.asked}"
    if said.subject:
        return f"{head} {said.verb} {said.subject} {said.asked}".rstrip()
    return f"{head} {said.stated}"


def indirect(asked: Question, voice: Voice) -> str:
    """What is not known: "whether Mary is a person", "where the red block is"."""
    head, said = _asked(Telling((asked.about,), (), voice), asked)
    return f"{'whether' if asked.ask == 'yesno' else head} {said}".replace("  ", " ").strip()


def _asked(telling: Telling, asked: Question) -> tuple[str, Clause]:
    """The question words, and the clause that follows; it has no subject where the question words are that."""
    main = telling.term(asked.about.main)
    wanted = asked.wanted or main.name
    match asked.ask:
        case "yesno":
            return "", claim(telling, asked.about)
        case "where" if linked(main, "loc"):
            telling.stated.add(main.name)
            return "where", _being(thing(telling, linked(main, "loc"), "subject"))
        case "what" if main.name == wanted and linked(main, "hq"):
            telling.stated.add(main.name)
            attribute = " ".join(word(kind) for kind in telling.take(main.name, "ako"))
            return f"what {attribute}", _being(thing(telling, linked(main, "hq"), "subject"))
        case "how" if linked(main, "hq"):
            telling.stated.update((main.name, wanted))
            return f"how {word(main)}", _being(thing(telling, linked(main, "hq"), "subject"))
        case "howmany" | "which":
            telling.hold_back([main])
            several = asked.ask == "howmany"
            head = f"{'how many' if several else 'which'} {_bare(telling, wanted, several)}"
            telling.release([main])
            if not is_predicate(main):
                return head, Clause("there", "are", "are", "")
            telling.mention(wanted)
            rest = claim(telling, asked.about)
            plural_verb = "are " + rest.asked if several and rest.verb == "is" else rest.stated
            return head, Clause("", rest.verb, plural_verb, rest.asked)
        case ask:
            if main.name == wanted:
                return ask, _being(thing(telling, wanted, "subject"))
            if linked(main, "own") and linked(main, "of") == wanted:
                thing_ = thing(telling, linked(main, "own"), "subject")
                return "who", Clause(thing_, "does", "belongs to", "belong to")
            rest = claim(telling, asked.about)
            if main.kind == "act" and linked(main, "obj") == wanted and linked(main, "agt"):
                stated, asked_ = (
                    said.removesuffix(" something") for said in (rest.stated, rest.asked)
                )
                return ask, Clause(rest.subject, rest.verb, stated, asked_)
            return ask, Clause("", rest.verb, rest.stated, rest.asked)


def _being(subject: str) -> Clause:
    return Clause(subject, be(subject), be(subject), "")


def _bare(telling: Telling, name: str, several: bool) -> str:
    """The description of a thing without article."""
    before, noun, after = description(telling, name, "one")
    return " ".join(filter(None, (before, plural(noun) if several else noun, after)))


def claim(telling: Telling, about: Graphlet) -> Clause:
    """What a graphlet says, as one clause."""
    main = telling.term(about.main)
    if not is_predicate(main):
        return naming(telling, main)
    return clause(telling, main, "")
