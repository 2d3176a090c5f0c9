"""Questions, as they are asked and as they are taken up in an answer."""

from __future__ import annotations

from typing import Final

from grammars.morphology import plural
from grammars.render.clauses import Clause, clause, conditions, naming
from grammars.render.deeds import be, deed
from grammars.render.procedures import procedure
from grammars.render.telling import Telling, Voice, is_predicate, linked, word
from grammars.render.things import description, thing
from kernel.memory.meaning import Question
from kernel.net.graphlet import Graphlet, Term


def question(asked: Question, voice: Voice) -> str:
    """The question itself: "is Mary a person", "where is the red block"."""
    telling = Telling((asked.about,), (), voice)
    main = asked.about.main
    you, me = ("I", "me") if voice == "robot" else ("you", "you")
    named = asked.topic != "allowed" or telling.term(main).lex
    if (
        named
        and asked.topic in GAPPED
        and asked.ask != "yesno"
        and (asked.wanted or asked.ask in ADVERBS)
    ):
        return _own_deed(telling, asked, you)
    match asked.topic:
        case "ordered":
            return _ordered(telling, asked)
        case "occasion":
            return f"when do {you} {deed(telling, main)}"
        case "lasting":
            return f"how long did {you} {deed(telling, main)}"
        case "takes":
            return f"how long does it take to {deed(telling, main)}"
        case "why" if asked.ask == "what" and telling.term(main).lex:
            return f"what made {you} {deed(telling, main)}"
        case "either":
            return _either(telling, asked)
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
        case "happens" if asked.ask == "yesno":
            return f"does anything happen when {conditions(telling, asked.about)}"
        case "happens":
            return f"what happens when {conditions(telling, asked.about)}"
        case "learned":
            return f"what did {you} learn today"
    if asked.topic in ("did", "why") or asked.ask == "why":
        return _past(telling, asked, you)
    return _present(telling, asked)


GAPPED: Final = ("did", "doing", "allowed", "extent")
ADVERBS: Final = ("where", "how", "which")


def _own_deed(telling: Telling, asked: Question, you: str) -> str:
    """A deed of the robot's of which something is asked: "which cup did you lift", "where are you going"."""
    main = asked.about.main
    if asked.topic == "extent":
        amt = telling.take(main, "amt")
        head = f"how many {plural(word(amt[0]))}" if amt else "how far"
    elif asked.wanted == main:
        return f"what {be(you)} {you} doing" if asked.topic == "doing" else f"what did {you} do"
    else:
        head = (
            _head(telling, asked)
            if asked.wanted
            else "which way"
            if asked.ask == "which"
            else asked.ask
        )
    negated = "not " if telling.term(main).negated else ""
    match asked.topic:
        case "doing":
            said = f"{head} {be(you)} {you} {deed(telling, main, 'gerund') if telling.term(main).lex else ''}"
        case "allowed":
            said = f"{head} {be(you)} {you} {negated}allowed to {deed(telling, main)}"
        case _ if not telling.term(main).lex and not telling.term(main).ref:
            said = f"{head} have {you} been"
        case _:
            said = f"{head} did {you} {deed(telling, main)}"
    return _spaced(said)


def _head(telling: Telling, asked: Question) -> str:
    """The question words, with what is said of the thing wanted; it is missing in what follows."""
    owned = next((t for t in telling.terms.values() if linked(t, "of") == asked.wanted), None)
    if owned is not None:
        telling.stated.add(owned.name)
        telling.gap = linked(owned, "own")
        return f"whose {_bare(telling, telling.gap, several=False)}"
    telling.gap = asked.wanted
    said = telling.about(asked.wanted, "ako", "hq", "loc", "own")
    words = {"howmany": "how many"}.get(asked.ask, asked.ask)
    if asked.ask in ("howmany", "which") or any(linked(t, "ako") for t in said):
        words += " " + _bare(telling, asked.wanted, asked.ask == "howmany")
    return words


def _ordered(telling: Telling, asked: Question) -> str:
    """What somebody told the robot to do, and who, when and why."""
    main = asked.about.main
    wanted = asked.wanted if asked.wanted != linked(telling.term(main), "cmd") else ""
    head = (
        _head(telling, asked)
        if wanted
        else {"yesno": "", "howmany": "how many times"}.get(asked.ask, asked.ask)
    )
    telling.gap = telling.gap or asked.wanted
    subject = not linked(telling.term(main), "agt")
    if subject:
        told = linked(telling.term(main), "dest")
        who = thing(telling, told, "subject")
        inner = linked(telling.term(main), "cmd")
        denied = "not " if telling.term(inner).negated else ""
        return _spaced(f"{head} {be(who)} {who} told {denied}to {_deed_or_do(telling, inner)}")
    inner = linked(telling.term(main), "cmd")
    denied = "not " if telling.term(inner).negated else ""
    dest = thing(telling, linked(telling.term(main), "dest"))
    rest = f"{dest} {denied}to {_deed_or_do(telling, inner)}"
    agent = linked(telling.term(main), "agt")
    if agent == telling.gap:
        return _spaced(f"{head} may tell {rest}")
    return _spaced(f"{head} did {thing(telling, agent, 'subject')} tell {rest}")


def _deed_or_do(telling: Telling, name: str) -> str:
    return deed(telling, name) if telling.term(name).lex else "do"


def _either(telling: Telling, asked: Question) -> str:
    main, other = (telling.term(name) for name in (asked.about.main, asked.wanted))
    telling.hold_back([main, other])
    one, two = (clause(telling, term, "") for term in (main, other))
    return f"{one.verb} {one.subject} {one.asked} or {two.asked}"


def _spaced(text: str) -> str:
    return " ".join(text.split())


def _taught(telling: Telling, asked: Question, you: str, me: str) -> str:
    """Who said so, why it is so, when that was."""
    main = telling.term(asked.about.main)
    if is_predicate(main) and (main.kind != "act" or linked(main, "agt")):
        said = claim(telling, asked.about)
        if asked.ask == "what":
            return f"what makes {me} think that {said}"
        if asked.ask == "why":
            return f"why {said.verb} {said.subject} {said.asked}"
        return f"who told {me} that {said}"
    what = f"to {deed(telling, main.name)}" if main.lex else "that"
    teaching = next(
        (term for term in telling.terms.values() if linked(term, "cmd") == main.name), None
    )
    if teaching is not None and asked.ask == "yesno":
        return f"did {thing(telling, linked(teaching, 'agt'), 'subject')} teach {me} {what}"
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
        return _spaced(f"{head} {said.verb} {said.subject} {said.asked}")
    return _spaced(f"{head} {said.stated}")


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
        case "where" if telling.term(linked(main, "loc")).kind == "act":
            telling.stated.add(main.name)
            return "where", clause(telling, telling.term(linked(main, "loc")), "")
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
        case "howmany" if not asked.wanted and main.kind == "act":
            return "how often", claim(telling, asked.about)
        case "howmany" if main.name == wanted:
            return f"how many {_bare(telling, wanted, several=True)}", Clause(
                "there", "are", "are", ""
            )
        case "which" if main.name == wanted and linked(main, "loc"):
            telling.stated.add(main.name)
            return "which way", _being(thing(telling, linked(main, "loc"), "subject"))
        case "how" if wanted in telling.terms and linked(telling.term(wanted), "deg"):
            mod = telling.term(linked(telling.term(wanted), "deg"))
            telling.stated.update((mod.name, wanted))
            return f"how {word(mod)}", claim(telling, asked.about)
        case "where" | "when" | "how" | "why" if asked.wanted in ("", main.name):
            return asked.ask, claim(telling, asked.about)
        case ask:
            return _wanted(telling, asked, main, ask)


def _wanted(telling: Telling, asked: Question, main: Term, ask: str) -> tuple[str, Clause]:
    """The thing asked for stands first, and is missing in the clause that follows."""
    wanted = asked.wanted or main.name
    if main.name == wanted:
        return ask, _being(thing(telling, wanted, "subject"))
    if linked(main, "own") and linked(main, "of") == wanted:
        thing_ = thing(telling, linked(main, "own"), "subject")
        return "who", Clause(thing_, "does", "belongs to", "belong to")
    telling.hold_back([main])
    head = _head(telling, asked)
    telling.release([main])
    telling.mention(wanted)
    said = claim(telling, asked.about)
    if said.subject == "" and asked.ask == "howmany" and said.verb == "is":
        return head, Clause("", "are", "are " + said.asked, said.asked)
    return head, said


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
