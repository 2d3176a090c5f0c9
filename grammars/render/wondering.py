"""What is to be found out: "what color it is", "how heavy it is", "what he speaks", "where it is"."""

from __future__ import annotations

from grammars.morphology import third_person
from grammars.render.deeds import be
from grammars.render.telling import Telling, linked, word
from grammars.render.things import kind, thing
from kernel.net.graphlet import Term


def wonders(telling: Telling, name: str) -> bool:
    """True where what is looked for is no thing, but what a thing is like and how much so, of what kind it is, where it
    is, or what somebody does."""
    return telling.term(name).kind in ("hq", "ako", "loc", "deg") or bool(_asked_by(telling, name))


def wonder(telling: Telling, name: str) -> str:
    """What is to be found out: "what color it is", "how heavy it is", "what he speaks", "where it is"."""
    term = telling.term(name)
    if asked_by := _asked_by(telling, name):
        of_kind, act = asked_by
        telling.hold_back(asked_by)
        telling.mention(name, word(of_kind))
        subject = thing(telling, linked(act, "agt"), "subject")
        verb = third_person(word(act)) if be(subject) == "is" else word(act)
        return f"what {kind(telling, of_kind)} {subject} {verb}"
    telling.stated.add(name)
    if term.kind == "deg":
        quality = telling.term(linked(term, "deg"))
        telling.stated.add(quality.name)
        subject = thing(telling, linked(quality, "hq"), "subject")
        return f"how {word(quality)} {subject} {be(subject)}"
    attribute = [word(kind) for kind in telling.take(name, "ako")]
    subject = thing(telling, linked(term, term.kind), "subject")
    asked = "where" if term.kind == "loc" else " ".join(["what", *attribute])
    return f"{asked} {subject} {be(subject)}"


def _asked_by(telling: Telling, name: str) -> list[Term]:
    """The kind of a thing and what somebody does with it, where no more is said of it."""
    term = telling.term(name)
    said = telling.about(name, "ako", "hq", "loc", "own")
    acts = [
        act
        for act in telling.about(name, "obj")
        if linked(act, "agt") and telling.is_of(name, act.name)
    ]
    whole = not term.lex and not term.ref and len(said) == len(acts) == 1 and linked(said[0], "ako")
    robot = any(telling.term(linked(act, "agt")).lex == {"you"} for act in acts)
    return [*said, *acts] if whole and not robot else []
