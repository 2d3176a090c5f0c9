"""Memory nodes, and the net that holds them: what the mind has in mind, indexed by word.

A node is an object or a predicate alike; its identity is the Python object, its name is for people (Connell 2019,
section 3). Its level says how far from attention it is.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Final

from kernel.net.changes import Changes
from kernel.net.graphlet import Graphlet, Term

WORKING: Final = 0  # in working memory
BAND_1: Final = 1  # halo, concluded from working memory
BAND_2: Final = 2  # halo, concluded from working memory and band 1
REMEMBERED: Final = 3  # told, but about nothing that is in mind now
HYPOTHETICAL: Final = (
    4  # entertained, held by nobody: only who entertains it sees it (kernel.hypothesis)
)

# Roles by which a predicate says more about what it points to: part of a description of it.
MODIFIER_ROLES: Final = frozenset(
    ("dir", "deg", "ako", "hq", "mod", "amt", "cnt", "sub", "own", "loc")
)


class Node:
    """One node of memory.

    Attributes:
        lex: lexical items told.
        halo_lex: further ones that rules conclude: word to belief by level (WORKING where it was promoted).
        links, into: (role, node) from here, and from others to here.
        level: WORKING, BAND_1, BAND_2, REMEMBERED or HYPOTHETICAL; set by Net.place alone.
        reasons: for a conclusion, the nodes it rests on; rule: number of the rule lesson, else 0.
        number: running number, in the order of making; stamp: when it was last mentioned, the same count.
        assumed: nobody told of it: it was taken to exist as the object of an act (FIND).
    """

    __slots__ = (
        "assumed",
        "belief",
        "halo_lex",
        "into",
        "level",
        "lex",
        "links",
        "literal",
        "name",
        "negated",
        "number",
        "reasons",
        "rule",
        "stamp",
    )

    def __init__(self, name: str) -> None:
        self.name = name
        self.lex: set[str] = set()
        self.halo_lex: dict[str, dict[int, float]] = {}
        self.literal: str | None = None
        self.negated = False
        self.belief = 1.0
        self.links: list[tuple[str, Node]] = []
        self.into: list[tuple[str, Node]] = []
        self.level = WORKING
        self.reasons: frozenset[Node] = frozenset()
        self.rule = 0
        self.number = 0
        self.stamp = 0
        self.assumed = False

    def __repr__(self) -> str:
        return f"<{self.name} {' '.join(sorted(self.lex))}>"

    @property
    def kind(self) -> str:
        """The cosmetic part of the name."""
        return self.name.rpartition("-")[0]

    def known_as(self, word: str, depth: int, threshold: float = 0.0) -> bool:
        """Whether the word was told of it, or is concluded within the depth and believed that much."""
        if word in self.lex:
            return True
        concluded = self.halo_lex.get(word)
        return concluded is not None and any(
            level <= depth and belief >= threshold for level, belief in concluded.items()
        )

    def words(self) -> set[str]:
        """Every lexical item, told or concluded. To be read, not changed."""
        return self.lex.union(self.halo_lex) if self.halo_lex else self.lex

    def to(self, role: str) -> Iterator[Node]:
        """Nodes this one points to by the role."""
        return (other for r, other in self.links if r == role)

    def modifiers(self, role: str) -> Iterator[Node]:
        """Predicates that point here by the role, in order of arrival."""
        return (other for r, other in self.into if r == role)


class Net:
    """All nodes there are, by word. Creating, changing and dropping nodes goes through here, and is noted."""

    def __init__(self) -> None:
        self._by_word: dict[str, dict[Node, None]] = {}
        self._nodes: dict[Node, None] = {}
        self._count = 0
        self.changes = Changes()

    def __len__(self) -> int:
        return len(self._nodes)

    def __iter__(self) -> Iterator[Node]:
        return iter(self._nodes)

    def __contains__(self, node: Node) -> bool:
        return node in self._nodes

    def take_changes(self) -> Changes:
        """What changed since the last call."""
        changes, self.changes = self.changes, Changes()
        return changes

    def with_word(self, word: str) -> Collection[Node]:
        """Nodes that carry the word, told or concluded."""
        return self._by_word.get(word, ())

    def has_word(self, word: str) -> bool:
        """Whether any node carries the word."""
        return word in self._by_word

    def present_words(self) -> Collection[str]:
        """Every word some node carries."""
        return self._by_word.keys()

    def new(self, kind: str, *lex: str, **links: Node) -> Node:
        """Make a node with words and links."""
        self._count += 1
        node = Node(f"{kind}-{self._count}")
        node.number = node.stamp = self._count
        self._nodes[node] = None
        self.changes.extended[node] = None
        for word in lex:
            self.name(node, word)
        for role, other in links.items():
            self.link(node, role, other)
        return node

    def from_term(self, term: Term) -> Node:
        """Make the node that a term describes, without its links."""
        node = self.new(term.kind, *sorted(term.lex))
        node.literal, node.negated, node.belief = term.literal, term.negated, term.belief
        return node

    def touch(self, node: Node) -> None:
        """It was mentioned just now."""
        self._count += 1
        node.stamp = self._count

    def place(self, node: Node, level: int) -> None:
        """Set its level."""
        if node.level != level:
            came = node.level == REMEMBERED and level == WORKING
            node.level = level
            (self.changes.extended if came else self.changes.altered)[node] = None

    def believe(self, node: Node, belief: float) -> None:
        """Set its belief."""
        if node.belief != belief:
            node.belief = belief
            self.changes.altered[node] = None

    def name(self, node: Node, word: str) -> None:
        """Add a lexical item for good."""
        node.lex.add(word)
        self._by_word.setdefault(word, {})[node] = None
        known = word in node.halo_lex
        (self.changes.altered if known else self.changes.extended)[node] = None

    def unname(self, node: Node, word: str) -> None:
        """Take a lexical item back."""
        node.lex.discard(word)
        self._word_gone(node, word)

    def overlay(self, node: Node, word: str, level: int, belief: float = 1.0) -> None:
        """Add a concluded lexical item, until it is lifted."""
        concluded = node.halo_lex.get(word)
        if concluded is None:
            node.halo_lex[word] = {level: belief}
            self._by_word.setdefault(word, {})[node] = None
            self.changes.extended[node] = None
        elif concluded.get(level) != belief:
            concluded[level] = belief
            self.changes.altered[node] = None

    def lift(self, node: Node, word: str, level: int) -> None:
        """Take a concluded lexical item of this level back."""
        concluded = node.halo_lex.get(word, {})
        if concluded.pop(level, None) is not None:
            if not concluded:
                del node.halo_lex[word]
            self._word_gone(node, word)

    def link(self, node: Node, role: str, other: Node) -> None:
        """Let node point to other by the role."""
        if (role, other) not in node.links:
            node.links.append((role, other))
            other.into.append((role, node))
            self.changes.extended[node] = None

    def drop(self, node: Node) -> None:
        """Forget a node: it leaves the index, and nothing points to or from it any more."""
        if node not in self._nodes:
            return
        del self._nodes[node]
        for word in node.words():
            self._unindex(node, word)
        for role, other in node.links:
            other.into.remove((role, node))
        for role, other in node.into:
            other.links.remove((role, node))
            self.changes.altered[other] = None
        self.changes.extended.pop(node, None)
        self.changes.altered.pop(node, None)
        self.changes.dropped[node] = None

    def _word_gone(self, node: Node, word: str) -> None:
        if node not in self._nodes:
            return
        self.changes.altered[node] = None
        self.changes.words[word] = None
        if word not in node.lex and word not in node.halo_lex:
            self._unindex(node, word)

    def _unindex(self, node: Node, word: str) -> None:
        there = self._by_word.get(word)
        if there is not None:
            there.pop(node, None)
            if not there:
                del self._by_word[word]


def instantiate(net: Net, graphlet: Graphlet, binding: Mapping[str, Node]) -> dict[str, Node]:
    """Make nodes for what the graphlet names and the binding does not; return the binding with them added.

    Terms whose name is bound already are taken as references and add nothing to their node.
    """
    bound = dict(binding)
    described = {term.name: term for term in graphlet.terms}
    made = []
    for name in _names(graphlet):
        if name not in bound:
            term = described.get(name, Term(name))
            bound[name] = net.from_term(term)
            made.append(term)
    for term in made:
        for role, other in term.links:
            net.link(bound[term.name], role, bound[other])
    return bound


def _names(graphlet: Graphlet) -> list[str]:
    names = [graphlet.main]
    for term in graphlet.terms:
        names += [term.name, *(other for _, other in term.links)]
    return names
