"""Questions of which a part is missing: the thing asked for stands first, and not where the clause would name it."""

from __future__ import annotations

from typing import Final

from grammars.morphology import past, plural
from grammars.render.clauses import clause
from grammars.render.deeds import be, deed
from grammars.render.names import pronoun
from grammars.render.telling import Telling, is_predicate, linked, word
from grammars.render.things import description, thing
from kernel.memory.meaning import Question
from kernel.net.graphlet import Graphlet

GAPPED: Final = ("did", "doing", "allowed", "extent")
ADVERBS: Final = ("where", "how", "which")


def own_deed(telling: Telling, asked: Question, you: str) -> str:
    """A deed of the robot's of which something is asked: "which cup did you lift", "where are you going"."""
    main = asked.about.main
    if asked.topic == "extent":
        amt = telling.take(main, "amt")
        head = f"how many {plural(word(amt[0]))}" if amt else "how far"
    elif asked.wanted == main:
        return f"what {be(you)} {you} doing" if asked.topic == "doing" else f"what did {you} do"
    else:
        head = (
            question_words(telling, asked)
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
    return spaced(said)


def question_words(telling: Telling, asked: Question) -> str:
    """The question words, with what is said of the thing wanted; it is missing in what follows."""
    owned = next((t for t in telling.terms.values() if linked(t, "of") == asked.wanted), None)
    if owned is not None:
        telling.stated.add(owned.name)
        telling.gap = linked(owned, "own")
        return f"whose {bare(telling, telling.gap, several=False)}"
    telling.gap = asked.wanted
    if asked.ask == "which" and (owns := telling.take(asked.wanted, "own")):
        whose = thing(telling, linked(owns[0], "of"), "possessive")
        return f"which of {whose} {bare(telling, asked.wanted, several=True)}"
    said = telling.about(asked.wanted, "ako", "hq", "loc", "own")
    words = {"howmany": "how many"}.get(asked.ask, asked.ask)
    if asked.ask in ("howmany", "which") or any(linked(t, "ako") for t in said):
        words += " " + bare(telling, asked.wanted, asked.ask == "howmany")
    return words


def ordered(telling: Telling, asked: Question) -> str:
    """What somebody told the robot to do, and who, when and why."""
    main = asked.about.main
    wanted = asked.wanted if asked.wanted != linked(telling.term(main), "cmd") else ""
    head = (
        question_words(telling, asked)
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
        return spaced(f"{head} {be(who)} {who} told {denied}to {_deed_or_do(telling, inner)}")
    inner = linked(telling.term(main), "cmd")
    denied = "not " if telling.term(inner).negated else ""
    dest = thing(telling, linked(telling.term(main), "dest"))
    rest = f"{dest} {denied}to {_deed_or_do(telling, inner)}"
    agent = linked(telling.term(main), "agt")
    if agent == telling.gap:
        return spaced(f"{head} {'may tell' if asked.topic == 'orders' else 'told'} {rest}")
    if asked.topic == "orders":
        return spaced(f"{head} may {thing(telling, agent, 'subject')} tell {rest}")
    return spaced(f"{head} did {thing(telling, agent, 'subject')} tell {rest}")


def occasion(telling: Telling, about: Graphlet) -> str:
    """On what occasion it was: " when Mary came in"; nothing, if on none in particular."""
    inner = {other for term in about for role, other in term.links if role in ("obj", "cmd")}
    told = {about.main, *telling.stated, *inner}
    acts = [term for term in about if term.kind == "act" and term.name not in told]
    said = [term for term in about if is_predicate(term) and term.name not in told]
    if not acts and len(said) == 1:  # "when something got close"
        return f" when {clause(telling, said[0], '')}"
    if len(acts) != 1 or acts[0].negated:
        return ""
    agent = linked(acts[0], "agt")
    telling.stated.add(acts[0].name)
    someone = "me" if word(acts[0]) == "say" else "you"
    who = thing(telling, agent, "subject") if agent else pronoun(telling, someone, "subject")
    return f" when {who} {past(deed(telling, acts[0].name, told=True))}"


def _deed_or_do(telling: Telling, name: str) -> str:
    term = telling.term(name)
    return deed(telling, name) if term.lex else f"do {term.ref}".strip()


def spaced(text: str) -> str:
    """With one space between words, none around."""
    return " ".join(text.split())


def bare(telling: Telling, name: str, several: bool) -> str:
    """The description of a thing without article."""
    before, noun, after = description(telling, name, "thing" if several else "one")
    return " ".join(filter(None, (before, plural(noun) if several else noun, after)))
