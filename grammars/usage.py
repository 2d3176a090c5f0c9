"""How verbs are used: what may stand beside one, and what only stands there by chance.

A rule of the grammar takes any verb for any; nobody sulks puddles, drives a hamster, thanks left or grabs an attitude.
The classes of verbs and the sorts of things are in `sorts.py`, directions and destinations in `ways.py`. A verb that
is in no class, and so every verb that is taught, is used in any way.
"""

from __future__ import annotations

from functools import cache
from typing import Final

from grammars.alist import AList
from grammars.how_done import is_odd_manner, is_untimely
from grammars.sorts import (
    HERE,
    POSITIONS,
    ROBOT,
    classes,
    is_abstract,
    is_bare,
    is_country,
    is_nothing,
    is_people,
    is_recited,
    is_said_to_persons,
    kind,
    may_receive,
    usages,
)
from grammars.vocabulary import BORN, lines
from grammars.ways import BACKING, TURNERS, WAYS, is_somewhere

# "Go out the door": what stands behind them is the way.
PATHS: Final = frozenset("up down in out over around through along".split())
# Qualities that stand behind a thing only, unless it has an article ("press the on button").
BEHIND: Final = frozenset(
    "up down on off around here there gone home away asleep awake alone alive afraid near".split()
)
WORKED: Final = POSITIONS | HERE
SINGLE: Final = ("hand", "arm", "claw")  # of which the robot has one
MOST_QUALITIES: Final = 2  # of a thing without an article
ONCE: Final = ("cnt", "size", "dest")  # an action has one of each
TIMES_OF_DAY: Final = frozenset(
    "noon midnight night morning evening afternoon dawn dusk sunset nightfall summer winter autumn".split()
)
# "It is late": of nothing in particular.
AMBIENT: Final = frozenset("late early dark sunny cloudy windy foggy".split())
MEANS: Final = ("with", "for", "on", "about", "from")
# Nothing is done to them under these names: "stop you", "grab he".
NOMINATIVES: Final = ("i", "he", "she", "they", "we")
SUBJECTS: Final = ("you", *NOMINATIVES)

PUTTING: Final = ("put", "place", "lay", "set", "stack", "put down", "set down", "lay down")


@cache
def particles() -> dict[str, tuple[str, str]]:
    """Verb, or verb and particle, to lexical item and direction ("" for none)."""
    table: dict[str, tuple[str, str]] = {}
    for line in lines("particles"):
        said, _, meant = line.partition("=")
        verb, _, way = meant.strip().partition(" ")
        table[said.strip()] = (verb, way) if meant else (said.strip(), "")
    return table


def is_used(action: AList, verb: str, pattern: bool, naming: bool = False) -> bool:
    """People use the verb with what stands beside it.

    Args:
        action: the verb's bracket with all that belongs to it.
        verb: the verb with its particle, as in the net ("pick up").
        pattern: no order, but a deed that an order may be matched with.
        naming: a deed that it is told how to do, whatever it is called: "to get somebody's attention".
    """
    uses, obj = usages(verb), action.find("np")
    every = action.find("every")
    if every is not None and not _takes_each(action, every, uses):
        return False
    named = naming and obj is not None and (is_abstract(obj) or is_people(obj))
    if obj is not None and not named and not _takes(action, obj, uses, pattern):
        return False
    if not pattern and _is_left_or_turned(action, obj or every):
        return False
    if not pattern and (_lacks(action, obj, uses) or _is_upon_nothing(action)):
        return False
    if not pattern and not uses.isdisjoint(("sensing", "minding")):
        return False  # nobody orders "see the red block" or "want it"
    if not pattern and (_is_by_way_of_speaking(action, obj) or is_odd_manner(action, obj)):
        return False
    if "whole" in uses and (action.has("size") or action.has("amt")):
        return False
    if any(len(action.all(part)) > 1 for part in ONCE) or is_untimely(action, uses):
        return False
    amounts = action.all("amt")
    if len(amounts) > len({amt.has("per") for amt in amounts}):
        return False  # at what speed, and how long, but no two of a sort
    if action.has("size") and any(not amt.has("num") for amt in action.all("amt")):
        return False  # "back up a little an hour"
    if not is_somewhere(action, obj, uses, pattern):
        return False
    dest, receiver = action.find("dest"), action.find("iobj")
    if not pattern and action.slot("act") in BACKING and _is_going_back(action):
        return False
    if dest is not None and not pattern and any(map(_is_some_of_yours, dest.all("np"))):
        return False  # "go back to your constituencies"
    if dest is not None and any(map(is_said_to_persons, dest.all("np"))):
        return False  # "hang on to your hat"
    told = "informing" in uses or "GIVE" in BORN.readings(verb)
    if dest is not None and dest.has("whither") and told:
        return False  # "show Mary where the hat is" shows its place
    if receiver is not None and not _may_get(receiver.first("np"), uses):
        return False
    beside = [receiver, action.find("dest"), action.find("place")]
    bare = [np for part in beside if part is not None for np in part.walk() if np.name == "np"]
    if any(np.slot("pron") in NOMINATIVES for np in bare):
        return False  # "past i"
    if "venting" in uses and any(map(is_bare, bare)):
        return False
    if "steering" in uses and any(map(_is_around_some, action.all("place"))):
        return False
    return pattern or all(map(_is_short, bare))


def _may_get(np: AList, uses: frozenset[str]) -> bool:
    """Nobody does something for it: "make it two coffees"."""
    return may_receive(np) and not ("favoring" in uses and np.slot("pron") == "it")


def put_nowhere(verb: str, said: AList, thing: AList | None) -> bool:
    """ "In the box" is where the ball is put, and not which ball: "put the ball in the box"."""
    if verb not in PUTTING or said.has("place") or thing is None:
        return False
    return any(rel.has("loc") for rel in thing.all("rel"))


def _is_upon_nothing(action: AList) -> bool:
    """ "Touch nothing" is no order to touch something."""
    beside = [action, *action.all("iobj", "dest")]
    beside += (loc for place in action.all("place") for loc in place.all("loc"))
    return any(is_nothing(np) for part in beside for np in part.all("np"))


def _is_by_way_of_speaking(action: AList, obj: AList | None) -> bool:
    """ "Move on with your life", "turn your garden into a paradise": not where anything is done."""
    place = action.find("place")
    loc = AList("loc") if place is None else place.first("loc")
    becoming = obj is not None and action.slot("act") in TURNERS and loc.slot("prep") == "into"
    locs = [loc, *(part for rel in (obj or loc).all("rel") for part in rel.all("loc"))]
    return becoming or any(
        part.slot("prep") in MEANS and any(map(is_abstract, part.all("np"))) for part in locs
    )


def _lacks(action: AList, obj: AList | None, uses: frozenset[str]) -> bool:
    """Nobody is told to "make", or to "make it" and no more, or to "grab behind the chair"."""
    said = obj is not None or action.has("every") or action.has("whereis")
    making = obj is not None and (
        obj.has("pron")
        or obj.has("name")
        or is_people(obj)
        or any(rel.has("seen_by") for rel in obj.all("rel"))
        or any(m.has("faster") for m in action.all("manner"))
    )
    if "handing" in uses and obj is not None and not (action.has("iobj") or action.has("dest")):
        return is_people(obj) or obj.has("name") or is_bare(obj)  # "hand visitors", "give place"
    if "placing" in uses and not any(map(action.has, ("place", "dest", "dir", "iobj"))):
        return True  # "put the cup"
    lacking = ("needing" in uses and not action.has("size")) or any(
        sort in uses and action.has(part)
        for sort, part in (("taking", "place"), ("taking", "dest"), ("aimless", "dir"))
    )
    return (lacking and not said) or ("making" in uses and making)


def _takes_each(action: AList, every: AList, uses: frozenset[str]) -> bool:
    """The verb takes an object there, and such."""
    before = {part.value for part in action.parts[: action.parts.index(every)]}
    if "steering" in uses and (before & WAYS):
        return False  # "turn left everything"
    if is_said_to_persons(every):  # "take your seats"
        return False
    handled = "telling" in uses or not is_abstract(every)
    return handled and "alone" not in uses and ("reciting" not in uses or is_recited(every))


def _is_left_or_turned(action: AList, thing: AList | None) -> bool:
    """ "Leave out the butter", as recipes say it; "turn the pages"."""
    if thing is None:
        return False
    left_out = action.slot("act") == "leave" and any(w.value == "out" for w in action.all("dir"))
    return left_out or (action.slot("act") in TURNERS and kind(thing) in classes()["unturned"])


def _is_some_of_yours(np: AList) -> bool:
    """What the robot is said to have, in a word that nobody taught."""
    return np.slot("own") == "your" and not BORN.knows(kind(np))


def _is_called(np: AList) -> bool:
    """ "Carry on, doctor": who is told so, and nothing that it is done to."""
    return np.has("ako") and is_bare(np) and is_people(np) and kind(np) != "person"


def _takes(action: AList, obj: AList, uses: frozenset[str], pattern: bool) -> bool:
    """The verb takes such an object there."""
    parts = list(action)
    before = [part.value for part in parts[: parts.index(obj)] if part.name == "dir"]
    named, bare = obj.has("name"), is_bare(obj)
    if "alone" in uses and ("venting" in uses or bare or named or PATHS.isdisjoint(before)):
        return False
    if "telling" not in uses and is_abstract(obj):
        return False
    if "reciting" in uses and not is_recited(obj):
        return False
    if "personal" in uses and bare and obj.has("ako") and not is_people(obj):
        return False  # "remind kitchen"
    if named and "faring" not in uses and is_country(obj):
        return False
    if (before and _is_called(obj)) or (bare and kind(obj) == ROBOT):
        return False
    if not pattern and (obj.slot("pron") in (*SUBJECTS, "itself") or kind(obj) in TIMES_OF_DAY):
        return False
    if action.slot("act") in BACKING and (
        obj.has("one") or kind(obj) not in classes()["backing"] | {""}
    ):
        return False
    if bare and kind(obj) == "back":  # "grab back up"
        return False
    quals = _qualities(obj)
    if (bare and quals & BEHIND) or (quals & WORKED and kind(obj) not in classes()["switches"]):
        return False  # "never pick up pins" is about no "up pins", nor "pick the up block"
    hands = obj.slot("own") == "your" and obj.slot("akos") in SINGLE
    if hands or is_said_to_persons(obj):
        return "taking" in uses and kind(obj) in classes()["belongings"]
    if obj.slot("own") == "your" and not (pattern or BORN.knows(kind(obj))):
        return False  # its own parts it knows: "lift your spirits"
    if obj.slot("pron") == "yourself" and "taking" in uses:
        return False  # "catch yourself a fish"
    if not WAYS.isdisjoint(before) and (bare or named or obj.has("pron") or "steering" in uses):
        return False
    digit = bare and not obj.has("qual") and (obj.has("one") or kind(obj) == "one")
    if digit and "keyed" in uses:  # "press one for sales"
        return False
    if (bare and not uses.isdisjoint(("steering", "apart"))) or (
        "self" in uses and (named or obj.slot("pron") == "you")
    ):
        return False
    if (
        bare
        and obj.has("sub")
        and any(
            is_bare(np) for place in action.all("place") for np in place.walk() if np.name == "np"
        )
    ):
        return False  # "tighten pajamas trick from ties"
    return pattern or _is_short(obj, "telling" in uses)


def _is_short(np: AList, told: bool = False) -> bool:
    """A thing without an article as children and telegrams have it: "grab red block"; nothing at more length."""
    if not is_bare(np):
        return True
    if kind(np) == "back":  # "pause above back"
        return False
    if np.has("ako") and any(rel.has("going") for rel in np.all("rel")):
        return False  # "count railway emailing somebody"
    if "same" in _qualities(np) or (np.has("akos") and any(q.has("ord") for q in np.all("qual"))):
        return False  # "next brains"
    quals = np.all("qual")
    if len(quals) > MOST_QUALITIES or any(qual.has("more") for qual in quals):
        return False
    if _qualities(np) & BEHIND:
        return False
    return told or not (np.has("ako") and is_abstract(np))


def is_odd_end(np: AList, qual: AList) -> bool:
    """ "Keep back up", "keep mantels yellower": a thing without an article, and a quality that is rather a way, or none
    to be kept."""
    return is_bare(np) and (qual.has("more") or (qual.value or qual.slot("hq")) in BEHIND)


def _is_going_back(action: AList) -> bool:
    """ "Back in the game": who is there again, and no way to drive."""
    places = [loc for place in action.all("place") for loc in place.all("loc")]
    return any(loc.slot("prep") == "in" for loc in places)


def _is_around_some(place: AList) -> bool:
    """ "Turn around, bright eyes": somebody told, and nothing to be gone around."""
    return any(loc.slot("prep") == "around" and any(map(is_bare, loc.all("np"))) for loc in place)


def _qualities(np: AList) -> set[str]:
    return {qual.value or qual.slot("hq") for qual in np.all("qual")}
