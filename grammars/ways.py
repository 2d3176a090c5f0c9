"""Where to: directions, destinations and whence, and what only stands there by chance.

Nobody turns left right, drives from Rick or goes to himself. What verbs take at all is in `usage.py`.
"""

from __future__ import annotations

from itertools import takewhile
from typing import Final

from grammars.alist import AList
from grammars.sorts import (
    HERE,
    POSITIONS,
    ROBOT,
    classes,
    is_abstract,
    is_bare,
    is_people,
    kind,
    usages,
)

WAYS: Final = frozenset(
    "left right forward backward clockwise counterclockwise sideways straight".split()
)
OPPOSITE: Final = (
    {"left", "right"},
    {"forward", "backward"},
    {"up", "down"},
    {"clockwise", "counterclockwise"},
    {"right", "counterclockwise"},
    {"left", "clockwise"},
    {"in", "out"},
    {"on", "off"},
)
SIDES: Final = ("left", "right")
BACKING: Final = ("back", "reverse")
# Said alone they move nothing: "in", "here".
NO_WAY: Final = frozenset(
    "in on off out over away here there inside outside indoors outdoors".split()
)
PARTICLES: Final = frozenset("in out on off up down over".split())
NO_COURSE: Final = frozenset(("on", "around", "about"))
ON_SOMEBODY: Final = frozenset("it me him her them us".split())
LIFTED: Final = {"lower": "up", "raise": "down", "lift": "down"}
CLIMBING: Final = ("go", "come", "climb", "fly", "head", "look", "back")
SWITCHING: Final = frozenset(("on", "off"))
TURNERS: Final = frozenset("turn rotate spin swivel pivot twirl circle twist revolve".split())
VERTICAL: Final = frozenset(("up", "down"))
ORIGINS: Final = ("from", "away from")


def is_somewhere(action: AList, obj: AList | None, uses: frozenset[str], pattern: bool) -> bool:
    """Where it is to go makes sense.

    Args:
        action: the verb's bracket with all that belongs to it.
        obj: what it is done to.
        uses: classes of the verb.
        pattern: no order, but a deed that an order may be matched with.
    """
    dirs = said_ways(action)
    if not pattern and (_goes_to_itself(action, obj, uses) or _is_aimless(action, obj, uses)):
        return False
    if _is_crossed(action, obj, dirs) or _is_from_nowhere(action, uses):
        return False
    if any({one, other} in OPPOSITE or one == other for one in dirs for other in _after(dirs, one)):
        return False
    if {"nowhere", "steering"} <= uses and "venting" not in uses and action.has("dest"):
        return False  # "stop to the kitchen"
    if not pattern and action.slot("act") in BACKING and not {"forward", "on"}.isdisjoint(dirs):
        return False
    if _is_beside_the_end(action):
        return False
    if "aimless" in uses and obj is not None and not POSITIONS.isdisjoint(dirs):
        return False  # "grab the back up"
    turned = action.has("the_other_way") or not WAYS.isdisjoint(dirs)
    if _is_adrift(obj, uses, dirs) or (turned and not uses.isdisjoint(("still", "venting"))):
        return False
    if "nowhere" in uses and not HERE.issuperset(dirs):
        return False
    ends = [np for part in action.all("dest") for np in part.all("np")]
    return pattern or not any(map(_is_no_end, ends))


def _is_beside_the_end(action: AList) -> bool:
    """ "Turn to the door left": a side is told before where it is to go."""
    before = takewhile(lambda part: part.name != "dest", action)
    after = action.parts[len(tuple(before)) :]
    return any(part.name == "dir" and part.value in SIDES for part in after)


def _is_adrift(obj: AList | None, uses: frozenset[str], dirs: list[str]) -> bool:
    """ "Examine on", "grab it around": what is done where one is goes on in no such way."""
    if "still" not in uses or not uses.isdisjoint(("alone", "onward")):
        return False
    no_course = NO_COURSE if obj is not None else NO_COURSE | PARTICLES - {"up", "out"}
    return not no_course.isdisjoint(dirs)


def said_ways(action: AList) -> list[str]:
    """Directions of an action in order, those among its adverbs too."""
    dirs = [part.value or "" for part in action.all("dir")]
    return dirs + [
        manner.slot("adv") for manner in action.all("manner") if manner.slot("adv") in WAYS
    ]


def _is_crossed(action: AList, obj: AList | None, dirs: list[str]) -> bool:
    """Ways that come together only by chance: "turn right on", "leave out the back up"; each block is not backed up."""
    said = set(dirs)
    every = action.find("every")
    if every is not None and action.slot("act") in BACKING:
        return kind(every) not in classes()["backing"] | {""}
    particles = said & PARTICLES
    if LIFTED.get(action.slot("act")) in said:  # "lower it up"
        return True
    if obj is None and said & WAYS and said & VERTICAL and action.slot("act") not in CLIMBING:
        return True  # "drive forward up"
    upward = obj is None and action.slot("act") in TURNERS and bool(said & VERTICAL)
    return (
        (bool(said & SWITCHING) and (bool(said & WAYS) or _only_goes_on(action, obj)))
        or ((obj is not None or "still" in usages(action.slot("act"))) and len(particles) > 1)
        or upward  # "turn back up"
    )


def _only_goes_on(action: AList, obj: AList | None) -> bool:
    """ "Read on", "dream on": that is no way."""
    return obj is None and not usages(action.slot("act")).isdisjoint(("telling", "reciting"))


def _is_aimless(action: AList, obj: AList | None, uses: frozenset[str]) -> bool:
    """ "Drive a girl", "drive from Janey": nobody says where to."""
    turning = action.slot("act") in TURNERS
    if (
        action.has("dest")
        or uses.isdisjoint(("self", "alone"))
        or (action.has("dir") and not turning)
    ):
        return False
    if obj is not None and "reciting" not in uses:
        return is_people(obj) and not action.has("dir")
    whence = (
        loc
        for place in action.all("place")
        for loc in place.all("loc")
        if loc.slot("prep") == "from"
    )
    return any(np.has("name") or is_people(np) for loc in whence for np in loc.all("np"))


def _is_from_nowhere(action: AList, uses: frozenset[str]) -> bool:
    """ "Halt from Mary": who is not on the way comes from nowhere."""
    place = action.find("place")
    loc = None if place is None else place.find("loc")
    if {"nowhere", "reciting"} <= uses and place is not None:  # "repeat beside that"
        return True
    return "nowhere" in uses and loc is not None and loc.slot("prep") in ORIGINS


def _is_no_end(np: AList) -> bool:
    """ "Turn to jungles", "go to the lesson": nobody gets there."""
    return (is_bare(np) and (np.has("akos") or kind(np) == "back")) or is_abstract(np)


def _goes_to_itself(action: AList, obj: AList | None, uses: frozenset[str]) -> bool:
    """ "Go on in front of you": the robot is no place to go to; nor is what it stands on already: "go on it"."""
    if obj is not None or uses.isdisjoint(("alone", "steering")) or "looking" in uses:
        return False
    place, dest = action.find("place"), action.find("dest")
    marks = [] if dest is None else [np.slot("pron") for np in dest.all("np")]
    if place is not None:
        loc = place.first("loc")
        marks += (np.slot("pron") for np in loc.all("np"))
        named = any(np.has("name") for np in loc.all("np"))
        people = any(is_people(np) or kind(np) == ROBOT for np in loc.all("np"))
        if loc.slot("prep") == "on" and (named or people or not ON_SOMEBODY.isdisjoint(marks)):
            return True
    return not {"you", "yourself"}.isdisjoint(marks)


def _after(said: list[str], one: str) -> list[str]:
    return said[said.index(one) + 1 :]


def is_waiting_for_way(sentence: AList) -> bool:
    """ "Turn right now" turns right; "back up right now" backs up at once, and "right now" is no way to go."""
    if sentence.has("at_once"):
        bare = next((part for part in sentence.walk() if part.name == "bare"), None)
        return bare is not None and [part.value for part in bare.walk()][-1] == "right"
    deeds = [part for part in sentence.walk() if part.name == "action"]
    if (
        not sentence.has("right_now")
        or not deeds
        or any(part.name != "act" for part in deeds[-1].parts)
    ):
        return False
    return (deeds[-1].value or deeds[-1].slot("act")) in TURNERS


def is_way(bare: AList) -> bool:
    """Directions without a verb that tell where to go."""
    said = [part.value for part in bare.walk() if part.name == "dir"]
    return said[:1] == [] or said[0] not in NO_WAY
