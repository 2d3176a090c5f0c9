"""Clauses: predicates of a net as statements, "something is very close and the gripper is empty"."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Final

from grammars.earley import closed_words
from grammars.mentions import WOMEN
from grammars.morphology import article, comparative, gerund, past, plural, third_person
from grammars.render.counting import there_are
from grammars.render.deeds import be, deed
from grammars.render.qualities import degree, quality
from grammars.render.telling import SAYING, Telling, is_predicate, linked, word
from grammars.render.things import PRONOUNS, alike, description, kind, owned, place, proper, thing
from grammars.sorts import NOBODY, classes
from grammars.vocabulary import BORN
from kernel.net.graphlet import Graphlet, Term


@dataclass(frozen=True, slots=True)
class Clause:
    """Subject and predicate, ready to be stated or asked.

    Attributes:
        subject: who or what.
        verb: the verb that changes places with the subject in a question: is, does.
        stated: the predicate behind the subject: "is not close", "has a hat".
        asked: the predicate behind verb and subject: "not close", "have a hat".
    """

    subject: str
    verb: str
    stated: str
    asked: str

    def __str__(self) -> str:
        return f"{self.subject} {self.stated}"


def conditions(telling: Telling, graphlet: Graphlet, hedge: str = "") -> str:
    """Everything a graphlet says, as clauses joined by "and", the main one first.

    Args:
        telling: the state; things mentioned before are referred back to.
        graphlet: its predicates are told, each once.
        hedge: adverb of belief to put into the first clause.
    """
    inner = {other for term in graphlet for role, other in term.links if role in ("obj", "cmd")}
    predicates = [term for term in graphlet if is_predicate(term) and term.name not in inner]
    telling.release(predicates)
    main = graphlet.head
    told = []
    if main is not None and not is_predicate(main):
        told.append(naming(telling, main))
    elif main is not None:
        told.append(clause(telling, main, hedge, predicates))
    while left := [term for term in predicates if term.name not in telling.stated]:
        term = max(left, key=_telling_first)
        told.append(clause(telling, _whose_kind(telling, term, left) or term, "", predicates))
    return " and ".join(map(str, told))


def _whose_kind(telling: Telling, term: Term, left: list[Term]) -> Term | None:
    """What says of what kind a known thing is, where whose it is is told as well: "Rosa is Kim's friend"."""
    name = next((other for role, other in term.links if role in ("own", "hq")), "")
    kinds = [of for of in left if ("ako", name) in of.links and not of.negated]
    owned = any(("own", name) in of.links for of in left)
    known = any(found.main == name for found in telling.described)
    return kinds[0] if kinds and owned and known and not term.negated else None


def clause(telling: Telling, term: Term, hedge: str, others: Iterable[Term] = ()) -> Clause:
    """One predicate as a clause; denied ones among `others` wait for clauses of their own."""
    telling.stated.add(term.name)
    adverb = f"{hedge} " if hedge else ""
    if term.kind == "act":
        return _doing(telling, term, adverb)
    role = next(role for role in SAYING if linked(term, role))
    name = linked(term, role)
    if telling.term(name).kind == "act":  # "it is dangerous to touch the lamp"
        so = f"{'not ' if term.negated else ''}{adverb}{_as_quality(telling, term)} to {deed(telling, name)}"
        return Clause("it", "is", f"is {so}", so)
    if role == "ako" and telling.about(name, "cnt") and not telling.term(name).ref:
        return Clause("there", *there_are(telling, term, name))
    apart = [t for t in others if t.kind != "act" or role != "ako" or t not in telling.new(term)]
    waiting = [t for t in apart if t.negated and t.name not in telling.stated]
    with_kind = role == "ako" and not _picked_out(telling, name)
    later = telling.about(name, "hq", "loc", "own") if with_kind else []
    known = any(found.main == name for found in telling.described)
    denying, mine = term.negated and known, list[Term]()
    if denying:  # "it is not my hat and it is Tom's"
        later = [other for other in telling.about(name, *SAYING) if other in telling.new(term)]
        mine = [other for other in later if role == "ako" and linked(other, "own")][:1]
    elif not with_kind:  # "the man in the red coat is Greg's uncle"
        said = telling.about(name, *(("own", "hq", "loc") if role == "ako" else ("hq",)))
        later = [other for other in said if _is_told(telling, term, other)]
    telling.hold_back((*waiting, *later))
    subject = _subject(telling, name, term.negated)
    telling.release(mine if denying else later)
    such = _kind_denied(telling, term, name) if denying or telling.term(name).lex else []
    rest = _not_such(telling, term, *such) if such else _COMPLEMENTS[role](telling, term)
    told = [*mine, *such]
    telling.release(other for other in later if denying and other not in told)
    if role == "hq":  # "red and small"
        also = [other for other in telling.about(name, "hq") if _is_told(telling, term, other)]
        also = [] if term.negated else [other for other in also if not other.negated]
        rest = " and ".join([rest, *(_COMPLEMENTS[role](telling, other) for other in also)])
        telling.hold_back(also)
    telling.release(waiting)
    denied = "not " if term.negated and subject not in NOBODY else ""
    verb = "are" if telling.several(name) else be(subject)
    return Clause(subject, verb, f"{verb} {denied}{adverb}{rest}", f"{denied}{adverb}{rest}")


def _is_told(telling: Telling, term: Term, other: Term) -> bool:
    """It is told of a known thing together with the other, and does not say which thing is meant."""
    name = linked(term, next(role for role in SAYING if linked(term, role)))
    return any(
        g.main == term.name and other in g.terms and not _describes(g, name) for g in telling.claims
    )


def _describes(graphlet: Graphlet, name: str) -> bool:
    """What the thing is stands in it as well, apart from what is told."""
    said = (term for term in graphlet if term.name != graphlet.main)
    return any(term.name == name or ("ako", name) in term.links for term in said)


def _doing(telling: Telling, term: Term, adverb: str) -> Clause:
    agent = linked(term, "agt")
    third = not telling.several(agent)
    subject = _subject(telling, agent, term.negated) if agent else "something"
    if subject == "they" and third:  # rules want the singular verb: "he likely speaks Portuguese"
        subject = "she" if telling.term(agent).lex & WOMEN else "he"
    tense = [mod for mod in telling.about(term.name, "mod") if word(mod) == "past"]
    telling.hold_back(tense)
    done = deed(telling, term.name, told=True)
    third = third and be(subject) == "is"
    if not _is_known(word(term)):  # one that nobody taught is known by its "-ing" only
        rest = f"{'not ' if term.negated and subject not in NOBODY else ''}{adverb}{gerund(done)}"
        return Clause(subject, be(subject), f"{be(subject)} {rest}", rest)
    verb = "did" if tense else "does" if third else "do"
    if term.negated and subject not in NOBODY:
        return Clause(subject, verb, f"{adverb}{verb} not {done}", f"{adverb}not {done}")
    stated = past(done) if tense or "teach" in term.lex else third_person(done) if third else done
    return Clause(subject, verb, adverb + stated, adverb + done)


def _is_known(verb: str) -> bool:
    head, *_ = verb.split() or [verb]  # of "turn off"
    return BORN.knows(head) or not closed_words().isdisjoint((head, third_person(head)))


def _picked_out(telling: Telling, name: str) -> bool:
    """True where the qualities of a thing say which one is meant, so that they stay with it and off its kind."""
    ref = telling.term(name).ref
    return bool(ref and ref not in PRONOUNS) or bool(telling.about(name, "ako"))


def _subject(telling: Telling, name: str, negated: bool) -> str:
    if negated and name not in telling.mentioned and not telling.term(name).ref:
        said = telling.about(name, *SAYING)
        if not said and not telling.term(name).lex:
            telling.mention(name)
            return "nothing"
        if [word(term) for term in said] == ["person"] and linked(said[0], "ako"):
            telling.hold_back(said)
            telling.mention(name, "person")
            return "nobody"
    return thing(telling, name, "subject")


def wonders(telling: Telling, name: str) -> bool:
    """True where what is looked for is no thing, but what a thing is like and how much so, of what kind it is, where it
    is, or what somebody does."""
    return telling.term(name).kind in ("hq", "ako", "loc", "deg") or bool(_asked_by(telling, name))


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


def naming(telling: Telling, term: Term, told: bool = False) -> Clause:
    """The thing is called so: the main node is no predicate but has a name; told: as news."""
    subject = thing(telling, term.name, "subject") if told else _unnamed(telling, term)
    plural = bool(BORN.readings(word(term)).keys() & {"NOUNS"})
    called = "called " if plural or (told and not term.negated and " " in subject) else ""
    rest = ("not " if term.negated else "") + called + proper(word(term))
    if subject == "it":  # "it is Rover" would be somebody speaking
        subject = "its name"
    if subject == proper(word(term)):
        subject = term.ref if term.ref in ("this", "that") else "something"
    return Clause(subject, be(subject), f"{be(subject)} {rest}", rest)


def _unnamed(telling: Telling, term: Term) -> str:
    """The thing without its name: "the dog" of "is the dog Rex"."""
    if term.ref not in ("", "this", "that") or telling.about(term.name, "ako"):
        telling.terms[term.name] = replace(term, lex=frozenset())
    subject = thing(telling, term.name, "subject")
    telling.terms[term.name] = term
    return subject


def _kind_denied(telling: Telling, term: Term, name: str) -> list[Term]:
    """What a thing is that is denied to be such a one, and whose, where only the quality is denied: no "big dog"."""
    new = telling.new(term) if term.negated and linked(term, "hq") else []
    kinds = [of for of in new if ("ako", name) in of.links and not of.negated]
    return [*kinds, *(own for own in new if ("own", name) in own.links)] if len(kinds) == 1 else []


def _not_such(telling: Telling, term: Term, of_kind: Term, *owns: Term) -> str:
    """The quality denied together with the kind: "not a big dog"."""
    telling.hold_back((of_kind, *owns))
    whose = "".join(thing(telling, linked(own, "of"), "possessive") for own in owns)
    noun = f"{quality(telling, term)} {kind(telling, of_kind)}"
    return _such(telling, linked(term, "hq"), whose, noun)


def _such(telling: Telling, name: str, whose: str, phrase: str, after: str = "") -> str:
    """What a thing, or several, are: "a big dog", "my brother", "twins"."""
    several = telling.several(name)
    noun = plural(phrase) if several else phrase
    own = whose or ("" if several else article(noun))
    return " ".join(filter(None, (own, noun, after)))


def _as_kind(telling: Telling, term: Term) -> str:
    name = linked(term, "ako")
    owners = [linked(own, "of") for own in telling.take(name, "own")]
    whose = thing(telling, owners[0], "possessive") if owners else ""
    more = telling.take(name, "ako")
    most = _is_most(telling, name)
    before, _, after = description(telling, name, "")
    telling.release(more)
    phrase = " ".join(filter(None, (before, kind(telling, term))))
    return _such(telling, name, whose or ("the" if most else ""), phrase, after)


def _is_most(telling: Telling, name: str) -> bool:
    """It is the most so of its kind: "the tallest boy"."""
    qualities = telling.about(name, "hq")
    return any(word(deg) == "most" for hq in qualities for deg in telling.about(hq.name, "deg"))


def _as_quality(telling: Telling, term: Term) -> str:
    other = linked(term, "than")
    if other:
        return f"{degree(telling, term.name)}{comparative(word(term))} than {thing(telling, other)}"
    if linked(term, "as"):
        return alike(telling, term)
    if word(term) in classes()["weekdays"]:
        return proper(word(term))
    regards = [place(telling, about) for about in telling.take(term.name, "loc")]
    return " ".join([quality(telling, term), *regards])


_COMPLEMENTS: Final[dict[str, Callable[[Telling, Term], str]]] = {
    "ako": _as_kind, "hq": _as_quality, "loc": place, "own": owned,
}  # fmt: skip


def _telling_first(term: Term) -> tuple[bool, bool, bool]:
    """What makes the better clause: what is denied, as no noun phrase takes it; a deed; a kind last."""
    roles = {role for role, _ in term.links}
    return (term.negated or "ako" not in roles, term.negated, term.kind == "act")
