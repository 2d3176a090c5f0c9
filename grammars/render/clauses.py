"""Clauses: predicates of a net as statements, "something is very close and the gripper is empty"."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from grammars.doings import ADDRESSING
from grammars.earley import closed_words
from grammars.mentions import WOMEN
from grammars.morphology import gerund, participle, past, third_person
from grammars.render.complements import COMPLEMENTS, as_quality, kind_denied, not_such
from grammars.render.counting import there_are
from grammars.render.deeds import be, deed
from grammars.render.names import POINTING, PRONOUNS, proper
from grammars.render.telling import SAYING, Telling, is_predicate, linked, word
from grammars.render.things import thing
from grammars.sorts import NOBODY
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
        so = f"{'not ' if term.negated else ''}{adverb}{as_quality(telling, term)} to {deed(telling, name)}"
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
    such = kind_denied(telling, term, name) if denying or telling.term(name).lex else []
    rest = not_such(telling, term, *such) if such else COMPLEMENTS[role](telling, term)
    told = [*mine, *such]
    telling.release(other for other in later if denying and other not in told)
    if role == "hq":  # "red and small"
        also = [other for other in telling.about(name, "hq") if _is_told(telling, term, other)]
        also = [] if term.negated else [other for other in also if not other.negated]
        rest = " and ".join([rest, *(COMPLEMENTS[role](telling, other) for other in also)])
        telling.hold_back(also)
    telling.release(waiting)
    denied = "not " if term.negated and not _is_nothing(subject) else ""
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
    if not agent and (linked(term, "obj") or linked(term, "dest")):
        return _undergone(telling, term)
    third = not telling.several(agent)
    subject = _subject(telling, agent, term.negated) if agent else "something"
    if subject == "they" and third:  # rules want the singular verb: "he likely speaks Portuguese"
        subject = "she" if telling.term(agent).lex & WOMEN else "he"
    if not term.lex and term.ref == "that":
        return Clause(subject, "did", "did that", "do that")
    tense = [mod for mod in telling.about(term.name, "mod") if word(mod) == "past"]
    telling.hold_back(tense)
    done = deed(telling, term.name, told=True)
    third = third and be(subject) == "is"
    if not _is_known(word(term)):  # one that nobody taught is known by its "-ing" only
        rest = (
            f"{'not ' if term.negated and not _is_nothing(subject) else ''}{adverb}{gerund(done)}"
        )
        return Clause(subject, be(subject), f"{be(subject)} {rest}", rest)
    verb = "did" if tense else "does" if third else "do"
    if term.negated and not _is_nothing(subject):
        return Clause(subject, verb, f"{adverb}{verb} not {done}", f"{adverb}not {done}")
    stated = past(done) if tense or "teach" in term.lex else third_person(done) if third else done
    return Clause(subject, verb, adverb + stated, adverb + done)


def _undergone(telling: Telling, term: Term) -> Clause:
    """ "You are pushed", "you are spoken to": by whom is not told."""
    name = linked(term, "obj") or linked(term, "dest")
    subject = _subject(telling, name, term.negated)
    verb = "are" if telling.several(name) else be(subject)
    head, _, particle = word(term).partition(" ")
    ways = [word(way) for way in telling.take(term.name, "dir")]
    to = "to" if head in ADDRESSING else ""
    denied = "not" if term.negated and subject not in NOBODY else ""
    rest = " ".join(filter(None, (denied, participle(head), particle, *ways, to)))
    return Clause(subject, verb, f"{verb} {rest}", rest)


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
        if [word(term) for term in said] == ["person"] and linked(said[0], "ako"):
            telling.hold_back(said)
            telling.mention(name, "person")
            return "nobody"
        return _none_of(thing(telling, name, "subject"))
    return thing(telling, name, "subject")


def _none_of(some: str) -> str:
    """ "Nothing red" for "something red", "no block" for "a block"."""
    first, _, rest = some.partition(" ")
    none = {"something": "nothing", "a": "no", "an": "no"}.get(first, first)
    return f"{none} {rest}".rstrip()


def _is_nothing(subject: str) -> bool:
    return subject.partition(" ")[0] in ("no", *NOBODY)


def naming(telling: Telling, term: Term, told: bool = False) -> Clause:
    """The thing is called so: the main node is no predicate but has a name; told: as news."""
    subject = thing(telling, term.name, "subject") if told else _unnamed(telling, term)
    plural = bool(BORN.readings(word(term)).keys() & {"NOUNS"})
    called = "called " if plural or (told and not term.negated and " " in subject) else ""
    rest = ("not " if term.negated else "") + called + proper(word(term))
    if subject == "it":  # "it is Rover" would be somebody speaking
        subject = "its name"
    if subject == proper(word(term)):
        subject = term.ref if term.ref in POINTING else "something"
    return Clause(subject, be(subject), f"{be(subject)} {rest}", rest)


def _unnamed(telling: Telling, term: Term) -> str:
    """The thing without its name: "the dog" of "is the dog Rex"."""
    if term.ref not in ("", *POINTING) or telling.about(term.name, "ako"):
        telling.terms[term.name] = replace(term, lex=frozenset())
    subject = thing(telling, term.name, "subject")
    telling.terms[term.name] = term
    return subject


def _telling_first(term: Term) -> tuple[bool, bool, bool]:
    """What makes the better clause: what is denied, as no noun phrase takes it; a deed; a kind last."""
    roles = {role for role, _ in term.links}
    return (term.negated or "ako" not in roles, term.negated, term.kind == "act")
