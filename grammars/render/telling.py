"""One telling: the net being told, whose voice tells it, and what has been mentioned so far."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from typing import Final, Literal

from kernel.net.graphlet import Graphlet, Term

Voice = Literal["teacher", "robot"]
# How several things are referred to.
GROUPS: Final = ("they", "these", "those")
# Roles of a term that says something of the node it leads to.
SAYING: Final = ("hq", "loc", "own", "ako")


def is_predicate(term: Term) -> bool:
    """True where the term can be told as a clause: it says something of a node, or somebody does it."""
    return term.kind == "act" or any(role in SAYING for role, _ in term.links)


def linked(term: Term, role: str) -> str:
    """Name of the node that the term's role leads to, "" if it has no such role."""
    return next((other for r, other in term.links if r == role), "")


def word(term: Term) -> str:
    """The lexical item to say; the first in the alphabet where there are several."""
    return min(term.lex, default="")


def _alike(one: Term, other: Term) -> bool:
    return (one.kind, one.lex, one.negated) == (other.kind, other.lex, other.negated)


@dataclass
class Telling:
    """Mutable state of one rendering.

    Attributes:
        described: graphlets whose terms may go into noun phrases.
        claims: graphlets that are told as clauses only ("if it is Rick"); their terms are kept out of noun phrases.
        voice: who tells it.
        mentioned: things spoken of, in order of first mention, with the kind they were called by ("" for "something"):
            "it" is the last one, "the block" the last one called a block (grammars/things.py).
        stated: predicates already told, or kept back to be told as a clause.
        gap: the thing that is asked for: it is missing where the clause would name it.
        also: what is said of one thing and of these others: "the ball and the cup".
    """

    described: tuple[Graphlet, ...]
    claims: tuple[Graphlet, ...] = ()
    voice: Voice = "teacher"
    mentioned: dict[str, str] = field(default_factory=dict)
    stated: set[str] = field(default_factory=set)
    terms: dict[str, Term] = field(default_factory=dict)
    gap: str = ""
    also: dict[str, list[str]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        known = {name for graphlet in self.described for name in graphlet.mentioned}
        for graphlet in (*self.described, *self.claims):
            for term in graphlet:
                claimed = graphlet in self.claims and term.name in known
                self._add(replace(term, lex=frozenset(), ref="") if claimed else term)
        for graphlet in self.claims:
            self.stated |= {term.name for term in graphlet if is_predicate(term)}

    def _add(self, term: Term) -> None:
        before = self.terms.get(term.name, Term(term.name))
        self.terms[term.name] = Term(
            term.name,
            before.lex | term.lex,
            term.literal if before.literal is None else before.literal,
            before.ref or term.ref,
            before.negated or term.negated,
            min(before.belief, term.belief),
            tuple(sorted({*before.links, *term.links})),
        )

    def term(self, name: str) -> Term:
        """The term, or a bare one where the net only links to the name."""
        return self.terms.get(name) or Term(name)

    def about(self, name: str, *roles: str) -> list[Term]:
        """Terms not stated yet that link to the name in one of the roles, in order of the roles."""
        return [
            term
            for role in roles
            for term in self.terms.values()
            if (role, name) in term.links and term.name not in self.stated
        ]

    def take(self, name: str, *roles: str) -> list[Term]:
        """As `about`, and they count as stated from now on."""
        taken = self.about(name, *roles)
        self.stated |= {term.name for term in taken}
        return taken

    def is_main(self, name: str) -> bool:
        """Some graphlet is about it, so it is told as a sentence or step of its own."""
        return any(graphlet.main == name for graphlet in (*self.described, *self.claims))

    def count(self, name: str, number: int) -> None:
        """Speak of so many things instead of each of them."""
        self.terms[name] = replace(self.term(name), ref="")
        self._add(Term(f"cnt-{name}", literal=str(number), links=(("cnt", name),)))

    def several(self, name: str) -> bool:
        """It is spoken of as more than one."""
        counted = (t.literal for t in self.terms.values() if ("cnt", name) in t.links)
        group = self.term(name).ref in GROUPS and not self.term(name).lex
        return name in self.also or group or any(number != "1" for number in counted)

    def is_of(self, main: str, name: str) -> bool:
        """Some graphlet about the one has the other as a term."""
        known = (*self.described, *self.claims)
        return any(graphlet.main == main and name in graphlet.names for graphlet in known)

    def hold_back(self, terms: Iterable[Term]) -> None:
        """Keep predicates out of noun phrases until they are released or told."""
        self.stated |= {term.name for term in terms}

    def release(self, terms: Iterable[Term]) -> None:
        """Let predicates be told again."""
        self.stated -= {term.name for term in terms}

    def new(self, main: Term) -> list[Term]:
        """What is told together with it: all terms of the claims that it is the main one of."""
        return [self.term(t.name) for g in self.claims if g.main == main.name for t in g.terms]

    def join(self, about: Graphlet) -> None:
        """Tell in one what is said alike of several things: "are Ann and Bob tall"."""
        main = about.head
        for term in about if main is not None else ():
            if main is None or term is main or not _alike(term, main):
                continue
            one, other = dict(main.links), dict(term.links)
            differing = [role for role in other if one.get(role) != other[role]]
            if (
                len(differing) == 1
                and differing[0] in one
                and not one.keys() - other.keys() - {"agt"}
            ):
                self.also.setdefault(one[differing[0]], []).append(other[differing[0]])
                self.hold_back([term])

    def mention(self, name: str, noun: str = "") -> None:
        """Make it the newest thing spoken of; taking it up again does not make it newer."""
        self.mentioned.setdefault(name, noun)
