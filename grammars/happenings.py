"""What somebody did or what happened, told as a fact: "I grabbed the cup", "somebody took my keys"."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.build import Build
from grammars.doings import in_the_past
from grammars.errors import NoMeaningError
from grammars.mentions import US, is_definite
from grammars.remarks import MENTAL
from grammars.sorts import classes, is_abstract, is_bare, is_people, kind, usages
from grammars.vocabulary import BORN
from kernel.memory.meaning import Fact

EVERYONE: Final = ("any", "every")
LEAVING: Final = ("leave", "love", "dump")
SPEAKING: Final = ("i", "we")
# Done to what is no thing in the hand: of such doings of nobody in particular the radio talks.
REPORTED: Final = ("telling", "reciting", "venting")


def happened(build: Build, deed: AList) -> Fact:
    """What was done, by whom, and what of it is denied; told of in any words that could have been seen.

    Args:
        build: the drawing.
        deed: bracket with who did it (of a passive the doer), and the deed.
    """
    doer = deed.first("doer")
    done = deed.find("did_it", "action") or AList("action", _without(deed, doer))
    who = doer.find("np") or AList("np", doer.parts)
    if not who.has("name"):
        _check(who, done)
    if done.has("iobj") and "GIVE" not in BORN.readings(done.slot("act")):
        raise NoMeaningError(str(done))
    with build.drawing(pattern=False):
        agent = build.thing(who, person=who.has("name"))
        nobody = build.negative
        act = build.action(done)
        build.sketch.link(act, "agt", agent)
        in_the_past(build, act)
        build.sketch.change(act, negated=deed.has("neg") or nobody)
        told = build.graphlet(act)
    return Fact(told, tuple(build.finds))


def _without(deed: AList, part: AList) -> tuple[AList, ...]:
    return tuple(other for other in deed if other is not part)


def _check(who: AList, done: AList) -> None:
    """Refuse gossip: of whom, of what and of doings that nobody in the room could mean."""
    obj = done.find("np")
    verb = done.slot("act") or done.value or ""
    if (
        done.has("speaking")  # "the vet said she can come home"
        or verb in MENTAL
        or not usages(verb).isdisjoint(REPORTED)
        or who.slot("vague").startswith(EVERYONE)
    ):
        raise NoMeaningError(str(done))
    if verb in LEAVING and obj is not None and obj.slot("pron") in US:
        raise NoMeaningError("my wife left me")
    if who.has("pron") and not _is_pointed_out(who, obj, done):
        raise NoMeaningError("gossip")
    if obj is None and not (who.has("vague") or _is_seen(who)):
        raise NoMeaningError(str(who))
    if obj is not None and not (who.has("pron") or who.has("vague") or _is_alive(who)):
        raise NoMeaningError("the market lost ground")
    if obj is not None and not (obj.has("pron") or _is_seen(obj)):
        raise NoMeaningError(str(obj))


def _is_pointed_out(who: AList, obj: AList | None, done: AList) -> bool:
    """What somebody that only a pronoun tells of did to a thing that is told apart, the speaker to any: "he hit the
    road", but "he took my keys" and "I opened the door"."""
    if obj is None or (who.slot("pron") in SPEAKING and obj.has("pron")):
        return False
    bare = all(part.name in ("det", "ako", "akos", "pron", "rel") for part in obj)
    return who.slot("pron") in SPEAKING or not bare


def _is_seen(np: AList) -> bool:
    """Something in particular, or one of a kind, that can be seen: no chances, no shares."""
    if np.has("name"):
        return True
    known = BORN.knows(kind(np)) and not is_abstract(np)
    return known and (is_definite(np) or not is_bare(np))


def _is_alive(np: AList) -> bool:
    """Persons and animals do things to others."""
    return np.has("name") or (_is_seen(np) and (is_people(np) or kind(np) in classes()["animals"]))
