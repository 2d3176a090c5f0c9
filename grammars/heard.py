"""What of the language the ears are told: of every form, sentences like its examples and those of `heard.lark`.

The whole language would be too much to be told apart. So phrases (things, actions, conditions) are the smaller ones of
`heard.lark`; an example is heard with any of these in the place of its own, and with any word the ears know in the place
of a word of the same category.

An example is besides what people say, word for word: a recogniser that weighs what is likely is told so.
"""

from __future__ import annotations

import json
import random
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import cache
from hashlib import sha256
from importlib.resources import files
from typing import Any, Final

from grammars import morphology
from grammars.automaton import Automaton, sample
from grammars.finite_state import Compiler, Rule, expand
from grammars.parse import grammar, parse
from grammars.ranking import Leaf, Tree
from grammars.registry import Form, discover
from grammars.source import grammar_text
from grammars.vocabulary import BORN, Vocabulary, lines

COMPILED: Final = "heard.json"
START: Final = "start"
QUOTE: Final = "quote"
SILENT: Final = frozenset(("_COMMA",))  # terminals that make no sound


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
    kept = files("grammars").joinpath(COMPILED)
    data = json.loads(kept.read_text("utf8")) if kept.is_file() else {}
    if data.get("source") != _source():
        data = compile_heard()
    arcs = tuple((source, word, target) for source, word, target in data["arcs"])
    return Automaton(data["start"], frozenset(data["finals"]), arcs, tuple(data["typical"]))


def compile_heard() -> dict[str, Any]:
    """The skeleton as plain data: two seconds' work, so its result is kept in `heard.json`."""
    rules = heard_rules()
    made = Compiler(rules).compiled(START)
    spoken = expand(made, spoken_words(BORN))
    typical = (said(example) for form in discover().values() for example in form.examples)
    return {
        "source": _source(),
        "start": made.start,
        "finals": sorted(made.finals),
        "arcs": made.arcs,
        "typical": [sentence for sentence in typical if spoken.accepts(sentence.split())],
    }


def _source() -> str:
    """What the skeleton is made of."""
    examples = (example for form in discover().values() for example in form.examples)
    text = "\n".join((grammar_text(), _stand_ins(), *lines("heard"), *examples))
    return sha256(text.encode()).hexdigest()


def said(sentence: str) -> str:
    """A written sentence as a recogniser would write it."""
    return " ".join(re.findall(r"[\w'-]+", sentence.lower()))


def heard_rules() -> list[Rule]:
    """Every rule of what is heard: those of `heard.lark`, the examples, and of all others the parser's own."""
    rules = [*stand_ins()]
    replaced = {origin for origin, _ in rules}
    rules += [rule for rule in parser_rules() if rule[0] not in replaced]
    forms = [form for form in discover().values() if not form.expected]
    like = _LikeExamples(rules, replaced - discover().keys())
    rules += [rule for form in forms for rule in like.rules(form)]
    return rules + [("_form", (form.name,)) for form in forms]


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
    """Turns examples into rules.

    Args:
        rules: without those of examples.
        shared: names of rules that stand for phrases; the words of an example that such a rule has may be any of it.
    """

    def __init__(self, rules: Iterable[Rule], shared: frozenset[str] | set[str]) -> None:
        self._compiler, self._shared = Compiler(rules), shared
        self._words = spoken_words(BORN)

    def rules(self, form: Form) -> Iterator[Rule]:
        """A rule for each example."""
        for example in form.examples:
            tree = next(_sentences(parse(example).trees[0], form.name))
            symbols: list[str] = []
            for child in tree.children:
                self._add(child, symbols)
            yield form.name, tuple(symbols)

    def _add(self, node: Tree | Leaf, symbols: list[str]) -> None:
        """Append a node's symbols. Two things in a row stay as they are: any name after any name would be a million
        pairs."""
        if not isinstance(node, Tree):
            if (word := self._terminal(node)) not in SILENT:
                symbols.append(word)
            return
        name = str(node.rule.origin.name)
        if name == QUOTE or (name in self._shared and self._has(name, node)):
            if not (symbols and self._is_name(symbols[-1]) and self._is_name(name)):
                symbols.append(name)
                return
        for child in node.children:
            self._add(child, symbols)

    def _has(self, name: str, phrase: Tree) -> bool:
        words = [self._terminal(leaf) for leaf in phrase.leaves()]
        return self._compiler.compiled(name).accepts(words)

    def _is_name(self, symbol: str) -> bool:
        """A name alone may be said for it."""
        return symbol in self._shared and self._compiler.compiled(symbol).accepts(["PROPER"])

    def _terminal(self, leaf: Leaf) -> str:
        """The category of a word; the word itself where the ears know other words of that category only."""
        name, token = leaf
        if name == "VERB" and token.piece.text in self._words["HANDLING"]:
            return "HANDLING"
        known = name in _literals() or token.piece.kind != "word" or name in SILENT
        return _written(name) if known or token.piece.text in self._words.get(name, ()) else f'"{token.piece.text}"'


def _sentences(tree: Tree, form: str) -> Iterator[Tree]:
    """The derivations of a form in a derivation."""
    if tree.rule.origin.name == form:
        yield tree
    for child in tree.children:
        if isinstance(child, Tree):
            yield from _sentences(child, form)


def _written(name: str) -> str:
    """A word that is written out in a rule instead of the name lark gives it; any other symbol as it is."""
    word = _literals().get(name)
    return name if word is None else f'"{word}"'


@cache
def _literals() -> Mapping[str, str]:
    return {name: word for word, name in grammar().literal.items()}


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
