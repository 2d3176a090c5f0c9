"""Small talk that has the form of a fact: what is said of nobody in particular, of a mood, of what was just done."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.errors import NoMeaningError
from grammars.hedges import hedge_of
from grammars.manners import NOT_TOO
from grammars.mentions import EVERY, is_definite
from grammars.sorts import HERE, NEARNESS, classes, is_abstract, is_bare, kind
from grammars.vocabulary import BORN, set_phrases

# What somebody does without ever being at it; such a saying is no deed that could be watched.
MENTAL: Final = frozenset("know like love hate want need own prefer fear see mean".split())
STATIVE: Final = MENTAL | {"get", "take"}
# What the robot may be told that it does; the rest it knows best, or is told to do.
YOURS: Final = MENTAL | set(
    "have belong work hold carry weigh wear obey trust listen eat drink speak cost play".split()
)
THIRD: Final = ("he", "she", "it", "they", "we")
WHERE: Final = ("here", "there", "upstairs", "downstairs")
FOND: Final = ("like", "love", "hate", "prefer", "fear")
STANDING: Final = (
    "work",
    "stand",
    "lie",
    "sit",
    "hang",
    "lean",
    "rest",
    "live",
    "wait",
    "sleep",
    "float",
)
IT: Final = ("it", "that", "this")
POINTING: Final = ("the", "this", "that", "these", "those")
LONGEST_QUOTE: Final = 6  # words somebody is told to have said; at more length it is gossip


def check_absence(said: AList) -> None:
    """What there is none of, there is none of somewhere: "there is no milk in the fridge", but no free lunch at all."""
    exists = said.find("exists")
    thing = exists.find("np") if exists is not None else None
    if exists is None or thing is None or _is_in_place(thing):
        return
    none = exists.has("neg") or thing.slot("det") == "no"
    if none or is_abstract(thing):  # "there's a difference"
        raise NoMeaningError(str(said))


def _is_in_place(thing: AList) -> bool:
    """It is somewhere in particular."""
    places = [loc for rel in thing.all("rel") for loc in rel.all("loc")]
    return any(is_definite(np) for loc in places for np in loc.all("np"))


def check_subject(said: AList) -> None:
    """Refuse subjects of generic sentences and of small talk: "a girl", "girls", "I"; and what was said at length."""
    if len(said.slot("quote").split()) > LONGEST_QUOTE:
        raise NoMeaningError("gossip")
    pred = said.find("pred")
    if pred is not None and pred.has("isname"):
        raise NoMeaningError("a name; read as such")
    if said.slot("does") == "know" and len(said.all("np", "base_np")) == 1 and not said.has("name"):
        raise NoMeaningError(str(said))  # "he doesn't know he is tall"
    if said.slot("does") == "call" and not said.has("place"):  # "everyone calls him", what
        raise NoMeaningError(str(said))
    if pred is not None and any(q.slot("hq") == "allowed" for q in pred.all("qual")):
        raise NoMeaningError("what may be done")
    if said.has("should") or _is_told_off(said):
        raise NoMeaningError("advice")
    loc = None if pred is None else pred.find("loc")
    if loc is not None and any(map(is_abstract, loc.all("np"))):
        raise NoMeaningError("in a mood, under the weather")
    subject = said.find("np", "base_np")
    if subject is None:
        return
    if said.has("quote") and subject.has("pron"):  # "he said stop and I stopped"
        raise NoMeaningError("gossip")
    if subject.slot("vague") in EVERY and pred is not None and _is_judged(pred):
        raise NoMeaningError("everything is fine")
    if subject.slot("vague") == "everything" and (subject.has("rel") or said.has("does")):
        raise NoMeaningError("a rule; and everything happens for a reason")
    if subject.has("pron") and _is_remark(said, subject.slot("pron")):
        raise NoMeaningError("a remark")
    known = ("name", "det", "own", "owner", "pron", "vague")
    vague = subject.slot("vague")
    there = _stands_somewhere(said)
    generic = (
        not any(subject.has(part) for part in known)
        or (subject.slot("det") in ("a", "an") and not there)
        or subject.slot("det") in ("any", "no")
        or vague.startswith(("any", "who"))
        or subject.slot("ako") == "name"
        or (vague and pred is not None and pred.has("kindof"))
    )
    speaking = subject.slot("pron") in (("i", "me", "we") if _has_something(said) else ("i", "me"))
    if (
        generic
        or (speaking and not any(told(said) for told in (_is_owning, _is_beside, _is_fond, _stays)))
        or _is_saying(said, subject)
    ):
        raise NoMeaningError(str(said))


def _is_told_off(said: AList) -> bool:
    """ "You turn your back": what the robot does it knows best; "they raise the roof": what somebody does to something
    that only a pronoun tells of."""
    things, verb = said.all("np", "base_np"), said.slot("does")
    pron = things[0].slot("pron") if things else ""
    if not verb or verb in YOURS or verb in STANDING:
        return False
    return pron == "you" or (pron in THIRD and (len(things) > 1 or said.has("iobj")))


def _is_beside(said: AList) -> bool:
    """ "I'm behind you": where the speaker is, from the robot."""
    pred = said.find("pred") or said
    places = [np for loc in pred.all("loc") for np in loc.all("np")]
    return bool(places) and all(np.slot("pron") == "you" for np in places) and not pred.has("qual")


def _is_fond(said: AList) -> bool:
    """ "I like apples", "I don't like spiders": of a sort of thing that the robot has a word for."""
    things = said.all("np", "base_np")[1:]
    if said.slot("does") not in FOND or len(things) != 1:
        return False
    (of,) = things
    mass = kind(of) in classes()["mass"]
    told_apart = of.has("name") or of.has("rel") or of.has("own")
    return (of.has("akos") or mass) and BORN.knows(kind(of)) and not (is_abstract(of) or told_apart)


def _stays(said: AList) -> bool:
    """ "I live here", "I work in the kitchen"."""
    if said.slot("does") not in STANDING or len(said.all("np", "base_np")) > 1:
        return False
    places = [np for place in said.all("place") for loc in place.all("loc") for np in loc.all("np")]
    here = any(way.value in WHERE for way in said.all("dir"))
    seen = bool(places) and all(is_definite(np) and not is_abstract(np) for np in places)
    return here != seen


def _has_something(said: AList) -> bool:
    """ "I have two brothers", and no more than that."""
    counted = said.has("counted") or len(said.all("np", "base_np")) > 1
    doing = said.slot("does", "have") not in ("have", "own")
    return counted and not doing and not any(map(said.has, ("pred", "going", "quote", "num")))


def _is_owning(said: AList) -> bool:
    """It tells of the speaker what may be asked for later; "I have a dream" tells of nothing to be seen."""
    counted = said.find("counted")
    things = said.all("np", "base_np")[1:] if counted is None else [counted]
    return _has_something(said) and all(map(_is_countable, things))


def _is_countable(thing: AList) -> bool:
    """One of a kind, or several, that the robot has a word for or that is described."""
    known = (BORN.knows(kind(thing)) or thing.has("qual")) and not is_abstract(thing)
    some = thing.has("num") or thing.has("akos") or not is_bare(thing)
    return known and some and thing.slot("det") not in POINTING


def _stands_somewhere(said: AList) -> bool:
    """ "A person is standing behind you", "a ball is under the table" tell of one that is there now."""
    pred = said.find("pred")
    if pred is not None and not hedge_of(said) and not is_abstract(said.first("np", "base_np")):
        near = any(qual.slot("hq") in (*HERE, *NEARNESS) for qual in pred.all("qual"))
        return near or any(
            is_definite(np) or np.has("pron") for loc in pred.all("loc") for np in loc.all("np")
        )
    doing = said.find("going") or said
    place = doing.find("place")
    stands = doing.slot("gerund") or doing.slot("does")
    return (
        stands in STANDING
        and place is not None
        and any(loc.has("prep") for loc in place.all("loc"))
    )


def _is_remark(said: AList, pron: str) -> bool:
    """ "It's a small world", "that is a good question"; "it is raining", "you are hopeless" in a word nobody taught."""
    pred, going = said.find("pred"), said.find("going")
    if going is not None:
        verb = going.slot("gerund") or going.value or ""
        return BORN.readings(verb).keys().isdisjoint(("VERB", "STATE"))
    if pred is None:
        return False
    kindof, qual = pred.find("kindof"), pred.find("qual")
    if pron == "you" and kindof is not None and _is_judged(kindof):
        return True
    told_kind = pron in IT and kindof is not None and is_abstract(kindof)
    return told_kind or (qual is not None and (qual.value is not None or _is_verdict(pron, qual)))


def _is_verdict(pron: str, qual: AList) -> bool:
    """ "That's too loud": of what was done, as no thing is too fast; "you are too close"."""
    way = qual.slot("hq")
    too = any(deg.value == "too" for deg in qual.all("deg"))
    if too and pron == "you":
        return True
    return too and pron in IT and not NOT_TOO.keys().isdisjoint((way, f"{way}ly"))


def _is_judged(kindof: AList) -> bool:
    """ "You are a bad, bad boy": praise and blame."""
    said = {qual.slot("hq") or qual.value for qual in kindof.all("qual")}
    return not said.isdisjoint((*set_phrases()["GOOD"], *set_phrases()["BAD"]))


def _is_saying(said: AList, subject: AList) -> bool:
    """What somebody that only a pronoun tells of does to a thing that nothing is said of: "he knows the ropes"; and of
    the robot also to any such thing, as it knows best what it sees and likes: "you need a break"."""
    things = said.all("np")[1:]
    if said.slot("does") == "know":  # "Rick knows the drill"
        return any(thing.slot("det") == "the" and _is_bare(thing) for thing in things)
    if said.slot("does") not in STATIVE or not subject.has("pron"):
        return False
    kinds = ("the",) if subject.slot("pron") != "you" else ("the", "a", "an", "")
    return any(thing.slot("det") in kinds and _is_bare(thing) for thing in things)


def _is_bare(thing: AList) -> bool:
    return all(part.name in ("det", "ako", "akos") for part in thing)
