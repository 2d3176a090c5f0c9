"""Sorts of things and classes of verbs: what a noun phrase tells of, and what is said of such.

The classes of verbs are in `words/usage.txt`, what can be neither handled nor owned in `words/abstract.txt`.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Final

from grammars.alist import AList
from grammars.morphology import lemmas
from grammars.vocabulary import BORN, lines

ABSTRACT_ENDINGS: Final = ("ness", "ity", "tude", "hood", "ism", "tion", "sion")
SHORTEST_ABSTRACT: Final = 7  # letters; a city is none
SEVERAL: Final = ("these", "those")
ONE: Final = ("a", "an", "another", "this", "that")
COMPLEMENTS: Final = ("of", "for", "about", "with", "at", "to")
ROBOT: Final = "robot"
HERE: Final = frozenset(("here", "there"))
POSITIONS: Final = frozenset(("up", "down", "on", "off"))
TURNED: Final = POSITIONS | {"left", "right"}
NEARNESS: Final = ("close", "near", "next")
LEARNED: Final = ("learn", "know", "say", "tell", "teach", "hear", "think", "forget")
NOBODY: Final = frozenset(("nothing", "nobody", "no one"))
EITHER: Final = (
    "any of",
    "any one of",
    "either of",
    "either one of",
)  # which one it is, nobody says
NONE: Final = ("no", "no more", "neither", "none of", "neither of")
DETERMINED: Final = ("det", "own", "owner", "pron", "pronoun", "vague", "name")


@cache
def usages(verb: str) -> frozenset[str]:
    """Classes of the verb; what is picked up in no direction is not picked in one, either."""
    head, _, particle = verb.partition(" ")
    taken = ("taking",) if verb == "pick up" else ()
    names = ("still", *taken) if particle else classes()
    return frozenset(name for name in names if head in classes()[name])


@cache
def classes() -> dict[str, frozenset[str]]:
    """The words of each class."""
    found: dict[str, set[str]] = {}
    for line in lines("usage"):
        name, _, verbs = line.partition("=")
        found.setdefault(name.strip(), set()).update(verbs.split())
    return {name: frozenset(verbs) for name, verbs in found.items()}


@cache
def persons_own() -> frozenset[str]:
    """What "your" is said of to persons alone."""
    return frozenset(word for line in lines("persons_own") for word in line.split())


@cache
def abstract_words() -> frozenset[str]:
    """What can be neither handled nor owned."""
    return frozenset(word for line in lines("abstract") for word in line.split())


def is_said_to_persons(np: AList) -> bool:
    """ "Your mother", "your hat": of what the robot has not, or does not give."""
    return np.slot("own") == "your" and kind(np) in persons_own()


def is_of_persons(np: AList) -> bool:
    """ "Your breath", "your seats": what the robot has none of; its friends it may have, and a hat."""
    if np.name != "np" or np.slot("own") != "your" or is_people(np):
        return False
    said = kind(np)
    one = said if BORN.knows(said) and not np.has("akos") else lemmas(said, "noun")[0]
    several = np.has("akos") and one in classes()["belongings"]
    return several or (
        one in persons_own() and one not in (classes()["belongings"] | classes()["furniture"])
    )


def is_kin_of_yours(np: AList) -> bool:
    """ "Your cousin": of whom persons ask each other."""
    return np.slot("own") == "your" and kind(np) in classes()["kin"]


def kind(np: AList) -> str:
    """What a thing is called, or ""."""
    return np.slot("ako") or np.slot("akos")


def is_people(np: AList) -> bool:
    """It tells of persons, by what they are called as such: a girl, doctors."""
    return "PERSON" in BORN.readings(kind(np))


def is_abstract(np: AList) -> bool:
    """It tells of nothing that could be handled or owned."""
    said = kind(np)
    if said == "step" and any(qual.has("ord") for qual in np.all("qual")):  # "the last step"
        return True
    if any(verb.value in LEARNED for rel in np.all("rel") for verb in rel.walk()):
        return True  # "everything you learned"
    one = said if BORN.knows(said) else lemmas(said, "noun")[0]
    ending = len(one) >= SHORTEST_ABSTRACT and one.endswith(ABSTRACT_ENDINGS)
    return not abstract_words().isdisjoint((said, one)) or (ending and not BORN.knows(one))


def is_bare(np: AList) -> bool:
    """It has no article, or what would stand for one."""
    return not any(np.has(part) for part in DETERMINED)


def is_between_one(loc: AList) -> bool:
    """ "Between Maureen": it takes two."""
    first, *others = loc.all("np") or [loc]
    single = not others and not first.has("num") and (first.has("name") or first.has("ako"))
    return loc.slot("prep") == "between" and single


def is_superlative(np: AList) -> bool:
    """The most so of all: "biggest block" is the biggest block."""
    return is_bare(np) and any(qual.has("most") or qual.has("most_of") for qual in np.all("qual"))


def is_nothing(np: AList) -> bool:
    """ "Nothing", "no block", "neither of the blocks"."""
    return np.slot("vague") in NOBODY or np.slot("det") in NONE


def agrees(np: AList) -> bool:
    """ "A blocks" and "those block" are said by nobody."""
    det = np.slot("det")
    if np.slot("sub") and np.slot("sub") == kind(np):  # "a block block"
        return False
    quals = {qual.slot("hq") for qual in np.all("qual")}
    most = any(qual.has("most") for qual in np.all("qual"))
    if np.has("vague") and (most or quals & TURNED or _is_part_of_one(np)):
        return False  # "something up", "something stickiest"
    if not np.has("vague") and quals & classes()["predicative"]:
        return False
    if is_bare(np) and np.has("ako") and any(qual.has("more") for qual in np.all("qual")):
        return False  # "farther gripper"
    switched = kind(np) in classes()["switches"]
    if is_bare(np) and (quals & HERE or (quals & POSITIONS and not switched)):
        return False  # "are there red blocks" asks of no "there blocks", nor "run on batteries" of "on batteries"
    if np.has("akos") and any(rel.has("name") for rel in np.all("rel")):  # "suits called Tommy"
        return False
    if _is_order(np.slot("sub")) and kind(np) not in classes()["signs"]:
        return False  # "the stop sign", and no "go kitchen"
    if np.slot("sub") in classes()["devices"] and kind(np) not in classes()["fittings"]:
        return not BORN.knows(kind(np))  # "the gripper motor", and no "lift juice"
    if kind(np) == ROBOT and np.has("sub") and np.slot("sub") not in classes()["robots"]:
        return False  # "pick up the block, robot"
    if np.has("numbered") and kind(np) not in classes()["numbered"]:  # "page two"
        return False
    return not (det in ONE and np.has("akos")) and not (det in SEVERAL and np.has("ako"))


def _is_part_of_one(np: AList) -> bool:
    """ "Something of the green box": of things it is told what part."""
    owners = [owner for rel in np.all("rel") for owner in rel.all("of_owner")]
    return any(
        not is_people(whose) and not whose.has("name")
        for owner in owners
        for whose in owner.all("np")
    )


def _is_order(word: str) -> bool:
    """It is known as something to do, and as no thing."""
    readings = BORN.readings(word)
    return "VERB" in readings and "NOUN" not in readings


def may_be_called(np: AList) -> bool:
    """It may have the name of a person: no "light" is Janey."""
    said = kind(np)
    if is_bare(np) and np.has("ako"):  # "name is Freddy"
        return False
    named = not BORN.knows(said) or is_abstract(np) or said in classes()["named"]
    return named or is_people(np)


def is_kind_of_it(np: AList, kindof: AList) -> bool:
    """ "The light is toads" is said by nobody; "something is scissors" may be."""
    if is_people(kindof) and kind(np) in classes()["parts"]:  # "the gripper is Janey's brother"
        return False
    several = kindof.slot("akos") if not kindof.has("own") and not kindof.has("owner") else ""
    return (
        not several or not (np.has("ako") or np.has("vague")) or "NOUNS" in BORN.readings(several)
    )


def is_attribute(word: str) -> bool:
    """Something has it: a color, and no burrito."""
    known = BORN.knows(word) and word not in abstract_words()
    return not known or word in classes()["attributes"]


def may_regard(pred: AList) -> bool:
    """The quality may regard something: "afraid of dogs", and not "empty of you"."""
    loc, qual = pred.find("loc"), pred.first("qual")
    word = qual.slot("hq")
    if qual.has("most") or qual.has("most_of"):  # "the tallest of the boys"
        near = qual.slot("most") in NEARNESS
        return loc is None or loc.slot("prep") == "of" or (near and loc.slot("prep") == "to")
    if loc is not None and _is_somewhere(word, loc):
        return True
    if loc is not None and loc.slot("prep") not in COMPLEMENTS:
        return False
    if loc is None or any(deg.value == "too" for deg in qual.all("deg")):  # "too heavy for you"
        return True
    if word in NEARNESS and loc.slot("prep") != "to":
        return False  # "close about the block"
    return not BORN.knows(word) or word in classes()["regarding"]


def _is_somewhere(quality: str, loc: AList) -> bool:
    """ "Parked behind the house", "awake at the desk"; "cold in the cellar", and not "in winter"."""
    of_place = loc.slot("prep") not in COMPLEMENTS or loc.slot("prep") == "at"
    weather = quality in classes()["ambient"] and not any(map(is_bare, loc.all("np")))
    return of_place and (quality in classes()["placed"] or weather)


def is_graded(quality: str, degrees: Sequence[str]) -> bool:
    """There may be so much of it: nothing is "very up", or "very too far"."""
    placed = quality in TURNED | HERE
    return not ("very" in degrees and placed) and list(degrees) != ["very", "too"]


def is_recited(np: AList) -> bool:
    """A text, or it may be one: nobody recites sweaters or repeats a block."""
    if np.has("one"):  # "the last one", and not "the red one"
        return not any(qual.slot("hq") for qual in np.all("qual"))
    known = (np.has("name") and not is_country(np)) or BORN.knows(kind(np))
    return not known or is_abstract(np) or kind(np) in classes()["texts"]


def is_country(np: AList) -> bool:
    """It names a place, or a language, which nobody handles: "stop Ireland"."""
    called = np.slot("name")
    return "PLACE" in BORN.readings(called) and called not in classes()["brands"]


def may_receive(np: AList) -> bool:
    """Something is given to somebody in particular, or to people: "give people flowers", and not "give walls paint"."""
    if is_country(np):
        return False
    if is_bare(np) and np.has("one"):  # "get ones"
        return False
    return not is_bare(np) or not BORN.knows(kind(np)) or is_people(np)
