"""One sentence being read: as it stands, with its typos repaired, with its unknown word guessed; the best reading that
means something wins. How words are put together is the business of `earley.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Final

from grammars.alist import AList
from grammars.alternatives import alternatives, is_single, neither, together
from grammars.errors import BrokenOffError, NoMeaningError
from grammars.lattice import Lexer, Token, variants
from grammars.nearest import near_words
from grammars.normalise import Piece
from grammars.questions.either import one_of
from grammars.quoting import holds
from grammars.ranking import Ranking, Tree, to_alist
from grammars.registry import discover
from grammars.sorts import is_of_persons
from grammars.ways import is_waiting_for_way
from kernel.memory.meaning import Meaning, Question, Teach

MOST_REPAIRED: Final = 4  # typos in one sentence
MOST_REPAIRS: Final = 9  # ways to repair them that are tried
MOST_READ: Final = (
    40  # words of all attempts upon a sentence, before another way to repair it is tried
)
# Kinds of sentences in which the robot is spoken to as a machine.
LESSONS: Final = frozenset(
    "command procedure reaction before after prohibition permission revision fact".split()
)
# What nobody asks: "you like her?" asks whether it is true.
STATED: Final = LESSONS - {"command", "revision"} | {"rule", "alias"}
SUPPOSED: Final = tuple(Piece("word", word, 0, 0) for word in ("is", "it", "true", "that"))
END: Final[frozenset[str]] = frozenset()  # categories of no word


@dataclass
class Attempts:
    """All that is tried upon one sentence: what has broken off once is not read again.

    How words are derived depends on their categories alone, so words of the same categories break off alike: "grab the
    cup zork" and, with "cup" in its place spelt otherwise, "grab the cap zork".

    Attributes:
        derive: the forest of all derivations of tokens.
        broken: categories of the words up to the one that could not follow, and that itself.
        words: how many were read in all.
    """

    derive: Callable[..., Any]
    broken: set[tuple[frozenset[str], ...]] = field(default_factory=set)
    words: int = 0

    def forest(self, tokens: Sequence[Token]) -> Any:
        """The forest of all derivations as a sentence.

        Raises:
            BrokenOffError: there is none.
        """
        said = (*(frozenset(token.readings) for token in tokens), END)
        for at in range(len(said)):
            if said[: at + 1] in self.broken:
                raise BrokenOffError(at)
        self.words += len(tokens)
        try:
            return self.derive(tokens)
        except BrokenOffError as error:
            self.words -= len(tokens) - error.at
            self.broken.add(said[: error.at + 1])
            raise


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
        trees: derivations of this reading and of the others.
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
    trees: tuple[Tree, ...] = field(default=(), repr=False)


@dataclass
class Reader:
    """One sentence being read.

    Attributes:
        text: as given.
        lexer: turns its words into tokens.
        attempts: upon this sentence.
        cost: of each rule of the grammar, by its id.
        reached: how many words the best attempt took.
    """

    text: str
    lexer: Lexer
    attempts: Attempts
    cost: Mapping[int, int]
    reached: int = 0

    @property
    def asked(self) -> bool:
        """It is written as a question."""
        return self.text.rstrip().endswith("?")

    def readings(self, found: list[Piece], strange: Sequence[int]) -> Iterator[Parsed]:
        """What it means as it stands, else with its typos repaired, else with its one unknown word guessed."""
        for variant in variants(found, self.lexer.vocabulary):
            yield from self.read(variant)
        if self.asked:
            yield from self.read([*SUPPOSED, *found])
        # Where reading broke off before the first strange word, another word in its place cannot help.
        if 0 < len(strange) <= MOST_REPAIRED and strange[0] <= self.reached:
            yield from self.repaired(found, strange, likely=True)
            unknown = {found[at].text for at in strange if not found[at].capital}
            if len(unknown) <= 1:  # names with a capital are known
                yield from self.read(found, guessing=True)
            yield from self.repaired(found, strange, likely=False)

    def repaired(
        self, found: list[Piece], strange: Sequence[int], likely: bool
    ) -> Iterator[Parsed]:
        """What it means with its typos repaired, if that can be one thing only; one strange word may be no typo."""
        readings: list[Parsed] = []
        for variant, repaired in self.corrected(found, strange, likely):
            if self.attempts.words > MOST_READ:
                return  # what was not tried might be meant as well
            guessing = len(repaired) < len(strange)
            readings += self.read(variant, guessing, repaired)
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
            forest = self.attempts.forest(self.lexer.tokens(found, guessing))
        except BrokenOffError as error:
            self.reached = max(self.reached, error.at)
            return
        made = [
            (alist, tree, *meant)
            for tree in Ranking(self.cost, {}).best(forest)
            if holds(tree, self.attempts.derive)
            if (meant := _built(alist := to_alist(tree, self.text))) is not None
            if not (self.asked and meant[0] in STATED)
        ]
        for alist, tree, kind, meaning in made[:1]:
            others = tuple(other for other, *_ in made[1:])
            yield Parsed(
                self.text,
                kind,
                meaning,
                alist,
                tree.guessed(),
                repaired,
                len(made),
                others,
                trees=tuple(tree for _, tree, *_ in made),
            )

    def corrected(
        self, found: list[Piece], places: Sequence[int], likely: bool
    ) -> Iterator[tuple[list[Piece], tuple[tuple[str, str], ...]]]:
        """The sentence with its strange words replaced by near ones; at most one that has none stays."""
        known, literal = self.lexer.vocabulary, self.lexer.literal
        words = tuple({*known.everything, *literal})
        builders = {word for word in literal if not known.readings(word)}
        choices: list[list[Piece]] = [found]
        for at in places:
            plain = re.sub("[^a-z]", "", found[at].text)
            damaged = plain != found[at].text and plain in words
            near = [plain] if damaged else near_words(found[at].text, words, builders)
            if not near:
                near = near_words(found[at].text, words, builders, likely=False) or [found[at].text]
                near = [] if likely and near != [found[at].text] else near
            choices = [
                [*done[:at], Piece("word", word, found[at].begin, found[at].end), *done[at + 1 :]]
                for done in choices
                for word in near
            ]
        for variant in choices[:MOST_REPAIRS]:
            typed = ((found[at].text, variant[at].text) for at in places)
            repaired = tuple(pair for pair in typed if pair[0] != pair[1])
            if repaired and len(repaired) >= len(places) - 1:
                yield variant, repaired

    def understood(self, found: Sequence[Piece]) -> str:
        """The beginning of the sentence that could start a sentence."""
        return self.text[: found[min(self.reached, len(found)) - 1].end] if self.reached else ""


def _built(sentence: AList) -> tuple[str, Meaning] | None:
    """Kind and meaning of a reading; None where the net has no room for it."""
    if any(part.name == "quote" and not part.value for part in sentence.walk()):
        return None
    if is_waiting_for_way(sentence):
        return None
    forms = discover()
    body = next(part for part in sentence if part.name in forms)
    form, body = forms[body.name], neither(body)
    if form.kind in LESSONS and any(map(is_of_persons, body.walk())):
        return None
    try:
        if is_single(body) and not body.has("several"):
            return form.kind, form.build(body)
        meant = [form.build(one) for one in alternatives(body)]
        asked = [meaning for meaning in meant if isinstance(meaning, Question)]
        if len(asked) == len(meant) == 2:  # "did you turn left or right"
            return form.kind, one_of(*asked)
    except NoMeaningError:
        return None
    taught = [meaning for meaning in meant if isinstance(meaning, Teach)]
    return (form.kind, together(taught)) if len(taught) == len(meant) else None
