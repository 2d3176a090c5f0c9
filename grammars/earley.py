"""lark's Earley parser over the compiled grammar, reading a lattice: the one door to lark.

A terminal of the grammar is a word written out in a rule or a category (VERB, NOUN ...); a word may be in several, so a
terminal matches a word if it is one of the word's readings.
"""

from __future__ import annotations

import importlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, Final

from lark.exceptions import UnexpectedInput
from lark.grammar import NonTerminal, Rule, RuleOptions, Terminal
from lark.parsers import earley
from lark.parsers.earley_common import Item
from lark.parsers.earley_forest import StableSymbolNode
from lark.utils import OrderedSet

from grammars.errors import BrokenOffError
from grammars.lattice import Token
from grammars.source import digest, grammar_text, kept
from grammars.vocabulary import set_phrases

COMPILED: Final = "grammar.json"
ITEM: Final[Any] = Item  # lark leaves them untyped
NODE: Final[Any] = StableSymbolNode


@dataclass(frozen=True, slots=True)
class Production:
    """One rule of the grammar, plain: for whoever compiles it into something else.

    Attributes:
        origin: the rule's name.
        symbols: rule names, categories, and words in quotation marks.
    """

    origin: str
    symbols: tuple[str, ...]


# There is one object for each symbol and each rule: lark compares them by name, which was a third of the time.
class _NonTerminal(NonTerminal):
    __eq__ = object.__eq__
    __hash__ = object.__hash__


class _Terminal(Terminal):
    __eq__ = object.__eq__
    __hash__ = object.__hash__


class _Rule(Rule):
    __slots__ = ()
    __eq__ = object.__eq__
    __hash__ = object.__hash__


class _NoLexer:
    """The part of a lexer's configuration that lark's parser reads."""

    terminals_by_name: Final[dict[str, Any]] = {}


class _Earley(earley.Parser):
    """lark's Earley parser, set up for a lattice.

    lark's own constructor computes FIRST, FOLLOW and the closure of every rule, half a second's work on this grammar
    that a parser with lookahead does not need; no rule here is empty, so NULLABLE is.

    Attributes:
        waiting: of each column that is done, its items by the symbol that they wait for.
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
        self.goes_on = predictions.goes_on
        self.waiting: list[dict[Any, list[Any]]] = []

    def predict_and_complete(
        self, i: int, to_scan: Any, columns: Any, transitives: Any, node_cache: dict[Any, Any]
    ) -> None:
        """As lark does it, for a grammar without empty rules: a symbol is predicted once a column, what a completed one
        was waited for by is looked up, and what the next word cannot go on is dropped at once."""
        if i == 0:
            self.waiting.clear()
        column = columns[i]
        items = [item for item in column if item.is_complete or self.goes_on(item.expect)]
        predicted = set()
        while items:
            item = items.pop()
            if item.is_complete:
                for waiting in self.waiting[item.start].get(item.s, ()):
                    following = waiting.rule.expansion[waiting.ptr + 1 : waiting.ptr + 2]
                    if following and not self.goes_on(following[0]):
                        continue
                    new = waiting.advance()
                    label = (new.s, waiting.start, i)
                    node = node_cache.get(label)
                    if node is None:
                        node = node_cache[label] = NODE(*label)
                    new.node = node
                    node.add_family(new.s, new.rule, i, waiting.node, item.node)
                    _put(new, to_scan, column, items)
            elif item.expect not in predicted:
                predicted.add(item.expect)
                for rule in self.predictions[item.expect]:
                    _put(ITEM(rule, 0, i), to_scan, column, items)
        by_symbol: dict[Any, list[Any]] = {}
        for item in column:
            if not item.is_complete:
                by_symbol.setdefault(item.expect, []).append(item)
        self.waiting.append(by_symbol)


def _put(item: Any, to_scan: Any, column: Any, items: list[Any]) -> None:
    """An item among those that wait for a word, or among the new ones of the column."""
    if not item.is_complete and item.expect.is_term:
        to_scan.add(item)
    elif item not in column:
        column.add(item)
        items.append(item)


class Grammar:
    """The compiled grammar and the parser over it.

    Holds no state between sentences but the lookahead at the current word, by which rules that cannot start with it
    are not predicted: that saves three quarters of the work.
    """

    def __init__(self, rules: list[Any], literal: dict[str, str]) -> None:
        self.rules, self.literal = rules, literal
        self.cost = {id(rule): -(rule.options.priority or 0) for rule in rules}
        self.by_origin: dict[str, list[Any]] = {}
        for rule in rules:
            self.by_origin.setdefault(rule.origin.name, []).append(rule)
        self.lookahead: frozenset[str] = frozenset()
        self.first = self._first_sets()
        self.predicted: dict[tuple[str, frozenset[str]], list[Any]] = {}
        self.parser = _Earley(rules, self)

    def __getitem__(self, symbol: Any) -> list[Any]:
        """Rules for a symbol that can start with the next word; lark asks this as its table of predictions."""
        key = (symbol.name, self.lookahead)
        found = self.predicted.get(key)
        if found is None:
            if len(self.predicted) > 20_000:
                self.predicted.clear()
            found = [r for r in self.by_origin[symbol.name] if self.first[id(r)] & self.lookahead]
            self.predicted[key] = found
        return found

    def goes_on(self, symbol: Any) -> bool:
        """Whether the next word can be the first of the symbol."""
        return symbol.name in self.lookahead if symbol.is_term else bool(self[symbol])

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
    terminals, rules, _ = compiled.compile(["start", "expected", "called_out"], "*")
    return {
        "source": digest(text),
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
    data = kept(COMPILED, digest(grammar_text()), compile_grammar)
    rule = cache(_NonTerminal)
    terminal = cache(_Terminal)
    rules = [
        _Rule(
            rule(origin),
            [terminal(name, drop) if term else rule(name) for name, term, drop in symbols],
            order,
            alias,
            RuleOptions(priority=priority),
        )
        for origin, symbols, order, alias, priority in data["rules"]
    ]
    return Grammar(rules, data["literal"])


def productions() -> tuple[Production, ...]:
    """Every rule; a set phrase is a rule of its category."""
    words = {name: f'"{word}"' for name, word in written_words().items()}
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


@cache
def written_words() -> dict[str, str]:
    """The words written out in rules, by the names that lark gives their terminals."""
    return {name: word for word, name in grammar().literal.items()}


def closed_words() -> frozenset[str]:
    """Words written out in the rules."""
    return frozenset(grammar().literal)
