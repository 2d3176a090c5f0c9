"""Facts told in another order or all at once, as clauses in the plain order."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from grammars.alist import AList
from grammars.errors import NoMeaningError
from grammars.mentions import FINITE, is_definite, is_time
from grammars.remarks import STANDING
from grammars.sorts import classes, is_abstract, is_bare, is_people, kind
from grammars.vocabulary import BORN

JUDGED: Final = ("right", "wrong", "correct")
PARTS: Final = "end start beginning point way case thing last limit".split()


def restated(alist: AList) -> AList:
    """The same in the plain order: "this is my brother Tom" is "Tom is my brother"."""
    for name, told in TOLD_APART.items():
        if (said := alist.find(name)) is not None:
            return AList(alist.name, told(said))
    for name, restated in RESTATED.items():
        if (said := alist.find(name)) is not None:
            return AList(alist.name, (restated(said),))
    return alist


def _served(served: AList) -> AList:
    """ "Dinner is ready" is "the dinner is ready"."""
    meal, *rest = served.parts
    pred = served.first("pred")
    if kind(meal) not in classes()["meals"] or not (pred.has("qual") or pred.has("loc")):
        raise NoMeaningError(str(served))
    if not all(is_definite(np) for loc in pred.all("loc") for np in loc.all("np")):
        raise NoMeaningError("lunch is for wimps")
    return AList("clause", (AList("np", (AList("det", value="the"), *meal.parts)), *rest))


def _kin(kin: AList) -> tuple[AList, AList]:
    """ "My brother Tom is tall" is "Tom is my brother" and "Tom is tall"."""
    at = next(place for place, part in enumerate(kin) if part.name == "name")
    if kin.parts[at].value in FINITE:  # "my heart will go on"
        raise NoMeaningError(str(kin))
    who = AList("np", (kin.parts[at],))
    return _of_kind(who, kin.parts[:at]), AList("clause", (who, *kin.parts[at + 1 :]))


def _some_so(some: AList) -> AList:
    """ "One of the cups is broken" is "there is a cup that is broken"; the other cups are not its business."""
    told = tuple(part for part in some if part.name in ("neg", "pred"))
    one = tuple(part for part in some if part.name not in ("det", "neg", "pred", "num_of"))
    thing = (*one, AList("rel", told))
    number = some.find("num_of")
    there = AList("np", thing) if number is None else AList("counted", (*number.parts, *thing))
    return AList("clause", (AList("exists", (there,)),))


def _most_so(most: AList) -> AList:
    """ "Most of the cups are clean": the cups are, if not all."""
    return AList("clause", most.parts)


def _pointed_out(pointed_out: AList) -> AList:
    """ "That over there is a door"."""
    kindof = pointed_out.first("pred").first("kindof")
    judged = any(qual.slot("hq") in JUDGED for qual in kindof.all("qual"))
    if kindof.slot("ako") in PARTS or judged:  # "that is the wrong door"
        raise NoMeaningError("this is the end")
    return AList("clause", pointed_out.parts)


def _introduced(introduced: AList) -> AList:
    """ "This is my brother Tom"."""
    said = tuple(part for part in introduced if part.name not in ("np", "name"))
    return _of_kind(AList("np", tuple(introduced.all("name"))), said)


def _of_kind(who: AList, said: tuple[AList, ...]) -> AList:
    """ "Tom is my brother"."""
    return AList("clause", (who, AList("pred", (AList("kindof", said),))))


def _placed(placed: AList) -> AList:
    """ "On the shelf stands a vase" is "there is a vase on the shelf"; "on it is the vase" is "the vase is on it"."""
    stands = placed.find("stands")
    if stands is not None and stands.value not in STANDING:
        raise NoMeaningError(str(placed))
    place = placed.find("loc")
    if place is not None and any(map(is_abstract, place.all("np"))):
        raise NoMeaningError("in a mood")
    if (counted := placed.find("counted")) is not None:
        there = AList("counted", (*counted.parts, AList("rel", (placed.first("loc"),))))
        return AList("clause", (AList("exists", (there,)),))
    thing = placed.first("np")
    if place is None or is_time(place):
        if place is not None or not thing.all("rel"):
            raise NoMeaningError(str(placed))
        return AList("clause", (AList("exists", (thing,)),))
    if is_definite(thing):
        return AList("clause", (thing, AList("pred", (place,))))
    if thing.slot("det") not in ("a", "an", "some", "another", "no") and not thing.has("vague"):
        raise NoMeaningError(str(placed))
    there = AList("np", (*thing.parts, AList("rel", (place,))))
    return AList("clause", (AList("exists", (there,)),))


def _here(here: AList) -> AList:
    """ "Here is the hammer": it is here."""
    quality, thing = here.parts
    if is_abstract(thing) or not BORN.knows(kind(thing)):  # "here is the news"
        raise NoMeaningError(str(here))
    return AList("clause", (thing, AList("pred", (AList("qual", (quality,)),))))


def _not_so(not_so: AList) -> AList:
    """ "That is a spoon, not a fork": it is not a fork but a spoon."""
    thing, so, neg, other = not_so.parts
    return AList("denied_so", (thing, neg, other, so))


def _unlike(unlike: AList) -> tuple[AList, ...]:
    """ "The red one is heavy but the blue one isn't": it is not heavy."""
    one, other = unlike.all("np")
    denied = unlike.parts[-1].name == "neg"
    pred, neg = unlike.first("pred"), (AList("neg", value="not"),)
    first, second = ((), neg) if denied else (neg, ())
    return AList("clause", (one, *first, pred)), AList("clause", (other, *second, pred))


def _person_so(so: AList) -> AList:
    """ "Tom is the boss", "the man at the door is the postman": somebody told apart."""
    who, role = so.parts
    if not is_people(role) or role.has("qual") or not (who.has("name") or who.has("rel")):
        raise NoMeaningError(str(so))
    return AList("clause", (who, AList("pred", (role,))))


def _there_too(there: AList) -> tuple[AList, ...]:
    """ "There is a cup and a plate on the table": both are there."""
    first, last = there.parts
    if first.has("rel"):
        raise NoMeaningError(str(there))
    if first.name == "np" and (is_definite(first) or is_bare(first)):
        raise NoMeaningError(str(there))
    both = (AList(first.name, (*first.parts, *last.all("rel"))), last)
    return tuple(AList("clause", (AList("exists", (one,)),)) for one in both)


TOLD_APART: Final[dict[str, Callable[[AList], tuple[AList, ...]]]] = {
    "kin": _kin,
    "unlike": _unlike,
    "there_too": _there_too,
}
RESTATED: Final[dict[str, Callable[[AList], AList]]] = {
    "pointed_out": _pointed_out,
    "placed": _placed,
    "here_it_is": _here,
    "but_not_so": _not_so,
    "introduced": _introduced,
    "met": _introduced,
    "person_so": _person_so,
    "some_so": _some_so,
    "most_so": _most_so,
    "served": _served,
}
