"""Words and their categories. A category is a terminal of the grammar; a word may be in several.

What the robot is born with stands in `words/*.txt`; what it is taught is added by `from_policy`, without copying, so
that the size of the lexicon costs nothing.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property
from importlib.resources import files
from itertools import product
from typing import Final

from grammars import morphology
from kernel.memory.lesson import Lesson, Rule, graphlets
from kernel.net.graphlet import Term

Readings = dict[str, str]  # category: lemma
Lexicon = dict[str, Readings]

OPEN: Final = ("VERB", "NOUN", "NOUNS", "ADJ", "ADV", "DIR", "PROPER", "STATE", "VERBING")


def lines(name: str) -> Iterator[str]:
    """Lines of a word file without comments."""
    text = files("grammars").joinpath("words", f"{name}.txt").read_text(encoding="utf8")
    for line in text.splitlines():
        if line.strip() and not line.startswith("#"):
            yield line.strip()


def _entries(name: str) -> Iterator[tuple[str, str]]:
    """Word and lemma of a file of `word` or `word=lemma` entries."""
    for line in lines(name):
        for entry in line.split():
            word, _, lemma = entry.partition("=")
            yield word, lemma or word


def _add(lexicon: Lexicon, word: str, category: str, lemma: str) -> None:
    lexicon.setdefault(word, {}).setdefault(category, lemma)


def _verb(lexicon: Lexicon, verb: str) -> None:
    _add(lexicon, verb, "VERB", verb)
    _add(lexicon, morphology.third_person(verb), "VERBS", verb)
    _add(lexicon, morphology.gerund(verb), "VERBING", verb)
    _add(lexicon, morphology.past(verb), "VERBED", verb)
    _add(lexicon, morphology.participle(verb), "VERBED", verb)


def _state(lexicon: Lexicon, verb: str) -> None:
    _add(lexicon, verb, "STATE", verb)
    _add(lexicon, morphology.third_person(verb), "STATES", verb)
    _add(lexicon, morphology.gerund(verb), "VERBING", verb)
    _add(lexicon, morphology.past(verb), "VERBED", verb)
    _add(lexicon, morphology.participle(verb), "VERBED", verb)


def _noun(lexicon: Lexicon, noun: str) -> None:
    _add(lexicon, noun, "NOUN", noun)
    _add(lexicon, morphology.plural(noun), "NOUNS", noun)


def _adjective(lexicon: Lexicon, adjective: str) -> None:
    _add(lexicon, adjective, "ADJ", adjective)
    if adjective in ungraded():
        return
    for form, category in (("comparative", "ADJER"), ("superlative", "ADJEST")):
        word = getattr(morphology, form)(adjective)
        if " " not in word:
            _add(lexicon, word, category, adjective)


@cache
def ungraded() -> frozenset[str]:
    """What nothing is more than something else: "done", "teal"."""
    return frozenset(word for line in lines("ungraded") for word in line.split())


def set_phrases() -> dict[str, tuple[str, ...]]:
    """Category to the phrases in it, from `words/phrases.txt`; parts in angle brackets written out."""
    parts: dict[str, list[str]] = {}
    for line in lines("phrases"):
        name, _, body = line.partition("=")
        found = parts.setdefault(name.strip(), [])
        for phrase in body.split("|"):
            pieces = [parts[w[1:-1]] if w.startswith("<") else [w] for w in phrase.split()]
            found += [" ".join(words) for words in product(*pieces)]
    return {name: tuple(found) for name, found in parts.items() if name.isupper()}


def _born() -> Lexicon:
    lexicon: Lexicon = {}
    for category, phrases in set_phrases().items():
        for phrase in phrases:
            _add(lexicon, phrase, category, phrase)
            for word in phrase.split():
                lexicon.setdefault(word, {})
    for files_of, add in (
        ("verbs", _verb),
        ("states", _state),
        ("nouns", _noun),
        ("persons", _noun),
    ):
        for word, _ in _entries(files_of):
            add(lexicon, word)
    for word, lemma in _entries("adjectives"):
        _adjective(lexicon, word)
        lexicon[word]["ADJ"] = lemma
    for category, name in (
        ("DIR", "directions"),
        ("SIDE", "sides"),
        ("ADV", "manners"),
        ("DEG", "degrees"),
        ("UNIT", "units"),
        ("PREP", "prepositions"),
        ("PROPER", "names"),
        ("PROPER", "places"),
        ("PLACE", "places"),
        ("PERSON", "persons"),
        ("ORD", "ordinals"),
        ("GIVE", "givers"),
        ("MOTION", "motions"),
    ):
        for word, lemma in _entries(name):
            _add(lexicon, word, category, lemma)
    return lexicon


@dataclass(frozen=True)
class Vocabulary:
    """Words the robot knows.

    Attributes:
        born: words by category, shared by all vocabularies.
        taught: words of lessons.
    """

    born: Mapping[str, Readings] = field(default_factory=_born, repr=False)
    taught: Mapping[str, Readings] = field(default_factory=dict)

    def readings(self, word: str) -> Readings:
        """Categories of a word, each with its lemma; empty for a word nobody taught."""
        known, more = self.born.get(word, {}), self.taught.get(word)
        return {**known, **more} if more else dict(known)

    def knows(self, word: str) -> bool:
        """The word has a category."""
        return word in self.born or word in self.taught

    def words(self, category: str) -> frozenset[str]:
        """Every word of a category, as it may be said."""
        return frozenset(
            word
            for lexicon in (self.born, self.taught)
            for word, readings in lexicon.items()
            if category in readings
        )

    @cached_property
    def everything(self) -> tuple[str, ...]:
        """All words, sorted."""
        return tuple(sorted(word for word in {*self.born, *self.taught} if " " not in word))

    @cached_property
    def taught_phrases(self) -> tuple[tuple[str, ...], ...]:
        """Taught verbs of several words, longest first."""
        phrases = (tuple(word.split()) for word in self.taught if " " in word)
        return tuple(sorted(phrases, key=lambda words: (-len(words), words)))


BORN: Final = Vocabulary()


def from_policy(lessons: Iterable[Lesson]) -> Vocabulary:
    """The vocabulary after these lessons: what they mention, in the category they mention it in."""
    taught: Lexicon = {}
    for lesson in lessons:
        for graphlet in graphlets(lesson.content):
            for term in graphlet:
                for word in term.lex:
                    if " " not in word:
                        _teach(taught, word, term)
                    elif term.kind in ("act", "obj"):
                        _add(taught, word, "VERB" if term.kind == "act" else "PROPER", word)
        if lesson.kind == "alias" and isinstance(lesson.content, Rule):
            _alias(taught, lesson.content)
    return Vocabulary(BORN.born, taught)


def with_verb(vocabulary: Vocabulary, word: str) -> Vocabulary:
    """The vocabulary with one more word for something to do, which nobody has told how yet."""
    lexicon: Lexicon = {word: dict(vocabulary.taught.get(word, {}))}
    _verb(lexicon, word)
    return Vocabulary(vocabulary.born, {**lexicon, **vocabulary.taught, word: lexicon[word]})


def extended(vocabulary: Vocabulary, lessons: Iterable[Lesson]) -> Vocabulary:
    """The vocabulary with the words of further lessons; the same object where they bring none.

    Words of forgotten lessons stay until the next start: "I don't know how to salute" says more than "I don't know the
    word salute", and a lesson costs the same however many there are.
    """
    new = {
        word: readings
        for word, readings in from_policy(lessons).taught.items()
        if readings.keys() - vocabulary.readings(word).keys()
    }
    if not new:
        return vocabulary
    known = vocabulary.taught
    merged = {word: {**readings, **known.get(word, {})} for word, readings in new.items()}
    return Vocabulary(vocabulary.born, {**known, **merged})


def _teach(taught: Lexicon, word: str, term: Term) -> None:
    """Add the word in the category of its term, unless it is there already."""
    roles = {role for role, _ in term.links}
    for role, kind, category, add in (
        ("ako", "ako", "NOUN", _noun),
        ("hq", "hq", "ADJ", _adjective),
        ("", "act", "VERB", _verb),
    ):
        if role in roles or (term.kind == kind and not roles & {"ako", "hq", "dir", "mod"}):
            known = BORN.born.get(word, {})
            if category not in known and not (category == "VERB" and "STATE" in known):
                add(taught, word)
            return
    category = "DIR" if "dir" in roles else "ADV" if "mod" in roles else ""
    if term.kind == "obj":
        category = "PROPER" if word not in ("you", "me") else ""
    elif term.kind in ("dir", "mod"):
        category = "DIR" if term.kind == "dir" else "ADV"
    if category and category not in BORN.born.get(word, {}):
        _add(taught, word, category, word)


def _alias(taught: Lexicon, rule: Rule) -> None:
    """A word of unknown category that means a known one has the known one's categories."""
    for new in rule.condition.words():
        for old in rule.conclusion.words():
            for category, _ in BORN.readings(old).items():
                if not BORN.knows(new) and category in OPEN and not taught.get(new):
                    _teach(
                        taught, new, Term({"VERB": "act-1", "DIR": "dir-1"}.get(category, "x-1"))
                    )
