"""Looking things up: what a description refers to, what a question is answered with."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Final

from kernel.action.chain import Directive
from kernel.memory.contraries import definite, ended_by
from kernel.memory.meaning import Question
from kernel.memory.reply import Answer
from kernel.memory.working import WorkingMemory
from kernel.net.describing import describe
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding, matches
from kernel.net.node import REMEMBERED, Node

# The object of an act needs no known place: a thing of that description may be assumed (mind.md, FIND).
ASSUMING_ROLES: Final = frozenset(("obj",))
SPEECH_VERBS: Final = frozenset(("say", "tell", "ask", "greet"))
THINGS: Final = frozenset(("obj", "user", "self"))
PERSONS: Final = frozenset(
    "person man woman boy girl child kid baby human guest visitor stranger friend neighbor owner".split()
)


def known(graphlet: Graphlet, binding: Binding) -> Binding:
    """The part of the binding that the graphlet mentions."""
    return {name: binding[name] for name in graphlet.mentioned if name in binding}


def referents(
    graphlet: Graphlet, memory: WorkingMemory, binding: Binding, threshold: float
) -> Iterator[Binding]:
    """Bindings of the described thing to known things, the most recently mentioned first."""
    memory.refresh()
    found: dict[Node, Binding] = {}
    bare = all(not t.lex and not t.links and t.literal is None for t in graphlet.terms)
    if bare:
        for node in list(memory.net):
            if _is_topic(node, memory) and node.level <= REMEMBERED:
                found[node] = {**binding, graphlet.main: node}
    else:
        start = known(graphlet, binding)
        for match in matches(graphlet, memory.net, REMEMBERED, start, threshold):
            node = match[graphlet.main]
            if node.kind in THINGS:
                found.setdefault(node, {**binding, **match})
    for node in sorted(found, key=lambda n: -n.stamp):
        yield found[node]


def _is_topic(node: Node, memory: WorkingMemory) -> bool:
    """Something a pronoun can stand for: a thing that was described, not the robot, its parts or the speaker."""
    return (
        node.kind == "obj"
        and node not in (memory.me, memory.user)
        and not memory.is_part(node)
        and bool(node.lex or any(role in ("ako", "hq") for role, _ in node.into))
    )


def may_be_somebody(node: Node) -> bool:
    """Whether "somebody" may stand for it: one with a name, a person, or what nothing is known of; no block."""
    kinds = [kind for kind in node.modifiers("ako") if not kind.negated]
    return bool(node.lex) or not kinds or any(kind.words() & PERSONS for kind in kinds)


def stands_for_one(graphlet: Graphlet) -> bool:
    """A bare pronoun: it means the newest thing that fits and, whatever comes of that, no other one."""
    return all(term.ref and not term.lex and not term.links for term in graphlet.terms)


def may_assume(graphlet: Graphlet, later: Sequence[Directive]) -> bool:
    """Whether a thing of this description may be taken to exist: as the object of an act, or someone to speak to.

    A pronoun stands for something known.
    """
    main = graphlet.head
    described = any(t.name != graphlet.main for t in graphlet.terms) or bool(main and main.lex)
    if not described and main is not None and main.ref:
        return False
    for directive in later:
        for term in directive.graphlet.terms if directive.graphlet else ():
            for role, name in term.links:
                if name == graphlet.main:
                    return role in ASSUMING_ROLES or bool(term.lex & SPEECH_VERBS)
    return False


def missing(find: Directive) -> str:
    """Words for what was looked for."""
    if find.graphlet is None:
        return ""
    main = find.graphlet.head
    kinds = sorted(w for t in find.graphlet.terms if t.kind == "ako" for w in t.lex)
    names = sorted(main.lex) if main else []
    return " ".join(names or kinds) or (main.ref if main else "") or "it"


def named(graphlet: Graphlet, memory: WorkingMemory) -> list[Node]:
    """Known things that carry a name used in the graphlet."""
    words = [word for term in graphlet.terms if term.kind in THINGS for word in sorted(term.lex)]
    return [
        node
        for word in words
        for node in memory.net.with_word(word)
        if node.kind in THINGS and node.level <= REMEMBERED
    ]


def is_so(binding: Binding) -> bool:
    """Whether the match rests on what is so, and not on what somebody has merely said."""
    return all(node.kind != "said" for node in binding.values())


def holding(
    about: Graphlet, memory: WorkingMemory, start: Binding | None = None, threshold: float = 0.5
) -> Iterator[Binding]:
    """Bindings under which it is so, as far as anybody remembers.

    That a quality is of a kind ("color") may be known of the word alone: "red is a color".
    """
    net, bound = memory.net, start or {}
    yield from filter(is_so, matches(about, net, REMEMBERED, bound, threshold))
    kinds = [t for t in about.terms if t.links == (("ako", about.main),)]
    if not kinds or not about.main.startswith("hq"):
        return
    rest = Graphlet(tuple(t for t in about.terms if t not in kinds), about.main)
    for binding in filter(is_so, matches(rest, net, REMEMBERED, bound, threshold)):
        called = [n for word in binding[about.main].lex for n in net.with_word(word)]
        told = [kind for thing in called for kind in thing.modifiers("ako")]
        if all(any(t.lex <= kind.words() and is_so({"": kind}) for kind in told) for t in kinds):
            yield binding


def now_so(
    graphlet: Graphlet, memory: WorkingMemory, binding: Binding, threshold: float
) -> Binding | None:
    """How a watched condition holds, None where it does not: that of a loop, of WAIT, ACH and KEEP.

    A denied one ("nothing is close", "the gripper is not closed") holds where it is known, and where its contrary is
    not (ours: the senses post what is so, never what is not).
    """
    memory.refresh()
    bound = known(graphlet, memory.persons(graphlet, binding))

    def found(pattern: Graphlet) -> Binding | None:
        every = matches(pattern, memory.net, REMEMBERED, bound, threshold)
        return next(filter(is_so, every), None)

    if (so := found(graphlet)) is not None:
        return so
    denied = graphlet.head is not None and graphlet.head.negated
    return {} if denied and found(graphlet.denied()) is None else None


Notice = Callable[[Iterable[Graphlet], Binding], None]  # told of a match that something rests on


def unnoticed(patterns: Iterable[Graphlet], binding: Binding) -> None:
    """Nobody minds what an answer rests on."""


def answer(
    question: Question,
    memory: WorkingMemory,
    use: Notice = unnoticed,
) -> Answer:
    """What memory has to say to a question about what is so. use: told of every match that the answer rests on."""
    about = question.about
    if question.topic == "identity":
        names = memory.speaker_names
        return Answer(
            question, "found" if names else "unknown", (describe(memory.user),) * bool(names)
        )
    if question.ask == "yesno":
        wrong = ended_by(about, definite(about))
        for pattern, positive in ((about, True), *((w, False) for w in wrong)):
            for binding in filter(is_so, matches(pattern, memory.net, REMEMBERED)):
                memory.mention(binding[about.main])
                use((pattern,), binding)
                return Answer(
                    question, "yes" if positive else "no", (describe(binding[about.main]),)
                )
        return Answer(question, "unknown")
    found = []
    for binding in list(holding(about, memory)):
        wanted = binding.get(question.wanted or about.main)
        if wanted is not None and wanted not in found:
            use((about,), binding)
            found.append(wanted)
    described = tuple(describe(node) for node in found)
    return Answer(question, "found" if found else "unknown", described)
