"""The best derivations out of all of them, and a derivation as an association list.

A derivation costs the sum of its rules' costs (in the grammar files) and of its words' (`source.terminal_cost`): few
guessed words, long known phrases, near attachments. Equal costs keep the order of the grammar files.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Final

from grammars.alist import AList
from grammars.lattice import Token
from grammars.source import terminal_cost
from grammars.vocabulary import BORN

MOST_READINGS: Final = 6
# Words that build sentences: a quote without quotation marks neither starts with one nor holds several.
BUILDERS: Final = frozenset(
    "before after instead means unless until when whenever if then while than because".split()
)
# "Say that again", "say it with flowers".
SAID: Final = ("it", "that", "this")
AGAIN: Final = frozenset("again once twice and to with for like as in out while when".split())
# Nobody's quote ends with one of these: the sentence was cut off, or what follows is no new action but the rest of it.
DANGLING: Final = frozenset(
    "the a an my your and or of if say tell then when whenever unless until than because".split()
)
SPEECHES: Final = ("speech", "speaking")

Leaf = tuple[str, Token]
Charge = tuple[int, str]  # what it cost, and what for: a rule, or a word taken for something
Ranked = list[tuple[int, tuple[Any, ...]]]


@dataclass(frozen=True, slots=True)
class Tree:
    """A derivation: a rule of the grammar with its children in order."""

    rule: Any
    children: tuple[Tree | Leaf, ...]

    def leaves(self) -> Iterator[Leaf]:
        """Words in order, each with the terminal it was taken for."""
        for child in self.children:
            yield from child.leaves() if isinstance(child, Tree) else (child,)

    def quotes(self) -> Iterator[list[Leaf]]:
        """Words of each quote that has no quotation marks."""
        if self.rule.origin.name == "quote":
            words = list(self.leaves())
            if words[0][0] == "ANYWORD":
                yield words
            return
        for child in self.children:
            if isinstance(child, Tree):
                yield from child.quotes()

    def speeches(self) -> Iterator[tuple[list[str], list[Leaf]]]:
        """Each quote without quotation marks that somebody is to speak: the words before it, from the verb on, and its
        own."""
        if self.rule.origin.name in SPEECHES:
            before: list[str] = []
            for child in self.children:
                if isinstance(child, Tree) and (words := next(child.quotes(), None)):
                    yield before, words
                said = child.leaves() if isinstance(child, Tree) else (child,)
                before += [token.piece.text for _, token in said]
            return
        for child in self.children:
            if isinstance(child, Tree):
                yield from child.speeches()

    def charges(self, cost: Mapping[int, int]) -> Iterator[Charge]:
        """What makes this derivation dear or cheap; their sum is its rank."""
        if own := cost[id(self.rule)]:
            yield own, str(self.rule.alias or self.rule.origin.name)
        for child in self.children:
            if isinstance(child, Tree):
                yield from child.charges(cost)
            elif own := terminal_cost(child[0]):
                yield own, f"{child[1].piece.text} as {child[0]}"

    def guessed(self) -> tuple[str, ...]:
        """Unknown words used other than in quotes."""
        words = (leaf[1].piece.text for leaf in self.leaves() if _is_guess(leaf))
        return tuple(dict.fromkeys(words))


def _is_guess(leaf: Leaf) -> bool:
    terminal, token = leaf
    return terminal != "ANYWORD" and not token.known


@dataclass(slots=True)
class Ranking:
    """Ranks the derivations in a shared packed parse forest (lark's).

    Attributes:
        cost: of each rule, by its id.
        done: nodes ranked already.
    """

    cost: Mapping[int, int]
    done: dict[int, Ranked]

    def best(self, root: Any) -> list[Tree]:
        """The cheapest derivations, cheapest first."""
        return [trees[0] for _, trees in self._rank(root)]

    def _rank(self, node: Any) -> Ranked:
        if id(node) in self.done:
            return self.done[id(node)]
        self.done[id(node)] = []  # a cycle derives nothing
        found: Ranked = []
        for packed in node.children:
            rule = packed.rule
            ptr = node.s[1] if node.is_intermediate else len(rule.expansion)
            lefts: Ranked = [(0, ())] if packed.left is None else self._rank(packed.left)
            rights = self._right(packed.right, rule, ptr)
            extra = 0 if node.is_intermediate else self.cost[id(rule)]
            for left_cost, left in lefts:
                for right_cost, right in rights:
                    children = (*left, *right)
                    made = children if node.is_intermediate else (Tree(rule, children),)
                    found.append((left_cost + right_cost + extra, made))
        found.sort(key=lambda ranked: ranked[0])
        self.done[id(node)] = found[:MOST_READINGS]
        return self.done[id(node)]

    def _right(self, node: Any, rule: Any, ptr: int) -> Ranked:
        """Ranking of the last symbol read: a word, or a rule's derivations."""
        if hasattr(node, "token"):
            terminal = rule.expansion[ptr - 1].name
            return [(terminal_cost(terminal), ((terminal, node.token),))]
        return self._rank(node)


def to_alist(tree: Tree, text: str) -> AList:
    """Walk the tree and retain selected nodes: rules that start with "_" leave no bracket, words written out in a rule
    leave no slot unless the rule is marked "!"."""
    (sentence,) = _parts(tree, text)
    return sentence


def _parts(tree: Tree, text: str) -> list[AList]:
    name = str(tree.rule.alias or tree.rule.origin.name)
    if name == "quote":
        return [AList("quote", value=_quote(tree, text))]
    slots: list[AList] = []
    only_words = True
    for symbol, child in zip(tree.rule.expansion, tree.children, strict=True):
        if isinstance(child, Tree):
            inner = _parts(child, text)
            only_words = only_words and not inner
            slots += inner
        elif not symbol.filter_out:
            terminal, token = child
            slots.append(AList(terminal.lower(), value=token.readings[terminal]))
    if name.startswith("_") or (len(slots) == 1 and slots[0].name == name):
        return slots
    if only_words and slots:
        return [AList(name, value=" ".join(slot.value or "" for slot in slots))]
    return [AList(name, tuple(slots))]


def _quote(tree: Tree, text: str) -> str:
    """The words of a quote, as they stand in the text; nothing where they are no quote but scrambled words."""
    pieces = [token.piece for _, token in tree.leaves()]
    if pieces[0].kind == "quote":
        return pieces[0].text
    words = [piece.text for piece in pieces]
    if pieces[0].begin == pieces[0].end:  # "tell Janey's brother"
        return ""
    if (words[0] in BUILDERS and len(words) > 2) or sum(word in BUILDERS for word in words) > 1:
        return ""
    if len(words) > 1 and (words[-1] in DANGLING or _is_said_again(*words[:2])):
        return ""
    return re.sub(r"\s+", " ", text[pieces[0].begin : pieces[-1].end]).strip()


def _is_said_again(first: str, second: str) -> bool:
    """ "Say that again for the people at home", "say it with flowers": not what is to be said, but what was."""
    beside = BORN.readings(second).keys() & {"ADV", "ADJER", "PREP", "DIR"}
    return first in SAID and (second in AGAIN or bool(beside))
