"""How a conclusion was reached: the rules that were used, with whoever taught them, and what they started from."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

from kernel.memory.lesson import Lesson, Rule
from kernel.net.describing import describe
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding
from kernel.net.node import Node


@dataclass(frozen=True, slots=True)
class Inference:
    """One step of reasoning.

    Attributes:
        claim: what was concluded.
        lesson: the rule, or the alias, that was used.
        told: what it started from that is itself no conclusion.
    """

    claim: Graphlet
    lesson: Lesson
    told: tuple[Graphlet, ...] = ()


def inferences(
    nodes: Iterable[Node],
    lessons: Mapping[int, Lesson],
    pattern: Graphlet | None = None,
    news: Container[Node] = (),
) -> tuple[Inference, ...]:
    """The steps that led to those of the nodes that were concluded, in the order of reasoning.

    Args:
        nodes: some of them conclusions.
        lessons: by number.
        pattern: what the nodes were matched with; its words that they have by an alias only are explained too.
        news: see `told_of`.
    """
    found: dict[object, Inference] = {}
    words = pattern.words() if pattern is not None else frozenset()
    for node in nodes:
        _follow(node, lessons, found, news)
        for step in _aliases(node, words, lessons):
            found.setdefault(step.lesson, step)
    return tuple(found.values())


def of_match(
    patterns: Iterable[Graphlet | None],
    binding: Binding,
    lessons: Mapping[int, Lesson],
    news: Container[Node] = (),
) -> tuple[Inference, ...]:
    """The steps behind a match of an operator's patterns."""
    steps: dict[Inference, None] = {}
    for pattern in patterns:
        if pattern is not None:
            nodes = [binding[name] for name in sorted(pattern.mentioned) if name in binding]
            steps |= dict.fromkeys(inferences(nodes, lessons, pattern, news))
    return tuple(steps)


def told_of(node: Node, concluded: bool = False, news: Container[Node] = ()) -> Graphlet:
    """A node described for good: whoever is "me" now is somebody else when it is told, so a name says who it is.

    concluded: with everything that the rules conclude now, for matching; without it as it was told, for telling.
    news: main nodes of told facts: a quality that was told of a thing does not tell which thing it is.
    """
    graphlet = describe(node, concluded=concluded, told_only=not concluded, news=news)
    terms = (
        replace(term, lex=term.lex - {"me"}) if "me" in term.lex and len(term.lex) > 1 else term
        for term in graphlet
    )
    return Graphlet(tuple(terms), graphlet.main)


def _follow(
    node: Node,
    lessons: Mapping[int, Lesson],
    found: dict[object, Inference],
    news: Container[Node],
) -> None:
    lesson = lessons.get(node.rule)
    if not node.rule or node in found or lesson is None:
        return
    premises = sorted(node.reasons, key=lambda premise: premise.name)
    for premise in premises:
        _follow(premise, lessons, found, news)
    condition = lesson.content.condition if isinstance(lesson.content, Rule) else None
    for premise in premises:
        for step in _aliases(premise, condition.words() if condition else frozenset(), lessons):
            found.setdefault(step.lesson, step)
    told = tuple(told_of(p, news=news) for p in premises if not p.rule and says_something(p))
    found[node] = Inference(told_of(node, news=news), lesson, told)


def says_something(node: Node) -> bool:
    """It is a predicate of something: a kind, a quality, a place, an owner, or somebody's act."""
    roles = {role for role, _ in node.links}
    return bool(roles & {"ako", "hq", "loc", "own", "agt"})


def _aliases(
    node: Node, words: frozenset[str], lessons: Mapping[int, Lesson]
) -> Iterator[Inference]:
    """The aliases by which the node has those of the words that nobody told of it."""
    by_alias = words & (set(node.halo_lex) - node.lex)
    if not by_alias:
        return
    known: dict[str, tuple[Lesson, ...]] = dict.fromkeys(node.lex, ())
    aliases = [x for x in lessons.values() if isinstance(x.content, Rule) and x.content.is_alias]
    for _ in range(2):  # the halo goes no deeper
        for lesson in aliases:
            rule = lesson.content
            assert isinstance(rule, Rule)
            said, meant = (min(side.words()) for side in (rule.condition, rule.conclusion))
            if said in known:
                known.setdefault(meant, (*known[said], lesson))
    for word in sorted(by_alias):
        for lesson in known.get(word, ()):
            assert isinstance(lesson.content, Rule)
            yield Inference(lesson.content.conclusion, lesson)
