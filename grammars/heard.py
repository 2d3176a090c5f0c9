"""What of the language the ears are told: of every form, sentences like its examples and those of `heard.lark`.

The whole language would be too much to be told apart. So phrases (things, actions, conditions) are the smaller ones of
`heard.lark`; an example is heard with any of these in the place of its own, and with any word the ears know in the
place of a word of the same category.
"""

from __future__ import annotations

import random
import re
from collections.abc import Iterator, Sequence
from functools import cache
from importlib.resources import files
from typing import Any, Final

from grammars import morphology
from grammars.automaton import Automaton, sample
from grammars.chatter import is_chatter
from grammars.earley import grammar, written_words
from grammars.finite_state import Compiler, Rule, expand
from grammars.parse import parse, understood
from grammars.ranking import Leaf, Tree
from grammars.registry import Form, discover
from grammars.source import digest, grammar_text, kept
from grammars.vocabulary import BORN, Vocabulary, lines

COMPILED: Final = "heard.json"
START: Final = "start"
QUOTE: Final = "quote"
SILENT: Final = frozenset(("_COMMA",))  # terminals that make no sound
# Verbs as people use them: what takes an object, a direction, or neither (words/usage.txt).
SORTS: Final = {
    "VERB": ("HANDLING", "MOVING", "GOING", "RESTING"),
    "VERBING": ("HOLDING", "GOING_ON", "RESTING_ON"),
}
DRAWN: Final = 20  # sentences like an example that must be read as it is
# "The ball is red" is a fact, "a ball is red" a rule, "anything is red" neither: what something is said of is known.
KNOWN: Final = "_known"
BEING: Final = frozenset(("is", "are", "was", "has"))
# "A thing is red" says too much.
KINDS: Final = frozenset(("_nominal", "ako"))
# A sentence may be of another sort with "anybody" in the place of "Mary", or with another condition.
THINGS: Final = frozenset(("np", "_np", "_described", "_definite", "_one", "_det"))
CLAUSES: Final = frozenset(
    ("conds", "clause", "pred", "conclusion", "act", "_nominal", "_plural_nominal")
)


def automaton(vocabulary: Vocabulary = BORN) -> Automaton:
    """What may be said by someone who has taught these words."""
    return expand(skeleton(), spoken_words(vocabulary))


def phrases(vocabulary: Vocabulary, count: int, seed: int) -> list[str]:
    """Sentences that may be heard, drawn at random; the same seed draws the same ones."""
    return sample(automaton(vocabulary), count, random.Random(seed))


@cache
def skeleton() -> Automaton:
    """The language with categories in the place of their words: from `heard.json` if that was made of these very
    files, else compiled now."""
    data = kept(COMPILED, _source(), compile_heard)
    arcs = tuple((source, word, target) for source, word, target in data["arcs"])
    return Automaton(data["start"], frozenset(data["finals"]), arcs)


def compile_heard() -> dict[str, Any]:
    """The skeleton as plain data: ten seconds' work, so its result is kept in `heard.json`."""
    made = Compiler(heard_rules()).compiled(START)
    return {
        "source": _source(),
        "start": made.start,
        "finals": sorted(made.finals),
        "arcs": made.arcs,
    }


def _source() -> str:
    """What the skeleton is made of."""
    return digest("\n".join((grammar_text(), _stand_ins(), *lines("heard"), *written_examples())))


def written_examples() -> Iterator[str]:
    """The examples of all forms, as they are written."""
    for form in discover().values():
        yield from form.examples


def said(sentence: str) -> str:
    """A written sentence as a recogniser would write it."""
    return " ".join(re.findall(r"[\w'-]+", sentence.lower()))


@cache
def heard_rules() -> tuple[Rule, ...]:
    """Every rule of what is heard: those of `heard.lark`, the examples, and of all others the parser's own."""
    rules = [*stand_ins()]
    replaced = frozenset(origin for origin, _ in rules)
    rules += [rule for rule in parser_rules() if rule[0] not in replaced]
    forms = [form for form in discover().values() if not form.expected]
    like = _LikeExamples(rules, replaced - discover().keys())
    rules += [rule for form in forms for rule in like.rules(form)]
    return (*rules, *(("_form", (form.name,)) for form in forms))


def stand_ins() -> Iterator[Rule]:
    """The rules of `heard.lark`, in lark's notation but plain: names, quoted words, bars, nothing else."""
    for found in re.finditer(r"(\w+):((?:(?!\w+:)[\s\S])*)", re.sub(r"//.*", "", _stand_ins())):
        for way in found[2].split("|"):
            yield found[1], tuple(way.split())


def _stand_ins() -> str:
    return files("grammars").joinpath("heard.lark").read_text("utf8")


def parser_rules() -> Iterator[Rule]:
    """The parser's rules; words written out in them stand in quotation marks, which tells them from rules."""
    for rule in grammar().rules:
        if rule.origin.name != "_form":
            yield rule.origin.name, tuple(_written(symbol.name) for symbol in rule.expansion)


class _LikeExamples:
    """Turns examples into rules, as wide as they may be: what is heard must be read as what it is like.

    Args:
        rules: without those of examples.
        shared: names of rules that stand for phrases; the words of an example that such a rule has may be any of it.
    """

    def __init__(self, rules: Sequence[Rule], shared: frozenset[str]) -> None:
        self._compiler, self._words = Compiler(rules), spoken_words(BORN)
        self._widths = (shared, shared - THINGS, shared - THINGS - CLAUSES)

    def rules(self, form: Form) -> Iterator[Rule]:
        """A rule for each example that means the same without its commas."""
        for example in form.examples:
            tree = next(derivations(parse(example).trees[0], form.name))
            ways = [tuple(self._symbols(tree, shared)) for shared in self._widths]
            ways.append(tuple(f'"{word}"' for word in said(example).split()))
            if way := next((way for way in ways if self._is_read(way, form)), ()):
                yield form.name, way

    def _is_read(self, way: tuple[str, ...], form: Form) -> bool:
        """Sentences drawn from it are of that form."""
        language = expand(self._compiler.sequence(way), self._words)
        return bool(language.arcs) and all(
            is_chatter(tuple(sentence.split())) or kind(sentence) == form.kind
            for sentence in sample(language, DRAWN, random.Random(1))
        )

    def _symbols(self, sentence: Tree, shared: frozenset[str]) -> list[str]:
        symbols: list[str] = []
        self._add_all(sentence, symbols, shared, "")
        return symbols

    def _add_all(self, node: Tree, symbols: list[str], shared: frozenset[str], then: str) -> None:
        following = [*(_first_word(child) for child in node.children[1:]), then]
        for child, after in zip(node.children, following, strict=True):
            self._add(child, symbols, shared, after)

    def _add(
        self, node: Tree | Leaf, symbols: list[str], shared: frozenset[str], then: str
    ) -> None:
        """Append a node's symbols; the word then comes after it."""
        if not isinstance(node, Tree):
            if (word := self._terminal(node)) not in SILENT:
                symbols.append(word)
            return
        name = str(node.rule.origin.name)
        if name in THINGS and then in BEING:
            name = KNOWN
        # Any name after any name would be a million pairs.
        second = bool(symbols) and self._is_name(symbols[-1]) and self._is_name(name)
        anything = name in KINDS and then in BEING
        if not (second or anything) and (
            name == QUOTE or (name in shared and self._has(name, node))
        ):
            symbols.append(name)
        else:
            self._add_all(node, symbols, shared, then)

    def _has(self, name: str, phrase: Tree) -> bool:
        words = [self._terminal(leaf) for leaf in phrase.leaves()]
        return self._compiler.compiled(name).accepts(words)

    def _is_name(self, symbol: str) -> bool:
        """A name alone may be said for it."""
        return symbol in self._compiler.rules and self._compiler.compiled(symbol).accepts(
            ["PROPER"]
        )

    def _terminal(self, leaf: Leaf) -> str:
        """The category of a word; the word itself where the ears know other words of that category only."""
        name, token = leaf
        word = token.piece.text
        if more := next((sort for sort in SORTS.get(name, ()) if word in self._words[sort]), ""):
            return more
        if (
            name in written_words()
            or token.piece.kind != "word"
            or word in self._words.get(name, ())
        ):
            return _written(name)
        return f'"{word}"'


def _first_word(node: Tree | Leaf) -> str:
    leaf = next(node.leaves()) if isinstance(node, Tree) else node
    return leaf[1].piece.text


def kind(sentence: str) -> str:
    """The kind of a sentence; empty if it is none."""
    meant = understood(sentence)
    return "" if meant is None else meant.kind


def derivations(tree: Tree, form: str) -> Iterator[Tree]:
    """The derivations of a form in a derivation."""
    if tree.rule.origin.name == form:
        yield tree
    for child in tree.children:
        if isinstance(child, Tree):
            yield from derivations(child, form)


def _written(name: str) -> str:
    """A word that is written out in a rule instead of the name lark gives it; any other symbol as it is."""
    word = written_words().get(name)
    return name if word is None else f'"{word}"'


def spoken_words(vocabulary: Vocabulary) -> dict[str, tuple[str, ...]]:
    """The words for each terminal: those the ears know at birth, and all that were taught."""
    found: dict[str, dict[str, None]] = {}
    for line in lines("heard"):
        category, _, words = line.partition(":")
        entries = map(str.strip, words.split("|")) if "|" in words else words.split()
        found.setdefault(category, {}).update(dict.fromkeys(filter(None, entries)))
    found["NOUNS"] = dict.fromkeys(morphology.plural(word) for word in found["NOUN"])
    for word, readings in vocabulary.taught.items():
        for category in readings:
            found.setdefault(category, {})[word] = None
    return {category: tuple(words) for category, words in found.items()}
