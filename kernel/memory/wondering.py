"""What is to be found out: what a thing is like, of what kind it is, where it is, and whether something is so."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final

from kernel.action.chain import Directive
from kernel.memory.meaning import Question
from kernel.memory.recall import THINGS, holding, known, referents
from kernel.memory.working import WorkingMemory
from kernel.net.graphlet import Graphlet, Term
from kernel.net.match import Binding
from kernel.net.node import Node

SEEKING_VERBS: Final = frozenset(("find", "look for", "search for"))


def is_thing(graphlet: Graphlet) -> bool:
    """Whether a thing is described; else what is looked for is a quality, kind or place: "what color it is"."""
    main = graphlet.head
    return main is None or main.kind in THINGS


def values(
    graphlet: Graphlet, memory: WorkingMemory, binding: Binding, threshold: float
) -> Iterator[Binding]:
    """Bindings of a wanted quality, kind or place to what is known to be so, the newest first."""
    memory.refresh()
    start = known(graphlet, memory.persons(graphlet, binding))
    found: dict[Node, Binding] = {}
    for match in holding(graphlet, memory, start, threshold):
        if match[graphlet.main].lex:
            found.setdefault(match[graphlet.main], {**binding, **match})
    for node in sorted(found, key=lambda n: -n.stamp):
        yield found[node]


def sought(graphlet: Graphlet, later: Sequence[Directive]) -> bool:
    """Whether it is named only to be looked for next ("find the ball"): then that act follows the advice on it."""
    for directive in later:
        for term in directive.graphlet.terms if directive.graphlet else ():
            if ("obj", graphlet.main) in term.links:
                return directive.tag == "DO" and bool(term.lex & SEEKING_VERBS)
    return False


def spelled_out(graphlet: Graphlet, binding: Binding) -> Graphlet:
    """The graphlet with names and kinds of the known things it is about, for telling it."""
    terms = {term.name: term for term in graphlet.terms}
    for name in sorted(graphlet.mentioned & binding.keys()):
        thing = binding[name]
        if thing.kind not in THINGS:
            continue
        kinds = [kind for kind in thing.modifiers("ako") if not kind.negated]
        if thing.lex or kinds:
            ref = "" if thing.lex else "the"
            terms[name] = Term(name, frozenset(thing.lex), ref=ref)
        for at, kind in enumerate(kinds[:1]):
            said = f"ako-{1000 * (len(terms) + 1) + at}"
            terms[said] = Term(said, frozenset(kind.lex), links=(("ako", name),))
    return Graphlet(tuple(terms.values()), graphlet.main)


def asked_for(question: Question, memory: WorkingMemory) -> tuple[Graphlet, Binding]:
    """What a question wants found out, as FIND and CHK operators are about it, with the things it is about.

    "What is it" wants its kind; "which block is heavy" wants the block.
    """
    about, wanted = question.about, question.wanted
    binding = {}
    for term in about.terms:
        if term.kind == "obj" and term.name != wanted and (term.lex or term.ref == "the"):
            said = [t for t in about.terms if ("ako", term.name) in t.links]
            find = Graphlet((term, *said), term.name)
            for match in referents(find, memory, {}, 0.0):
                binding[term.name] = match[term.name]
                break
    if wanted == about.main and is_thing(about):
        kind = Term("ako-999", links=(("ako", wanted),))
        return Graphlet((kind, *about.terms), kind.name), binding
    return Graphlet(about.terms, wanted or about.main), binding
