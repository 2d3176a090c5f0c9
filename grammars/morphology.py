"""Forms of English words: a table of irregular ones, rules for the rest, in both directions.

No lexicon is needed: `readings` proposes every word that the rules would inflect to the given form, likeliest first, so
a caller with a vocabulary takes the first it knows and one without takes the first. Two-word verbs ("pick up") are
inflected on their first word; hyphens are letters like others ("cha-chaing").
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import lru_cache
from typing import Final, Literal

Category = Literal["verb", "noun", "adjective", "adverb"]
Form = Literal[
    "base", "third", "past", "participle", "gerund", "plural", "comparative", "superlative"
]

_VERBS: Final = """
be was been; have had had; do did done; go went gone; say said said; make made made; get got got
give gave given; take took taken; come came come; see saw seen; know knew known
think thought thought; tell told told; find found found; feel felt felt; leave left left
put put put; keep kept kept; let let let; begin began begun; show showed shown; hear heard heard
run ran run; hold held held; bring brought brought; write wrote written; sit sat sat
stand stood stood; lose lost lost; pay paid paid; meet met met; lead led led; speak spoke spoken
read read read; grow grew grown; fall fell fallen; send sent sent; build built built
understand understood understood; draw drew drawn; break broke broken; spend spent spent
cut cut cut; rise rose risen; drive drove driven; buy bought bought; wear wore worn
choose chose chosen; throw threw thrown; catch caught caught; win won won; forget forgot forgotten
teach taught taught; sing sang sung; ring rang rung; swim swam swum; drink drank drunk
eat ate eaten; fly flew flown; sleep slept slept; wake woke woken; fight fought fought
sell sold sold; shake shook shaken; ride rode ridden; hide hid hidden; hit hit hit; hurt hurt hurt
shut shut shut; set set set; spin spun spun; stick stuck stuck; sweep swept swept
swing swung swung; slide slid slid; shoot shot shot; shine shone shone; steal stole stolen
swear swore sworn; tear tore torn; bite bit bitten; blow blew blown; bend bent bent; lend lent lent
lie lay lain; lay laid laid; light lit lit; deal dealt dealt; mean meant meant; dig dug dug
hang hung hung; creep crept crept; feed fed fed; freeze froze frozen; spread spread spread
split split split; wind wound wound; undo undid undone; redo redid redone; quit quit quit
weep wept wept; cost cost cost
"""
_NOUNS: Final = """
person people; man men; woman women; child children; foot feet; tooth teeth; mouse mice
goose geese; ox oxen; knife knives; wife wives; life lives; half halves; shelf shelves; leaf leaves
wolf wolves; thief thieves; loaf loaves; calf calves; self selves; elf elves; scarf scarves
potato potatoes; tomato tomatoes; hero heroes; echo echoes; torpedo torpedoes; sheep sheep; percent percent
fish fish; deer deer; series series; scissors scissors; pants pants; trousers trousers; lens lenses
gas gases; quiz quizzes; fireman firemen; policeman policemen; grandchild grandchildren
postman postmen; advil advil; music music; news news; furniture furniture; inch inches; bus buses
plus pluses; yes yeses; james james
"""
_ADJECTIVES: Final = """
good better best; bad worse worst; far farther farthest; far further furthest; little less least; many more most
"""
# Verbs of several syllables whose last one is stressed, so that the consonant doubles.
_DOUBLING: Final = "begin forget refer prefer admit regret occur permit commit control patrol unplug reset rerun equip"
_VOWELS: Final = "aeiou"
# Words whose first letter is not their first sound.
_AN: Final = re.compile(r"hour|honest|hono|heir|8|1[18]\b")
_A: Final = re.compile(r"uni(?![nmd])|use|usu|euro|one\b|once|uk|ufo")


def _table(text: str) -> list[tuple[str, ...]]:
    """Rows of a table in the text form above: entries end at a semicolon or a line."""
    return [tuple(row.split()) for row in re.split(r"[;\n]", text) if row.strip()]


_PAST: Final = {row[0]: row[1] for row in _table(_VERBS)}
_PARTICIPLE: Final = {row[0]: row[2] for row in _table(_VERBS)}
_THIRD: Final = {
    "be": "is",
    "have": "has",
    "do": "does",
    "go": "goes",
    "undo": "undoes",
    "redo": "redoes",
}
_GERUND: Final = {
    "be": "being", "die": "dying", "lie": "lying", "tie": "tying", "dye": "dyeing", "quit": "quitting",
    "untie": "untying", "picnic": "picnicking", "panic": "panicking",
}  # fmt: skip
_PLURAL: Final = {row[0]: row[1] for row in _table(_NOUNS)}
_COMPARATIVE: Final = {row[0]: row[1] for row in reversed(_table(_ADJECTIVES))}
_SUPERLATIVE: Final = {row[0]: row[2] for row in reversed(_table(_ADJECTIVES))}
_FURTHER: Final[dict[str, tuple[str, Form]]] = {
    "am": ("be", "third"), "are": ("be", "third"), "were": ("be", "past"),
    "further": ("far", "comparative"), "furthest": ("far", "superlative"),
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Reading:
    """One way to read a word: the form `form` of `lemma`."""

    lemma: str
    form: Form


def _first_word(inflect: Callable[[str], str]) -> Callable[[str], str]:
    """Inflect the first word of a phrase and leave its particle."""

    @lru_cache(maxsize=4096)
    def inflected(phrase: str) -> str:
        word, blank, particle = phrase.partition(" ")
        return inflect(word) + blank + particle

    inflected.__doc__, inflected.__name__ = inflect.__doc__, inflect.__name__
    return inflected


def _doubles(word: str) -> bool:
    """True where the last consonant is doubled before -ing, -ed, -er: one vowel, one consonant, stressed."""
    if word in _DOUBLING.split():
        return True
    syllables = re.findall(r"[aeiouy]+", word.rpartition("-")[2].replace("qu", "q"))
    ends = re.search(r"(?:^|[^aeiou]|qu)[aeiouy][^aeiouywx]$", word)
    return len(syllables) == 1 and ends is not None


def _sibilant(word: str) -> bool:
    return word.endswith(("s", "x", "z", "ch", "sh"))


def _with_s(word: str) -> str:
    if _sibilant(word):
        return word + "es"
    if word.endswith("y") and word[-2:-1] not in ("", *_VOWELS):
        return word[:-1] + "ies"
    return word + "s"


def _with_ed(word: str) -> str:
    if word.endswith("e"):
        return word + "d"
    if word.endswith("y") and word[-2:-1] not in ("", *_VOWELS):
        return word[:-1] + "ied"
    return word + (word[-1] if _doubles(word) else "") + "ed"


@_first_word
def third_person(verb: str) -> str:
    """The verb as he does it: drives, carries, is."""
    return _THIRD.get(verb) or _with_s(verb)


@_first_word
def past(verb: str) -> str:
    """The verb as it was done: drove, turned."""
    return _PAST.get(verb) or _with_ed(verb)


@_first_word
def participle(verb: str) -> str:
    """The verb after "has" or "is": driven, turned."""
    return _PARTICIPLE.get(verb) or _with_ed(verb)


@_first_word
def gerund(verb: str) -> str:
    """The verb as a going-on: driving, cha-chaing."""
    if verb in _GERUND:
        return _GERUND[verb]
    if verb.endswith("e") and not verb.endswith(("ee", "ye", "oe")) and len(verb) > 2:
        return verb[:-1] + "ing"
    return verb + (verb[-1] if _doubles(verb) else "") + "ing"


def plural(noun: str) -> str:
    """Several of the noun; of a compound, of its last word: cereal boxes."""
    before, blank, word = noun.rpartition(" ")
    return before + blank + (_PLURAL.get(word) or _with_s(word))


def comparative(adjective: str) -> str:
    """The adjective before "than": bigger; "more beautiful" where -er does not serve."""
    return _COMPARATIVE.get(adjective) or _graded(adjective, "er", "more")


def superlative(adjective: str) -> str:
    """The adjective after "the", of all: biggest; "most beautiful" where -est does not serve."""
    return _SUPERLATIVE.get(adjective) or _graded(adjective, "est", "most")


def _graded(adjective: str, ending: str, word: str) -> str:
    syllables = len(re.findall(r"[aeiouy]+", re.sub(r"e$", "", adjective)))
    if (
        " " in adjective
        or syllables > 2
        or (syllables == 2 and not adjective.endswith(("y", "le", "ow", "er")))
    ):
        return f"{word} {adjective}"
    return _with_ed(adjective).removesuffix("ed") + ending


def article(phrase: str) -> Literal["a", "an"]:
    """The indefinite article for what follows: an hour, a unicorn, an old box."""
    word = phrase.lower().partition(" ")[0]
    if _AN.match(word):
        return "an"
    return "an" if word[:1] in (*_VOWELS,) and not _A.match(word) else "a"


def with_article(phrase: str) -> str:
    """The phrase behind its indefinite article."""
    return f"{article(phrase)} {phrase}"


_GENERATE: Final[dict[Form, Callable[[str], str]]] = {
    "third": third_person, "past": past, "participle": participle, "gerund": gerund,
    "plural": plural, "comparative": comparative, "superlative": superlative,
}  # fmt: skip
_FORMS: Final[dict[Category, tuple[Form, ...]]] = {
    "verb": ("third", "gerund", "past", "participle"),
    "noun": ("plural",),
    "adjective": ("comparative", "superlative"),
    "adverb": (),
}
_ENDINGS: Final[dict[Form, str]] = {
    "third": "s", "past": "ed", "participle": "ed", "gerund": "ing",
    "plural": "s", "comparative": "er", "superlative": "est",
}  # fmt: skip


def _reverse() -> dict[tuple[str, Form], list[str]]:
    """Irregular form to its lemmas."""
    found: dict[tuple[str, Form], list[str]] = {}
    tables: tuple[tuple[Form, dict[str, str]], ...] = (
        ("past", _PAST), ("participle", _PARTICIPLE), ("third", _THIRD), ("gerund", _GERUND),
        ("plural", _PLURAL), ("comparative", _COMPARATIVE), ("superlative", _SUPERLATIVE),
    )  # fmt: skip
    for form, table in tables:
        for lemma, inflected in table.items():
            found.setdefault((inflected, form), []).append(lemma)
    for inflected, (lemma, form) in _FURTHER.items():
        found.setdefault((inflected, form), []).append(lemma)
    return found


_IRREGULAR: Final = _reverse()
_BASES: Final = {"verb": _PAST, "noun": _PLURAL, "adjective": _COMPARATIVE, "adverb": {}}
# A stem that ends so has lost an e: driv, danc, rotat, wiggl.
_LOST_E: Final = re.compile(
    r"(?:[vcuz]|[^s]s|dg|rg|[bcdfgkptz]l|[^aeiou]ir|[a-z]{2,}[^aeiou][au]t|[^aeiou]{1,2}[aiou][kmnpbdrl])$"
)


def _stems(word: str, form: Form) -> Iterable[str]:
    """Words that may have been inflected to `word`, the likeliest first."""
    ending = _ENDINGS[form]
    if not word.endswith(ending):
        return ()
    stem = word.removesuffix(ending)
    if ending == "s":
        with_y = [stem.removesuffix("ie") + "y"] if stem.endswith("ie") else []
        bare = stem.removesuffix("e")
        es_first = bare.endswith(("x", "ch", "sh", "ss", "zz"))
        return [*with_y, *((bare, stem) if es_first else (stem, bare))]
    single = [stem[:-1]] if len(stem) > 2 and stem[-1] == stem[-2] else []
    with_y = [stem.removesuffix("i") + "y"] if stem.endswith("i") and ending != "ing" else []
    whole = [stem + "e", stem] if _LOST_E.search(stem) else [stem, stem + "e"]
    kept_double = stem.endswith(("ll", "ss", "ff", "zz"))
    return [*with_y, *((*whole, *single) if kept_double else (*single, *whole))]


@lru_cache(maxsize=8192)
def readings(word: str, category: Category) -> tuple[Reading, ...]:
    """Every reading of a lower-case word in that category, likeliest first.

    The word as its own lemma is always among them: first where the tables know it as one, else last.
    """
    word, blank, particle = word.partition(" ")
    found: list[Reading] = []
    if category == "adverb" and word.endswith("wards") and len(word) > 6:
        return (Reading(word.removesuffix("s"), "base"),)
    for form in _FORMS[category]:
        irregular = _IRREGULAR.get((word, form), [])
        found.extend(Reading(lemma, form) for lemma in irregular)
        found.extend(
            Reading(stem, form)
            for stem in _stems(word, form)
            if len(stem) > 1 and _GENERATE[form](stem) == word
        )
    itself = Reading(word, "base")
    found.insert(0 if word in _BASES[category] else len(found), itself)
    return tuple(Reading(r.lemma + blank + particle, r.form) for r in dict.fromkeys(found))


def lemmas(word: str, category: Category) -> tuple[str, ...]:
    """The lemmas of `readings`, each once: lemmas("driving", "verb")[0] is "drive"."""
    return tuple(dict.fromkeys(reading.lemma for reading in readings(word, category)))
