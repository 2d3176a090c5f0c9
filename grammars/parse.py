"""Sentences into meanings: words with their categories, lark's Earley parser, ranked readings, association list, net.

The one door to lark. A terminal of the grammar is a word written out in a rule or a category (VERB, NOUN ...); a word
may be in several, so the parser reads a lattice: a terminal matches a word if it is one of the word's readings.
"""

from __future__ import annotations

import importlib
import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from hashlib import sha256
from importlib.resources import files
from itertools import chain
from typing import Any, Final

from lark.exceptions import UnexpectedInput
from lark.grammar import NonTerminal, Rule, RuleOptions, Terminal
from lark.parsers import earley
from lark.parsers.earley_forest import StableSymbolNode
from lark.utils import OrderedSet

from grammars.asking import NO, YES, AskWord, agreed, fits, told
from grammars.chatter import is_chatter
from grammars.errors import NotUnderstoodError
from grammars.lattice import Lexer, Token, variants
from grammars.nearest import nearest_sentence
from grammars.normalise import pieces
from grammars.reading import Attempts, BrokenOffError, Parsed, Reader
from grammars.source import grammar_text
from grammars.suggesting import Words, rather, respelt
from grammars.vocabulary import BORN, Vocabulary, set_phrases, with_verb
from kernel.memory.reply import AskKeep, AskWhich

MOST_WORDS: Final = 60
MOST_LETTERS: Final = 1000
MOST_READ: Final = 30  # words of all attempts upon a sentence, before another suggestion is tried
COMPILED: Final = "grammar.json"


@dataclass(frozen=True, slots=True)
class Production:
    """One rule of the grammar, plain: for whoever compiles it into something else.

    Attributes:
        origin: the rule's name.
        symbols: rule names, categories, and words in quotation marks.
    """

    origin: str
    symbols: tuple[str, ...]


class _NoLexer:
    """The part of a lexer's configuration that lark's parser reads."""

    terminals_by_name: Final[dict[str, Any]] = {}


class _Earley(earley.Parser):
    """lark's Earley parser, set up for a lattice.

    lark's own constructor computes FIRST, FOLLOW and the closure of every rule, half a second's work on this grammar
    that a parser with lookahead does not need; no rule here is empty, so NULLABLE is.
    """

    def __init__(self, rules: Sequence[Any], predictions: Any) -> None:
        self.debug = False
        self.Tree = None
        self.Set = OrderedSet
        self.SymbolNode = StableSymbolNode
        self.NULLABLE = set()
        self.predictions = predictions
        self.TERMINALS = {symbol for rule in rules for symbol in rule.expansion if symbol.is_term}
        self.NON_TERMINALS = {
            symbol for rule in rules for symbol in rule.expansion
        } - self.TERMINALS
        self.term_matcher = lambda terminal, token: terminal.name in token.readings
        self.lexer_conf: Any = _NoLexer()


class Grammar:
    """The compiled grammar and the parser over it.

    Holds no state between sentences but the lookahead at the current word, by which rules that cannot start with it
    are not predicted: that saves three quarters of the work.
    """

    def __init__(self, rules: list[Any], literal: dict[str, str]) -> None:
        self.rules, self.literal = rules, literal
        self.cost = {id(rule): -(rule.options.priority or 0) for rule in rules}
        self.by_origin: dict[Any, list[Any]] = {}
        for rule in rules:
            self.by_origin.setdefault(rule.origin, []).append(rule)
        self.lookahead: frozenset[str] = frozenset()
        self.first = self._first_sets()
        self.predicted: dict[tuple[Any, frozenset[str]], list[Any]] = {}
        self.parser = _Earley(rules, self)

    def __getitem__(self, symbol: Any) -> list[Any]:
        """Rules for a symbol that can start with the next word; lark asks this as its table of predictions."""
        key = (symbol, self.lookahead)
        found = self.predicted.get(key)
        if found is None:
            if len(self.predicted) > 20_000:
                self.predicted.clear()
            found = [r for r in self.by_origin[symbol] if self.first[id(r)] & self.lookahead]
            self.predicted[key] = found
        return found

    def _first_sets(self) -> dict[int, frozenset[str]]:
        """Terminals each rule can start with. No rule of the grammar is empty."""
        starts: dict[str, set[str]] = {rule.origin.name: set() for rule in self.rules}
        heads = [(rule, rule.expansion[0]) for rule in self.rules]
        changed = True
        while changed:
            changed = False
            for rule, head in heads:
                new = {head.name} if head.is_term else starts[head.name]
                if not new <= starts[rule.origin.name]:
                    starts[rule.origin.name] |= new
                    changed = True
        return {
            id(rule): frozenset({head.name} if head.is_term else starts[head.name])
            for rule, head in heads
        }

    def forest(self, tokens: Sequence[Token], symbol: str = "start") -> Any:
        """The shared forest of all derivations of the symbol.

        Raises:
            BrokenOffError: there is none.
        """
        parse_lattice: Any = self.parser.parse
        try:
            return parse_lattice(_Lattice(self, tokens), symbol)
        except UnexpectedInput as error:
            token = getattr(error, "token", None)
            at = token.index if isinstance(token, Token) else len(tokens)
            raise BrokenOffError(at) from error


class _Lattice:
    """What lark takes for a lexer: hands over the tokens and tells the grammar which comes next."""

    def __init__(self, grammar: Grammar, tokens: Sequence[Token]) -> None:
        self.grammar, self.tokens = grammar, tokens
        grammar.lookahead = frozenset(tokens[0].readings)

    def lex(self, _expected: object) -> Iterator[Token]:
        """The words, each known to the grammar before lark predicts what may start with it."""
        for token in self.tokens:
            self.grammar.lookahead = frozenset(token.readings)
            yield token
        self.grammar.lookahead = frozenset()


def compile_grammar() -> dict[str, Any]:
    """The grammar compiled by lark, as plain data: a second's work, so its result is kept in `grammar.json`."""
    load: Any = importlib.import_module("lark.load_grammar").load_grammar  # slow, seldom needed
    text = grammar_text()
    compiled, _ = load(text, "toplevel.lark", [], False)
    terminals, rules, _ = compiled.compile(["start", "expected"], "*")
    return {
        "source": sha256(text.encode()).hexdigest(),
        "literal": {t.pattern.value: t.name for t in terminals if t.pattern.type == "str"},
        "rules": [
            [
                str(rule.origin.name),
                [
                    [str(s.name), s.is_term, bool(s.is_term and s.filter_out)]
                    for s in rule.expansion
                ],
                rule.order,
                None if rule.alias is None else str(rule.alias),
                rule.options.priority or 0,
            ]
            for rule in rules
        ],
    }


@cache
def grammar() -> Grammar:
    """The grammar: from `grammar.json` if that was made of these very files, else compiled now."""
    kept = files("grammars").joinpath(COMPILED)
    data = json.loads(kept.read_text("utf8")) if kept.is_file() else {}
    if data.get("source") != sha256(grammar_text().encode()).hexdigest():
        data = compile_grammar()
    rules = [
        Rule(
            NonTerminal(origin),
            [Terminal(name, drop) if term else NonTerminal(name) for name, term, drop in symbols],
            order,
            alias,
            RuleOptions(priority=priority),
        )
        for origin, symbols, order, alias, priority in data["rules"]
    ]
    return Grammar(rules, data["literal"])


def productions() -> tuple[Production, ...]:
    """Every rule; a set phrase is a rule of its category."""
    words = {name: f'"{word}"' for word, name in grammar().literal.items()}
    phrases = tuple(
        Production(category, tuple(f'"{word}"' for word in phrase.split()))
        for category, said in set_phrases().items()
        for phrase in said
    )
    return phrases + tuple(
        Production(
            str(rule.origin.name),
            tuple(words.get(s.name, s.name) if s.is_term else s.name for s in rule.expansion),
        )
        for rule in grammar().rules
    )


def closed_words() -> frozenset[str]:
    """Words written out in the rules."""
    return frozenset(grammar().literal)


def parse(
    text: str, vocabulary: Vocabulary = BORN, expecting: AskWhich | AskKeep | AskWord | None = None
) -> Parsed:
    """What a sentence means.

    Args:
        text: one sentence, typed or recognised.
        vocabulary: the words known.
        expecting: the robot's open question, if any: its answers are understood before anything else, and only now.

    Raises:
        NotUnderstoodError: it means nothing in this language, or is no text.
    """
    if not isinstance(text, str) or not text.isprintable() or len(text) > MOST_LETTERS:
        raise NotUnderstoodError(str(text)[:MOST_LETTERS])
    found = pieces(text)
    if not found or len(found) > MOST_WORDS or is_chatter(tuple(p.text for p in found)):
        raise NotUnderstoodError(text)
    lexer = Lexer(vocabulary, grammar().literal)
    if isinstance(expecting, AskWord):
        if (meant := _of_word(text, vocabulary, expecting)) is not None:
            return meant
    elif expecting is not None:
        answers = partial(grammar().forest, symbol="expected")
        for reading in Reader(text, lexer, Attempts(answers), grammar().cost).read(found):
            if fits(reading.meaning, expecting):
                return reading
    attempts = Attempts(grammar().forest)
    reader = Reader(text, lexer, attempts, grammar().cost)
    strange = [at for at, piece in enumerate(found) if reader.lexer.strange(piece)]
    for reading in reader.readings(found, strange):
        return reading
    unknown = tuple(dict.fromkeys(found[at].text for at in strange))
    words = Words(grammar().literal, vocabulary.everything)
    works = partial(_works, vocabulary=vocabulary, attempts=attempts)
    asking, near = None, respelt(text, found, strange, words, works)
    new = unknown[0] if len(unknown) == 1 and unknown[0] not in YES | NO else ""
    if new and near is None and _works(text, with_verb(vocabulary, new), attempts):
        asking = AskWord(new, text)
    elif near is None:
        near = rather(text, found, reader.reached, words, works) or nearest_sentence(text)
    raise NotUnderstoodError(text, reader.understood(found), near, unknown, asking)


def _works(text: str, vocabulary: Vocabulary, attempts: Attempts) -> bool:
    """It means something as it stands, without a guess and not as a fact, which nearly anything can be taken for; so
    far as that may still be tried."""
    if attempts.words > MOST_READ:
        return False
    reader = Reader(text, Lexer(vocabulary, grammar().literal), attempts, grammar().cost)
    found = pieces(text)
    readings = chain.from_iterable(map(reader.read, variants(found, vocabulary)))
    return any(
        reading.kind != "fact"
        and not reading.unknown_words
        and all(part.name != "quote" for part in reading.alist.walk())
        for reading in readings
    )


def _of_word(text: str, vocabulary: Vocabulary, question: AskWord) -> Parsed | None:
    """What the answer to a question about a word means: where it is something to do, the sentence it stood in."""
    if (agreement := agreed(text)) is None:
        sentence = told(question, text)
        try:
            return None if sentence is None else parse(sentence, vocabulary)
        except NotUnderstoodError:
            return None
    if agreement:
        parsed = parse(question.text, with_verb(vocabulary, question.word))
        return replace(parsed, text=text, taught=question.word)
    denied = replace(question, denied=True)
    raise NotUnderstoodError(text, unknown_words=(question.word,), asking=denied)
