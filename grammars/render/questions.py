"""Questions, as they are asked and as they are taken up in an answer."""

from __future__ import annotations

from typing import Final

from grammars.morphology import comparative
from grammars.render.clauses import Clause, clause, conditions, naming
from grammars.render.deeds import be, deed
from grammars.render.missing import (
    ADVERBS,
    GAPPED,
    bare,
    occasion,
    ordered,
    own_deed,
    question_words,
    spaced,
)
from grammars.render.procedures import procedure
from grammars.render.telling import SAYING, Telling, Voice, is_predicate, linked, word
from grammars.render.things import thing
from grammars.sorts import classes
from kernel.action.chain import Chain
from kernel.memory.meaning import Question
from kernel.net.graphlet import Graphlet, Term

OCCASIONAL: Final = ("did", "why", "ordered")  # what was done on some occasion
# What is asked as "what color is it", and not as "what is its name".
_SEEN: Final = ("day", "color", "size", "shape", "kind", "make", "brand")


def question(asked: Question, voice: Voice) -> str:
    """The question itself: "is Mary a person", "where is the red block"."""
    telling = Telling((asked.about,), (), voice)
    if asked.topic != "either":
        telling.join(asked.about)
    text = _question(telling, asked, voice)
    return text + (occasion(telling, asked.about) if asked.topic in OCCASIONAL else "")


def _question(telling: Telling, asked: Question, voice: Voice) -> str:
    main = asked.about.main
    you, me = ("I", "me") if voice == "robot" else ("you", "you")
    named = asked.topic != "allowed" or telling.term(main).lex
    if (
        named
        and asked.topic in GAPPED
        and asked.ask != "yesno"
        and (asked.wanted or asked.ask in ADVERBS)
    ):
        return own_deed(telling, asked, you)
    match asked.topic:
        case "ordered" | "orders":
            return ordered(telling, asked)
        case "occasion":
            return f"when do {you} {deed(telling, main)}"
        case "lasting":
            return f"how long did {you} {deed(telling, main)}"
        case "takes":
            return f"how long does it take to {deed(telling, main)}"
        case "why" if asked.ask == "what" and telling.term(main).negated:
            return f"what stopped {you} from {deed(telling, main, 'gerund')}"
        case "why" if asked.ask == "what" and telling.term(main).lex:
            return f"what made {you} {deed(telling, main)}"
        case "either":
            return _either(telling, asked)
        case "taught":
            return _taught(telling, asked, you, me)
        case "would":
            return _would(telling, asked, you)
        case "allowed" | "happens" if asked.chain is not None:
            return _then(telling, asked, asked.chain, you)
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
        case "know_how" if asked.ask == "what":
            nth = word(telling.take(asked.wanted, "hq")[0])
            return f"what is the {nth} step of the {deed(telling, main)}"
        case "know_how" if asked.ask == "howmany":
            return f"how many steps does it take to {deed(telling, main)}"
        case "know_how" if not telling.term(main).lex:
            return f"how did {you} do that"
        case "know_how":
            return f"how do {you} {deed(telling, main)}"
        case "means":
            return f"what does {min(telling.term(main).lex, default='that')} mean"
        case "opposite":
            return f"what is the opposite of {min(telling.term(main).lex)}"
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


def _either(telling: Telling, asked: Question) -> str:
    main, other = (telling.term(name) for name in (asked.about.main, asked.wanted))
    telling.hold_back([main, other])
    one, two = (clause(telling, term, "") for term in (main, other))
    of = ({o for r, o in term.links if r in ("agt", *SAYING)} for term in (main, other))
    again = "" if set.intersection(*of) else f"{two.verb} {two.subject} "
    return f"{one.verb} {one.subject} {one.asked} or {again}{two.asked}"


def _taught(telling: Telling, asked: Question, you: str, me: str) -> str:
    """Who said so, why it is so, when that was."""
    main = telling.term(asked.about.main)
    if is_predicate(main) and (main.kind != "act" or linked(main, "agt")):
        said = claim(telling, asked.about)
        if asked.ask == "what":
            return f"what makes {me} think that {said}"
        if asked.ask == "when":
            return f"when did {you} learn that {said}"
        if asked.ask == "why":
            return f"why {said.verb} {said.subject} {said.asked}"
        return f"who told {me} that {said}"
    if main.kind == "obj":
        told = "when did {you} learn" if asked.ask == "when" else "who told {me}"
        return f"{told.format(you=you, me=me)} about {thing(telling, main.name)}"
    what = f"to {deed(telling, main.name)}" if main.lex else "that"
    teaching = next(
        (term for term in telling.terms.values() if linked(term, "cmd") == main.name), None
    )
    if teaching is not None and asked.ask == "yesno":
        return f"did {thing(telling, linked(teaching, 'agt'), 'subject')} teach {me} {what}"
    if teaching is not None and asked.ask == "when":
        return f"when did {thing(telling, linked(teaching, 'agt'), 'subject')} teach {me} {what}"
    if asked.ask == "when":
        return f"when did {you} learn {what}"
    return f"who told {me} not {what}" if main.negated else f"who taught {me} {what}"


def _would(telling: Telling, asked: Question, you: str) -> str:
    """What is supposed, said or so."""
    if asked.chain is None:
        return f"what would {you} do if {conditions(telling, asked.about)}"
    steps = procedure(Telling(tuple(asked.chain.graphlets()), (), telling.voice), asked.chain)
    return f"what would {you} do if {'you' if you == 'I' else 'I'} said {steps}"


def _then(telling: Telling, asked: Question, chain: Chain, you: str) -> str:
    """A deed on some occasion: "do you dance when I sing", "are you allowed to touch it when nobody is here"."""
    done = next(chain.graphlets())
    about = Graphlet(tuple(t for t in asked.about if t not in done.terms), asked.about.main)
    telling = Telling((done,), (about,), telling.voice)
    head = f"{be(you)} {you} allowed to" if asked.topic == "allowed" else f"do {you}"
    return f"{head} {deed(telling, done.main)} when {conditions(telling, about)}"


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
        return spaced(f"{head} {said.verb} {said.subject} {said.asked}")
    return spaced(f"{head} {said.stated}")


def indirect(asked: Question, voice: Voice) -> str:
    """What is not known: "whether Mary is a person", "where the red block is"."""
    head, said = _asked(Telling((asked.about,), (), voice), asked)
    return f"{'whether' if asked.ask == 'yesno' else head} {said}".replace("  ", " ").strip()


def _asked(telling: Telling, asked: Question) -> tuple[str, Clause]:
    """The question words, and the clause that follows; it has no subject where the question words are that."""
    main = telling.term(asked.about.main)
    wanted = asked.wanted or main.name
    match asked.ask:
        case "yesno" if not is_predicate(main) and not main.lex:
            there = thing(telling, main.name)
            return "", Clause("there", be(there), f"{be(there)} {there}", there)
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
            day = linked(main, "hq")
            kinds = {word(term) for term in telling.about(day, "ako")}
            if kinds & classes()["occasions"] or telling.term(day).lex & classes()["days"]:
                attribute = "day"
            if attribute and attribute not in _SEEN:
                whose = thing(telling, linked(main, "hq"), "possessive")
                return "what", _being(f"{whose} {attribute}")
            return f"what {attribute}", _being(thing(telling, linked(main, "hq"), "subject"))
        case "how" if linked(main, "hq"):
            telling.stated.update((main.name, wanted))
            return f"how {word(main)}", _being(thing(telling, linked(main, "hq"), "subject"))
        case "howmany" if not asked.wanted and main.kind == "act":
            return "how often", claim(telling, asked.about)
        case "howmany" if main.name == wanted:
            return f"how many {bare(telling, wanted, several=True)}", Clause(
                "there", "are", "are", ""
            )
        case "which" if main.name == wanted and linked(main, "loc"):
            telling.stated.add(main.name)
            return "which way", _being(thing(telling, linked(main, "loc"), "subject"))
        case "how" if wanted in telling.terms and linked(telling.term(wanted), "deg"):
            mod = telling.term(linked(telling.term(wanted), "deg"))
            telling.stated.update((mod.name, wanted))
            return f"how {word(mod)}", claim(telling, asked.about)
        case "which" if not asked.wanted:
            return "which way", claim(telling, asked.about)
        case "where" | "when" | "how" | "why" if asked.wanted in ("", main.name):
            return asked.ask, claim(telling, asked.about)
        case ask:
            return _wanted(telling, asked, main, ask)


def _wanted(telling: Telling, asked: Question, main: Term, ask: str) -> tuple[str, Clause]:
    """The thing asked for stands first, and is missing in the clause that follows."""
    wanted = asked.wanted or main.name
    named = telling.term(wanted).lex or telling.term(wanted).ref
    if linked(main, "than") and named:  # "which is heavier, the box or the ball"
        telling.stated.add(main.name)
        one, other = thing(telling, wanted, "subject"), thing(telling, linked(main, "than"))
        return f"{ask} is {comparative(word(main))},", Clause("", "", f"{one} or {other}", "")
    if main.name == wanted:
        return ask, _being(thing(telling, wanted, "subject"))
    if linked(main, "own") and linked(main, "of") == wanted:
        if telling.term(linked(main, "own")).lex:  # "whose brother is Freddy"
            called = " ".join(word(kind) for kind in telling.take(linked(main, "own"), "ako"))
            return f"whose {called}", _being(thing(telling, linked(main, "own"), "subject"))
        telling.hold_back([main])
        thing_ = thing(telling, linked(main, "own"), "subject")
        return "who", Clause(thing_, "does", "belongs to", "belong to")
    telling.hold_back([main])
    head = question_words(telling, asked)
    telling.release([main])
    telling.mention(wanted)
    said = claim(telling, asked.about)
    if said.subject == "" and asked.ask == "howmany" and said.verb == "is":
        return head, Clause("", "are", "are " + said.asked, said.asked)
    return head, said


def _being(subject: str) -> Clause:
    return Clause(subject, be(subject), be(subject), "")


def claim(telling: Telling, about: Graphlet) -> Clause:
    """What a graphlet says, as one clause."""
    main = telling.term(about.main)
    if not is_predicate(main):
        return naming(telling, main)
    return clause(telling, main, "")
