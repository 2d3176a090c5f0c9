"""Sentences into meanings: words with their categories, lark's Earley parser, ranked readings, association list, net.

The one door to lark. The grammar is put together from `toplevel.lark`, `phrase.lark` and every `forms/*.lark`. Its
terminals are words written out in the rules and categories (VERB, NOUN ...); a word may be in several categories, so
the parser reads a lattice: a terminal matches a word if it is one of the word's readings.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from importlib.resources import files
from typing import Any, Final

from lark.exceptions import UnexpectedInput
from lark.load_grammar import load_grammar
from lark.parsers import earley
from lark.parsers.earley_forest import StableSymbolNode
from lark.utils import OrderedSet

from grammars.alist import AList
from grammars.build import NoMeaningError
from grammars.errors import NotUnderstoodError
from grammars.morphology import readings as verb_readings
from grammars.nearest import nearest_sentence, near_words
from grammars.normalise import Piece, pieces, repaired_by_speaker, without_repeats
from grammars.registry import discover
from grammars.vocabulary import BORN, OPEN, Vocabulary, lines, set_phrases
from kernel.memory.meaning import Meaning

MOST_WORDS: Final = 60
MOST_READINGS: Final = 6
MOST_REPAIRED: Final = 2  # typos in one sentence
# Words around a set phrase that are no part of it.
ADDRESS: Final = frozenset(
    "hey okay robot now please well so alright listen kindly for me then thanks".split()
)
# Words that build sentences: a quote without quotation marks neither starts with one nor holds several.
BUILDERS: Final = frozenset(
    "before after instead means unless until when whenever if then while than because".split()
)
# What it costs to take a word as something else than it is known to be, and other things better avoided.
TERMINAL_COST: Final[dict[str, int]] = {"ANYWORD": 2, "OPENWORD": 1, "STRANGE": 3, "UNK": 10}
CATEGORIES: Final = (
    "VERB VERBS VERBING VERBED GIVE MOTION STATE STATES NOUN NOUNS ADJ ADJER ADJEST ADV DEG DIR PROPER NUM UNIT PREP ORD"
    " QUOTED ANYWORD NEWING OPENWORD STRANGE UNK _COMMA"
).split()


@dataclass(frozen=True, slots=True)
class Production:
    """One rule of the grammar, plain: for whoever compiles it into something else.

    Attributes:
        origin: the rule's name.
        symbols: rule names, categories and written-out words.
    """

    origin: str
    symbols: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Parsed:
    """A sentence understood.

    Attributes:
        text: as given.
        kind: of the sentence (language.md, Kinds).
        meaning: for the mind.
        alist: slots, values and brackets.
        unknown_words: words taken for something by their position.
        repaired: (as typed, as taken) for each typo.
        alternatives: number of readings found.
        others: association lists of the other readings, best first.
    """

    text: str
    kind: str
    meaning: Meaning
    alist: AList
    unknown_words: tuple[str, ...] = ()
    repaired: tuple[tuple[str, str], ...] = ()
    alternatives: int = 1
    others: tuple[AList, ...] = ()


@dataclass(frozen=True, slots=True)
class Token:
    """A word in the lattice: terminal name to lemma."""

    index: int
    piece: Piece
    readings: Mapping[str, str] = field(hash=False)
    known: bool = True


@dataclass(frozen=True, slots=True)
class Tree:
    """A derivation: a lark rule with its children in order."""

    rule: Any
    children: tuple[Tree | tuple[str, Token], ...]


Ranked = list[tuple[int, tuple[Any, ...]]]


def grammar_text() -> str:
    """The whole grammar: top level, phrases, and the pair-wise files of the forms."""
    names = sorted(discover())
    folder = files("grammars")
    parts = [folder.joinpath(name).read_text("utf8") for name in ("toplevel.lark", "phrase.lark")]
    parts += [folder.joinpath("forms", f"{name}.lark").read_text("utf8") for name in names]
    parts.append(f"_form: {' | '.join(names)}")
    parts.append("%declare " + " ".join((*CATEGORIES, *set_phrases())))
    return "\n".join(parts)


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
        self.NON_TERMINALS = {symbol for rule in rules for symbol in rule.expansion} - self.TERMINALS
        self.term_matcher = lambda terminal, token: terminal.name in token.readings
        self.lexer_conf = _NoLexer()


class _NoLexer:
    """The part of a lexer's configuration that lark's parser reads."""

    terminals_by_name: Final[dict[str, Any]] = {}


class Grammar:
    """The compiled grammar and the parser over it. Holds no state between sentences but the lookahead of the current
    word, by which rules that cannot start with it are not predicted: that saves three quarters of the work.
    """

    def __init__(self, text: str) -> None:
        compiled, _ = load_grammar(text, "toplevel.lark", [], False)
        terminals, rules, _ = compiled.compile(["start"], "*")
        self.rules: list[Any] = list(rules)
        self.cost = {id(rule): -(rule.options.priority or 0) for rule in self.rules}
        self.literal: dict[str, str] = {
            terminal.pattern.value: terminal.name
            for terminal in terminals
            if terminal.pattern.type == "str"
        }
        self.by_origin: dict[Any, list[Any]] = {}
        for rule in self.rules:
            self.by_origin.setdefault(rule.origin, []).append(rule)
        self.lookahead: frozenset[str] = frozenset()
        self.first = self._first_sets()
        self.filtered: dict[tuple[Any, frozenset[str]], list[Any]] = {}
        self.parser = _Earley(self.rules, self)

    def __getitem__(self, symbol: Any) -> list[Any]:
        """Rules for a symbol that can start with the next word; lark asks this as its table of predictions."""
        key = (symbol, self.lookahead)
        found = self.filtered.get(key)
        if found is None:
            if len(self.filtered) > 20_000:
                self.filtered.clear()
            found = [r for r in self.by_origin[symbol] if self.first[id(r)] & self.lookahead]
            self.filtered[key] = found
        return found

    def _first_sets(self) -> dict[int, frozenset[str]]:
        """Terminals each rule can start with. No rule of the grammar is empty."""
        starts: dict[str, set[str]] = {rule.origin.name: set() for rule in self.rules}
        changed = True
        while changed:
            changed = False
            for rule in self.rules:
                head = rule.expansion[0]
                new = {head.name} if head.is_term else starts[head.name]
                if not new <= starts[rule.origin.name]:
                    starts[rule.origin.name] |= new
                    changed = True
        heads = {id(rule): rule.expansion[0] for rule in self.rules}
        return {
            key: frozenset({head.name} if head.is_term else starts[head.name])
            for key, head in heads.items()
        }

    def forest(self, tokens: Sequence[Token]) -> Any:
        """The shared forest of all derivations.

        Raises:
            UnexpectedInput: there is none.
        """
        return self.parser.parse(_Lattice(self, tokens), "start")

    def best(self, root: Any) -> list[tuple[int, Tree]]:
        """The cheapest derivations, cheapest first."""
        memo: dict[int, Ranked] = {}
        return [(cost, trees[0]) for cost, trees in self._rank(root, memo)]

    def _rank(self, node: Any, memo: dict[int, Ranked]) -> Ranked:
        if id(node) in memo:
            return memo[id(node)]
        memo[id(node)] = []  # a cycle derives nothing
        found: Ranked = []
        for packed in node.children:
            rule = packed.rule
            ptr = node.s[1] if node.is_intermediate else len(rule.expansion)
            lefts: Ranked = [(0, ())] if packed.left is None else self._rank(packed.left, memo)
            rights = self._right(packed.right, rule, ptr, memo)
            extra = 0 if node.is_intermediate else self.cost[id(rule)]
            for left_cost, left in lefts:
                for right_cost, right in rights:
                    children = (*left, *right)
                    made = children if node.is_intermediate else (Tree(rule, children),)
                    found.append((left_cost + right_cost + extra, made))
        found.sort(key=lambda ranked: ranked[0])
        memo[id(node)] = found[:MOST_READINGS]
        return memo[id(node)]

    def _right(self, node: Any, rule: Any, ptr: int, memo: dict[int, Ranked]) -> Ranked:
        if node is None:
            return [(0, ())]
        if hasattr(node, "token"):
            terminal = rule.expansion[ptr - 1].name
            cost = -1 if terminal in set_categories() else TERMINAL_COST.get(terminal, 0)
            return [(cost, ((terminal, node.token),))]
        return self._rank(node, memo)


class _Lattice:
    """What lark takes for a lexer: hands over the tokens and tells the grammar which comes next."""

    def __init__(self, grammar: Grammar, tokens: Sequence[Token]) -> None:
        self.grammar, self.tokens = grammar, tokens
        grammar.lookahead = frozenset(tokens[0].readings) if tokens else frozenset()

    def lex(self, _expected: object) -> Iterator[Token]:
        """The words, each known to the grammar before lark predicts what may start with it."""
        for token in self.tokens:
            self.grammar.lookahead = frozenset(token.readings)
            yield token
        self.grammar.lookahead = frozenset()


@cache
def grammar() -> Grammar:
    """The grammar, compiled once."""
    return Grammar(grammar_text())


@cache
def _idioms() -> frozenset[tuple[str, ...]]:
    return frozenset(tuple(piece.text for piece in pieces(line)) for line in lines("idioms"))


def productions() -> tuple[Production, ...]:
    """Every rule, with words written out in rules as themselves; a set phrase is a rule of its category."""
    words = {name: word for word, name in grammar().literal.items()}
    phrases = tuple(
        Production(category, tuple(phrase.split()))
        for category, said in set_phrases().items()
        for phrase in said
    )
    return phrases + tuple(
        Production(
            rule.origin.name,
            tuple(words.get(s.name, s.name) if s.is_term else s.name for s in rule.expansion),
        )
        for rule in grammar().rules
    )


def closed_words() -> frozenset[str]:
    """Words written out in the rules."""
    return frozenset(grammar().literal)


def parse(text: str, vocabulary: Vocabulary = BORN, expecting: object = None) -> Parsed:
    """What a sentence means.

    Args:
        text: one sentence, typed or recognised.
        vocabulary: the words known.
        expecting: the robot's open question, if any; its answer forms come first.

    Raises:
        NotUnderstoodError: it means nothing in this language, or is no text.
    """
    if not isinstance(text, str) or not text.isprintable() or len(text) > 1000:
        raise NotUnderstoodError(str(text)[:1000])
    found = pieces(text)
    if not found or len(found) > MOST_WORDS or tuple(p.text for p in found) in _idioms():
        raise NotUnderstoodError(text)
    reader = _Reader(text, vocabulary)
    for variant in _variants(found, vocabulary):
        if (parsed := reader.read(variant)) is not None:
            return parsed
    strange = [at for at, piece in enumerate(found) if reader.strange(piece)]
    # Where reading broke off before the first strange word, another word in its place cannot help.
    if 0 < len(strange) <= MOST_REPAIRED and strange[0] <= reader.reached:
        for variant, repaired in reader.corrected(found, strange):
            if (parsed := reader.read(variant, repaired=repaired)) is not None:
                return parsed
        if len(strange) == 1 and (parsed := reader.read(found, guessing=True)) is not None:
            return parsed
    raise NotUnderstoodError(
        text,
        reader.understood(found),
        nearest_sentence(text),
        tuple(dict.fromkeys(p.text for p in found if reader.strange(p))),
    )


def _variants(found: list[Piece], vocabulary: Vocabulary) -> Iterator[list[Piece]]:
    """The sentence with set phrases made one word, as said, without stammering, and with the speaker's own corrections
    carried out."""
    seen: list[list[Piece]] = []
    once = without_repeats(found)
    for variant in (
        _as_phrase(found, vocabulary),
        _with_phrases(found, vocabulary),
        found,
        once,
        repaired_by_speaker(once),
    ):
        if variant and variant not in seen:
            seen.append(variant)
            yield variant


def _as_phrase(found: list[Piece], vocabulary: Vocabulary) -> list[Piece]:
    """The sentence with the set phrase that it consists of made one word; empty if it is none."""
    words = [piece for piece in found if piece.kind != "comma"]
    ends = [at for at in range(len(words) + 1) if all(p.text in ADDRESS for p in words[at:])]
    starts = [at for at in range(len(words)) if all(p.text in ADDRESS for p in words[:at])]
    for begin in starts:
        for end in reversed(ends):
            text = " ".join(piece.text for piece in words[begin:end])
            if begin < end and any(c in set_categories() for c in vocabulary.readings(text)):
                return [*words[:begin], _merged(words[begin:end]), *words[end:]]
    return []


def _with_phrases(found: list[Piece], vocabulary: Vocabulary) -> list[Piece]:
    """The sentence with taught verbs of several words made one word each; empty if there are none."""
    result, at = list(found), 0
    while at < len(result):
        for words in vocabulary.taught_phrases:
            run = result[at : at + len(words)]
            if tuple(piece.text for piece in run) == words:
                result[at : at + len(words)] = [_merged(run)]
                break
        at += 1
    return result if len(result) < len(found) else []


def _merged(run: Sequence[Piece]) -> Piece:
    return Piece("word", " ".join(piece.text for piece in run), run[0].begin, run[-1].end)


@cache
def set_categories() -> frozenset[str]:
    """Categories of set phrases."""
    return frozenset(set_phrases())


class _Reader:
    """One sentence being read with one vocabulary."""

    def __init__(self, text: str, vocabulary: Vocabulary) -> None:
        self.text, self.vocabulary, self.grammar = text, vocabulary, grammar()
        self.reached = 0

    def strange(self, piece: Piece) -> bool:
        """A word in no category and in no rule."""
        return (
            piece.kind == "word"
            and not self.vocabulary.knows(piece.text)
            and piece.text not in self.grammar.literal
        )

    def tokens(self, found: Sequence[Piece], guessing: bool) -> list[Token]:
        """The lattice."""
        return [self._token(at, piece, guessing) for at, piece in enumerate(found)]

    def _token(self, at: int, piece: Piece, guessing: bool) -> Token:
        if piece.kind == "comma":
            return Token(at, piece, {"_COMMA": ","})
        if piece.kind == "quote":
            return Token(at, piece, {"QUOTED": piece.text})
        if piece.kind == "number":
            return Token(at, piece, {"NUM": piece.text, "ANYWORD": piece.text})
        if piece.kind != "word":
            return Token(at, piece, {"NOTHING": piece.text})
        readings = self.vocabulary.readings(piece.text)
        strange = self.strange(piece)
        if readings.keys() & set(OPEN) or strange:
            readings["OPENWORD"] = piece.text
        if strange:
            readings["STRANGE"] = piece.text
            for reading in verb_readings(piece.text, "verb"):
                if reading.form == "gerund":
                    readings.setdefault("NEWING", reading.lemma)
            if piece.capital:
                readings["PROPER"] = piece.text
            if guessing:
                readings["UNK"] = piece.text
        if piece.text == "one":
            readings["NUM"] = "1"
        literal = self.grammar.literal.get(piece.text)
        if literal:
            readings[literal] = piece.text
        readings["ANYWORD"] = piece.text
        return Token(at, piece, readings, not strange)

    def read(
        self,
        found: Sequence[Piece],
        guessing: bool = False,
        repaired: tuple[tuple[str, str], ...] = (),
    ) -> Parsed | None:
        """The best reading that means something."""
        tokens = self.tokens(found, guessing)
        try:
            forest = self.grammar.forest(tokens)
        except UnexpectedInput as error:
            token = getattr(error, "token", None)
            at = token.index if isinstance(token, Token) else len(found)
            self.reached = max(self.reached, at)
            return None
        forms = discover()
        readings: list[tuple[AList, tuple[str, ...], str, Meaning]] = []
        for _, tree in self.grammar.best(forest):
            alist = to_alist(tree, self.text)
            body = next(part for part in alist if part.name in forms)
            form = forms[body.name]
            try:
                meaning = form.build(body)
            except NoMeaningError:
                continue
            readings.append((alist, _guessed(tree), form.kind, meaning))
        if not readings:
            return None
        alist, unknown, kind, meaning = readings[0]
        return Parsed(
            self.text,
            kind,
            meaning,
            alist,
            unknown,
            repaired,
            len(readings),
            tuple(other for other, *_ in readings[1:]),
        )

    def corrected(
        self, found: list[Piece], places: Sequence[int]
    ) -> Iterator[tuple[list[Piece], tuple[tuple[str, str], ...]]]:
        """The sentence with its strange words replaced by near ones."""
        words = sorted({*self.vocabulary.everything, *self.grammar.literal})
        choices: list[list[Piece]] = [found]
        for at in places:
            near = near_words(found[at].text, words)
            choices = [
                [*done[:at], Piece("word", word, found[at].begin, found[at].end), *done[at + 1 :]]
                for done in choices
                for word in near
            ]
        for variant in choices[:9]:
            yield variant, tuple((found[at].text, variant[at].text) for at in places)

    def understood(self, found: Sequence[Piece]) -> str:
        """The beginning of the sentence that could start a sentence."""
        if not self.reached:
            return ""
        return self.text[: found[min(self.reached, len(found)) - 1].end]


def _guessed(tree: Tree) -> tuple[str, ...]:
    """Unknown words the derivation uses other than in quotes."""
    words: dict[str, None] = {}

    def visit(node: Tree) -> None:
        for child in node.children:
            if isinstance(child, Tree):
                visit(child)
            elif child[0] != "ANYWORD" and not child[1].known:
                words[child[1].piece.text] = None

    visit(tree)
    return tuple(words)


def to_alist(tree: Tree, text: str) -> AList:
    """Walk the tree and retain selected nodes: rules that start with "_" leave no bracket, words written out in a rule
    leave no slot unless the rule is marked "!"."""
    (sentence,) = _parts(tree, text)
    return sentence


def _parts(tree: Tree, text: str) -> Iterable[AList]:
    rule = tree.rule
    name = str(rule.alias or rule.origin.name)
    if name == "quote":
        return [AList("quote", value=_quote(tree, text))]
    slots: list[AList] = []
    only_words = True
    for symbol, child in zip(rule.expansion, tree.children, strict=True):
        if isinstance(child, Tree):
            inner = list(_parts(child, text))
            only_words = only_words and not inner
            slots += inner
        elif not symbol.filter_out:
            terminal, token = child
            slots.append(AList(terminal.lower(), value=token.readings[terminal]))
    if name.startswith("_"):
        return slots
    if only_words and slots:
        return [AList(name, value=" ".join(slot.value or "" for slot in slots))]
    return [AList(name, tuple(slots))]


def _quote(tree: Tree, text: str) -> str:
    """The words of a quote, as they stand in the text; nothing where they are no quote but scrambled words."""
    leaves: list[Token] = []

    def visit(node: Tree) -> None:
        for child in node.children:
            if isinstance(child, Tree):
                visit(child)
            else:
                leaves.append(child[1])

    visit(tree)
    if leaves[0].piece.kind == "quote":
        return leaves[0].piece.text
    words = [leaf.piece.text for leaf in leaves]
    if words[0] in BUILDERS or sum(word in BUILDERS for word in words) > 1:
        return ""
    return re.sub(r"\s+", " ", text[leaves[0].piece.begin : leaves[-1].piece.end]).strip()
