"""What was mentioned in a sentence, and the words that tell persons, places and pronouns apart."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from grammars.alist import AList
from grammars.errors import NoMeaningError
from grammars.morphology import gerund
from grammars.sorts import (
    EITHER,
    classes,
    is_abstract,
    is_bare,
    is_nothing,
    is_people,
    is_said_to_persons,
    kind,
)
from grammars.usage import TIMES_OF_DAY
from grammars.vocabulary import BORN

SELF: Final = {"you": "you", "yourself": "you", "me": "me", "i": "me", "mine": "me", "yours": "you"}
SELF_OWN: Final = {"my": "me", "your": "you", "mine": "me", "yours": "you"}
OWNING: Final = {
    "his": "he",
    "her": "she",
    "its": "it",
    "their": "they",
    "our": "we",
    "hers": "she",
    "theirs": "they",
    "ours": "we",
}
ALIKE: Final = {"him": "he", "her": "she", "them": "they", "these": "this", "those": "that"}
ASKING: Final = frozenset(
    "who what where when why how which whose may can could will would shall should is are do does did".split()
)
# "Don't tell him that or he will cry", "tell Mary about it".
CONJUNCTIONS: Final = ("or", "but", "because", "about", "of")
VAGUE: Final = (["nothing"], ["anything"], ["something"], ["everything"])  # nobody says just that
UNADDRESSED: Final = ("you", "that", "this", "these", "those", "i", "he", "she", "they")
FINITE: Final = frozenset("is are was were has may can will must should does did".split())
# The speaker and who is with him.
US: Final = ("me", "us")
PERSONAL: Final = frozenset("him her he she".split())
OF_WOMEN: Final = frozenset(("she", "her"))
PERSON_WORDS: Final = frozenset(
    "someone somebody anyone anybody nobody whoever everybody everyone".split()
) | {
    "someone else",
    "anyone else",
    "anybody else",
    "somebody else",
    "no one",
}
EVERY: Final = frozenset(("everybody", "everyone", "everything"))  # each of them
_NAMES_OF_WOMEN: Final = """
mary janey mom jane sue ann anna anne alice emma olivia sophia emily elizabeth sarah sally susan lucy molly nancy
grandma mommy
"""
WOMEN: Final = frozenset(_NAMES_OF_WOMEN.split())
_FEMALE: Final = (
    frozenset("girl woman mother sister daughter aunt grandmother wife niece".split()) | WOMEN
)
_MALE: Final = frozenset("boy man father brother son uncle grandfather husband nephew".split())
ANY_KIND: Final = frozenset(("thing", "object", "item", "stuff"))
REFS: Final = {
    "whichever": "the",
    "the": "the",
    "this": "this",
    "that": "that",
    "these": "this",
    "those": "that",
}
GROUPING: Final = ("both", "all", "neither", "neither of", "none of")
VERB_SLOTS: Final = ("does", "gerund", "state", "states", "verb", "verbs")
DEGREES: Final = {"all the way": "fully", "a little": "little", "a bit": "little"}
PLACES: Final = {
    "to the left of": "left of",
    "on the left of": "left of",
    "on the left side of": "left of",
    "to the right of": "right of",
    "on the right of": "right of",
    "on the right side of": "right of",
    "close to": "near",
    "near to": "near",
    "beside": "next to",
    "inside": "in",
    "inside of": "in",
    "in back of": "behind",
    "underneath": "under",
    "beneath": "under",
    "on top of": "on",
}


@dataclass
class Thing:
    """Something mentioned, for later "it" and "the block".

    Attributes:
        name: of its node.
        kind: what it was called.
        person: it is one.
        called: its own name.
        aside: it only tells where something else is, or where to: a landmark.
    """

    name: str
    kind: str = ""
    person: bool = False
    called: str = ""
    aside: bool = False

    @property
    def settled(self) -> bool:
        """It is known whether it is a person; "something" may be either."""
        return self.person or bool(self.called or self.kind)

    def may_be(self, pronoun: str) -> bool:
        """Whether the pronoun can mean it: persons are he or she, things are it, they may be either."""
        if pronoun in ("they", "them") or not self.settled:
            return True
        if pronoun not in PERSONAL:
            return not self.person and not self.called
        wrong = _MALE if pronoun in OF_WOMEN else _FEMALE
        return self.person and not {self.kind, self.called} & wrong


def unlikely(thing: Thing, topic: str, grasping: bool) -> tuple[bool, bool, bool]:
    """How little it is what is spoken of, after how new it is: the robot grasps no part of its own, what a sentence is
    about is taken up again, landmarks are not."""
    return (grasping and thing.kind in classes()["parts"], thing.name != topic, thing.aside)


def degree(said: str) -> str:
    """The word for it in the net."""
    return DEGREES.get(said, said)


def compounded(np: AList) -> str:
    """What a noun is compounded with: "cereal" of a cereal box, "charging" of a charging station."""
    sub = np.find("sub")
    if sub is None:
        return ""
    return sub.value or gerund(sub.slot("gerund"))


def place_word(loc: AList) -> str:
    """The net's word for where something is: "next to" for beside."""
    word = loc.slot("prep") or ("between" if loc.has("between") else "for")
    return PLACES.get(word, word)


def is_time(loc: AList) -> bool:
    """When something is done, not where: "in the evening"."""
    return loc.has("np") and loc.first("np").slot("ako") in TIMES_OF_DAY


def somebody(where: AList) -> AList:
    """The noun phrase for who is at a place."""
    return AList("np", (AList("vague", value="somebody"), AList("rel", (where,))))


def is_definite(np: AList) -> bool:
    """The noun phrase is about something in particular."""
    return np.slot("det") in REFS or any(np.has(part) for part in ("name", "own", "owner"))


def is_group(np: AList) -> bool:
    """The noun phrase is about several in particular: "the cups", "my shoes", "both boxes", "neither cup"."""
    several = np.has("akos") and not np.has("one") and not any(map(_picks_one, np.all("qual")))
    one = np.slot("det") in (*EITHER, "one of")
    return (several and is_definite(np) and not one) or np.slot("det") in GROUPING


def _picks_one(qual: AList) -> bool:
    """ "The biggest of the cups", "the second of my boxes"."""
    return any(map(qual.has, ("more", "most", "most_of", "ord")))


def is_person(np: AList) -> bool:
    """The noun phrase names a person, or tells of one."""
    of_persons = np.slot("pron") in PERSONAL | {"them"} or np.slot("vague") in PERSON_WORDS
    return np.has("name") or of_persons or is_people(np)


def asked_if(speech: AList) -> AList | None:
    """What is to be asked with "if"; whom, is known where that is not the one who speaks: "ask if you need help"."""
    asked = speech.find("asked_if")
    if asked is not None and asked.slot("quote").startswith("you ") and not speech.has("listener"):
        raise NoMeaningError(str(speech))
    return asked


def is_addressed(verb: str, speech: AList) -> bool:
    """Somebody may be told so: neither the robot itself nor "lift", nor may "tell Mary may go" be meant.

    Args:
        verb: say, tell or ask.
        speech: its bracket, with a quote.
    """
    words = speech.slot("quote").lower().removeprefix("that ").split()
    if not words or words[0] in CONJUNCTIONS or words in VAGUE:
        return False
    listener, hearer = speech.find("listener"), speech.find("hearer")
    if verb == "ask" and listener is None:
        return words[0] in ASKING
    if listener is not None and (listener.slot("pron") or listener.value) in UNADDRESSED:
        return False
    if verb == "tell" and words[0] in FINITE:
        return False
    if hearer is None and is_greeting(words):
        return False
    np = None if hearer is None else hearer.find("np")
    if any(is_nothing(who) for who in (listener, np) if who is not None):
        return False
    every = None if hearer is None else hearer.find("every")
    if np is not None and any(rel.has("seen_by") for rel in np.all("rel")):
        return False  # "say to the children the bus leaves"
    if any(_is_at_home(rel) for who in (np, every) if who is not None for rel in who.all("rel")):
        return False
    if np is not None and is_said_to_persons(np):
        return False  # "say hello to your mother"
    return np is None or is_person(np) or not is_bare(np) or not BORN.knows(kind(np))


def is_greeting(words: list[str]) -> bool:
    """ "Say goodbye to stubborn stains": a greeting with somebody to be greeted, and no words to be said."""
    return words[1:2] == ["to"] and not BORN.readings(words[0]).keys().isdisjoint(("HELLO", "BYE"))


def _is_at_home(rel: AList) -> bool:
    """ "The people at home": not here."""
    places = [np for loc in rel.all("loc") for np in loc.all("np")]
    return any(kind(np) == "home" and is_bare(np) for np in places)


def may_be_person(np: AList) -> bool:
    """It may tell of a person, or of one who talks: not the rain, and nobody without an article or a name."""
    return not is_bare(np) and not is_abstract(np)


def but(left_out: AList) -> AList:
    """ "Except the blue one": that is not blue."""
    pred = left_out.find("pred") or AList("pred", (left_out.first("qual"),))
    return AList("rel", (AList("neg", value="not"), pred))


def left_out(np: AList) -> AList:
    """ "Anything but the red block": unless it is a red block."""
    if np.has("name"):
        pred = AList("pred", (AList("isname", tuple(np.all("name"))),))
    elif kind(np):
        of_kind = (AList("ako", value=p.value) if p.name == "akos" else p for p in np)
        pred = AList("pred", (AList("kindof", tuple(p for p in of_kind if p.name != "det")),))
    else:
        raise NoMeaningError(str(np))
    it = AList("np", (AList("pron", value="they" if np.has("name") else "it"),))
    return AList("exception", (AList("conds", (AList("clause", (it, pred)),)),))


def with_apposed(np: AList, apposed: AList) -> AList:
    """ "The cup, the red one": the red cup."""
    if np.has("qual"):  # "the blue cup, the red one" are two
        raise NoMeaningError(str(np))
    return AList("np", (*(part for part in np if part is not apposed), *apposed.parts))
