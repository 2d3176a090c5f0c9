"""One sentence being read: as it stands, with its typos repaired, with its unknown word guessed; the best reading that
means something wins. How words are put together is the business of `parse.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from grammars.alist import AList
from grammars.build import NoMeaningError
from grammars.lattice import Lexer, Token, variants
from grammars.nearest import near_words
from grammars.normalise import Piece
from grammars.ranking import Charge, Ranking, Tree, to_alist
from grammars.registry import discover
from kernel.memory.meaning import Meaning

MOST_REPAIRED: Final = 2  # typos in one sentence
MOST_REPAIRS: Final = 9  # ways to repair them that are tried
CONDITIONALS: Final = frozenset("if when whenever unless until while".split())


class BrokenOffError(Exception):
    """The words have no derivation. at: how many of them could begin one."""

    def __init__(self, at: int) -> None:
        super().__init__(at)
        self.at = at


@dataclass(frozen=True, slots=True)
class Parsed:
    """A sentence understood.

    Attributes:
        text: as given; of an answer about a word, the whole sentence that it stands for.
        kind: of the sentence (language.md, Kinds).
        meaning: for the mind.
        alist: slots, values and brackets.
        unknown_words: words taken for something by their position.
        repaired: (as typed, as taken) for each typo.
        alternatives: number of readings found.
        others: association lists of the other readings, best first.
        charges: of this reading and of the others: what each rule and word cost, which is what ranked them.
        taught: the word which the sentence, an answer, tells to be something to do.
    """

    text: str
    kind: str
    meaning: Meaning
    alist: AList
    unknown_words: tuple[str, ...] = ()
    repaired: tuple[tuple[str, str], ...] = ()
    alternatives: int = 1
    others: tuple[AList, ...] = ()
    taught: str = ""
    charges: tuple[tuple[Charge, ...], ...] = ()


@dataclass
class Reader:
    """One sentence being read.

    Attributes:
        text: as given.
        lexer: turns its words into tokens.
        derive: the forest of all derivations of tokens, as a sentence or as what else is named.
        cost: of each rule of the grammar, by its id.
        reached: how many words the best attempt took.
    """

    text: str
    lexer: Lexer
    derive: Callable[..., Any]
    cost: Mapping[int, int]
    reached: int = 0

    def readings(self, found: list[Piece], strange: Sequence[int]) -> Iterator[Parsed]:
        """What it means as it stands, else with its typos repaired, else with its one unknown word guessed."""
        for variant in variants(found, self.lexer.vocabulary):
            yield from self.read(variant)
        # Where reading broke off before the first strange word, another word in its place cannot help.
        if 0 < len(strange) <= MOST_REPAIRED and strange[0] <= self.reached:
            yield from self.repaired(found, strange, likely=True)
            if len(strange) == 1:
                yield from self.read(found, guessing=True)
            yield from self.repaired(found, strange, likely=False)

    def repaired(
        self, found: list[Piece], strange: Sequence[int], likely: bool
    ) -> Iterator[Parsed]:
        """What it means with its typos repaired, if that can be one thing only."""
        readings = [
            reading
            for variant, repaired in self.corrected(found, strange, likely)
            for reading in self.read(variant, repaired=repaired)
        ]
        if len(readings) == 1:
            yield from readings

    def read(
        self,
        found: Sequence[Piece],
        guessing: bool = False,
        repaired: tuple[tuple[str, str], ...] = (),
    ) -> Iterator[Parsed]:
        """The best reading that means something, if there is one."""
        try:
            forest = self.derive(self.lexer.tokens(found, guessing))
        except BrokenOffError as error:
            self.reached = max(self.reached, error.at)
            return
        made = [
            (alist, tree, *meant)
            for tree in Ranking(self.cost, {}).best(forest)
            if not self.swallows(tree)
            if (meant := _built(alist := to_alist(tree, self.text))) is not None
        ]
        for alist, tree, kind, meaning in made[:1]:
            others = tuple(other for other, *_ in made[1:])
            charges = tuple(tuple(tree.charges(self.cost)) for _, tree, *_ in made)
            yield Parsed(
                self.text,
                kind,
                meaning,
                alist,
                tree.guessed(),
                repaired,
                len(made),
                others,
                charges=charges,
            )

    def swallows(self, tree: Tree) -> bool:
        """A quote without quotation marks runs on over a condition: "say hi unless Mary is near" says no such thing."""
        return any(
            token.piece.text in CONDITIONALS and self.is_condition([t for _, t in words[at:]])
            for words in tree.quotes()
            for at, (_, token) in enumerate(words[:-1], start=1)
            if at > 1
        )

    def is_condition(self, tokens: Sequence[Token]) -> bool:
        """The words are clauses."""
        try:
            self.derive(tokens, "conds")
        except BrokenOffError:
            return False
        return True

    def corrected(
        self, found: list[Piece], places: Sequence[int], likely: bool
    ) -> Iterator[tuple[list[Piece], tuple[tuple[str, str], ...]]]:
        """The sentence with its strange words replaced by near ones."""
        known, literal = self.lexer.vocabulary, self.lexer.literal
        words = tuple({*known.everything, *literal})
        builders = {word for word in literal if not known.readings(word)}
        choices: list[list[Piece]] = [found]
        for at in places:
            choices = [
                [*done[:at], Piece("word", word, found[at].begin, found[at].end), *done[at + 1 :]]
                for done in choices
                for word in near_words(found[at].text, words, builders)
                or ([] if likely else near_words(found[at].text, words, builders, likely=False))
            ]
        for variant in choices[:MOST_REPAIRS]:
            yield variant, tuple((found[at].text, variant[at].text) for at in places)

    def understood(self, found: Sequence[Piece]) -> str:
        """The beginning of the sentence that could start a sentence."""
        return self.text[: found[min(self.reached, len(found)) - 1].end] if self.reached else ""


def _built(sentence: AList) -> tuple[str, Meaning] | None:
    """Kind and meaning of a reading; None where the net has no room for it."""
    if any(part.name == "quote" and not part.value for part in sentence.walk()):
        return None
    forms = discover()
    body = next(part for part in sentence if part.name in forms)
    form = forms[body.name]
    try:
        return form.kind, form.build(body)
    except NoMeaningError:
        return None
