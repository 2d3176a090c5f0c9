"""Graphlets: immutable pieces of semantic net, used as descriptions, patterns and instructions.

A graphlet's terms name each other by text names ("act-1"). Names are variables: graphlets of one lesson that use the
same name mean the same thing, and a link may lead to a name that another graphlet of the lesson describes. The part
before the dash is cosmetic (act, obj, hq, ako, dir ...), as in the paper.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace


@dataclass(frozen=True, slots=True)
class Term:
    """One node of a graphlet.

    Attributes:
        name: variable name, kind and number, "act-1".
        lex: lexical items, lower-case lemmas (names of persons keep no capitals either); empty matches any node.
        literal: quoted speech or a number in digits (written -str-), else None.
        ref: how the speaker referred to it: "", "the", "it", "that", "every" ... A hint for FIND and for reading
            back; never matched.
        negated: the predicate is denied ("not heavy").
        belief: 0 to 1, how sure; matters on facts and conclusions only.
        links: (role, name of the other node), sorted; roles are the paper's (agt obj dest dir deg
            ako hq arg cmd) and ours (docs/net.md).
    """

    name: str
    lex: frozenset[str] = frozenset()
    literal: str | None = None
    ref: str = ""
    negated: bool = False
    belief: float = 1.0
    links: tuple[tuple[str, str], ...] = ()

    @property
    def kind(self) -> str:
        """The cosmetic part of the name: "act" of "act-1"."""
        return self.name.rpartition("-")[0]


@dataclass(frozen=True, slots=True)
class Graphlet:
    """Terms and which of them is the main one; main may be a name that another graphlet of the lesson describes."""

    terms: tuple[Term, ...]
    main: str

    def __iter__(self) -> Iterator[Term]:
        return iter(self.terms)

    def term(self, name: str) -> Term:
        """The term of that name.

        Raises:
            KeyError: this graphlet does not describe it.
        """
        for term in self.terms:
            if term.name == name:
                return term
        raise KeyError(name)

    @property
    def head(self) -> Term | None:
        """Its main term, where it is described here."""
        return next((term for term in self.terms if term.name == self.main), None)

    @property
    def names(self) -> frozenset[str]:
        """Names described here, without those only linked to."""
        return frozenset(term.name for term in self.terms)

    @property
    def mentioned(self) -> frozenset[str]:
        """Names described or linked to, and the main one."""
        linked = {other for term in self.terms for _, other in term.links}
        return self.names | linked | {self.main}

    def words(self) -> frozenset[str]:
        """Every lexical item in it."""
        return frozenset(word for term in self.terms for word in term.lex)

    def denied(self) -> Graphlet:
        """The same with the polarity of the main term turned round."""
        terms = tuple(
            replace(t, negated=not t.negated) if t.name == self.main else t for t in self.terms
        )
        return Graphlet(terms, self.main)

    def renamed(self, names: dict[str, str]) -> Graphlet:
        """The same graphlet with names replaced; names that are not in the table stay."""
        terms = tuple(
            replace(
                term,
                name=names.get(term.name, term.name),
                links=tuple(sorted((role, names.get(other, other)) for role, other in term.links)),
            )
            for term in self.terms
        )
        return Graphlet(terms, names.get(self.main, self.main))


@dataclass(slots=True)
class Sketch:
    """A net being drawn: hands out names, collects terms, cuts graphlets out of them.

    >>> sketch = Sketch()
    >>> act = sketch.add("act", "drive")
    >>> way = sketch.add("dir", "forward", dir=act)
    >>> sketch.graphlet(act, way).words() == {"drive", "forward"}
    True
    """

    terms: dict[str, Term] = field(default_factory=dict)
    count: int = 0

    def add(
        self,
        kind: str,
        *lex: str,
        literal: str | None = None,
        ref: str = "",
        negated: bool = False,
        belief: float = 1.0,
        **links: str | Iterable[str],
    ) -> str:
        """Add a term and return its name; links are role=name or role=names."""
        self.count += 1
        name = f"{kind}-{self.count}"
        pairs = [
            (role.rstrip("_"), other)
            for role, others in links.items()
            for other in ([others] if isinstance(others, str) else others)
        ]
        self.terms[name] = Term(
            name, frozenset(lex), literal, ref, negated, belief, tuple(sorted(pairs))
        )
        return name

    def change(self, name: str, **changes: object) -> None:
        """Replace fields of a term, as dataclasses.replace does."""
        self.terms[name] = replace(self.terms[name], **changes)  # type: ignore[arg-type]

    def link(self, name: str, role: str, other: str) -> None:
        """Add a link to a term that exists."""
        term = self.terms[name]
        self.terms[name] = replace(term, links=tuple(sorted({*term.links, (role, other)})))

    def graphlet(self, main: str, *more: str) -> Graphlet:
        """Cut out the terms named; repeated names count once."""
        wanted = dict.fromkeys((main, *more))
        return Graphlet(tuple(self.terms[name] for name in wanted if name in self.terms), main)
