"""Facts: what somebody says is so."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.clauses import clause
from grammars.comparing import regarding
from grammars.dates import dated
from grammars.happenings import happened
from grammars.mentions import FINITE, OWNING, is_definite, is_person, is_time, may_be_person
from grammars.mutual import each_other
from grammars.registry import sentence_form
from grammars.remarks import STANDING, check_absence, check_subject
from grammars.render.telling import SAYING
from grammars.sorts import classes, is_abstract, kind
from grammars.vocabulary import BORN
from kernel.memory.meaning import Fact
from kernel.net.graphlet import Graphlet, Term

EXAMPLES = (
    "Mary is a girl",
    "There is something very close.",
    "The bottle to the left of the green box is Advil.",
    "her name is janey",
    "this block is called pookie",
    "john is taller than mary",
    "Freddy is Janey's brother.",
    "the blue cup is john's",
    "Mary has a red hat.",
    "the blue block is not heavy",
    "the ball is behind you",
    "I'm very tired",
)

DREADING: Final = ("afraid", "scared", "frightened", "terrified", "allergic", "fond")
JUDGED: Final = ("right", "wrong", "correct")
PARTS: Final = "end start beginning point way case thing last limit".split()


@sentence_form("fact", "fact", EXAMPLES)
def fact(alist: AList) -> Fact:
    """The predicate with what is new in it; what is known already is looked up."""
    build = Build(telling=True)
    named = alist.find("named")
    if named is not None:
        return _named(build, named)
    if (taught := alist.find("taught_it")) is not None:
        with build.drawing(pattern=True):
            act = build.action(taught.first("action"))
            if not is_person(taught.first("np")) and not may_be_person(taught.first("np")):
                raise NoMeaningError("nobody who could tell")
            teller = build.thing(taught.first("np"), person=True)
            main = build.add("act", "teach", agt=teller, dest=build.oneself("you"), cmd=act)
            return Fact(build.graphlet(main))
    if (deed := alist.find("past_deed")) is not None:
        return happened(build, deed)
    if (feeling := alist.find("feeling")) is not None:  # "I'm hungry"
        if (dreading := feeling.find("dreading")) is not None:
            return _dreading(build, dreading)
        with build.drawing(pattern=False):
            hq = build.quality(build.oneself("me"), feeling, feeling.has("neg"))
            return Fact(build.graphlet(hq))
    if (day := alist.find("dated")) is not None:
        with build.drawing(pattern=False):
            told = build.graphlet(dated(build, day))
        return Fact(told, tuple(build.finds))
    alist = _restated(alist)
    said = _each_told(alist)
    for one in said:
        check_subject(one)
        check_absence(one)
    with build.drawing(pattern=False):
        mains = [clause(build, one) for one in said]
        if (denied := alist.find("denied_so")) is not None:
            mains.append(_but(build, mains[0], denied))
        told = build.graphlet(mains[0])
    return Fact(told, tuple(build.finds))


def _dreading(build: Build, dreading: AList) -> Fact:
    """ "I am afraid of dogs"."""
    if dreading.slot("hq") not in DREADING or is_abstract(dreading.first("np")):
        raise NoMeaningError(str(dreading))
    with build.drawing(pattern=False):
        hq = regarding(build, build.oneself("me"), dreading)
        return Fact(build.graphlet(hq), tuple(build.finds))


def _restated(alist: AList) -> AList:
    """The same in the plain order: "this is my brother Tom" is "Tom is my brother"."""
    if (kin := alist.find("kin")) is not None:
        return AList(alist.name, _kin(kin))
    for name, restated in RESTATED.items():
        if (said := alist.find(name)) is not None:
            return AList(alist.name, (restated(said),))
    return alist


def _each_told(alist: AList) -> list[AList]:
    """The clauses of a fact: of each of several subjects, of all that is told with "and"."""
    if (denied := alist.find("denied_so")) is not None:
        *said, instead = denied.parts
        return [_only_denied(AList("clause", tuple(said)), instead)]
    said = alist.all("clause")
    if (so := alist.find("it_is_so")) is not None:
        if not said[0].has("neg"):  # two sentences
            raise NoMeaningError(str(alist))
        said = [_only_denied(said[0], so.first("pred")), AList("clause", so.parts)]
    return [each for one in said for each in _of_each(one)]


def _only_denied(said: AList, instead: AList) -> AList:
    """ "It is not a big dog but a cat" denies the dog, "not a red cup but a blue cup" the color."""
    pred = said.find("pred")
    one, other = (None if part is None else part.find("kindof") for part in (pred, instead))
    if pred is None or one is None or other is None or kind(one) == kind(other):
        return said
    plain = AList("kindof", tuple(part for part in one if part.name != "qual"))
    return AList("clause", tuple(AList("pred", (plain,)) if p is pred else p for p in said))


def _of_each(said: AList) -> list[AList]:
    """The same clause with each of several things: "Ann and Bob are tall"."""
    if (both := said.find("both_of", "several_np")) is None:
        return [said]
    if told := each_other(said, both.all("np")):
        return told
    at = said.parts.index(both)
    return [AList("clause", (*said.parts[:at], np, *said.parts[at + 1 :])) for np in both.all("np")]


def _but(build: Build, main: str, denied: AList) -> str:
    """ "It is not red but blue": what is said of the same thing after "but"."""
    links = build.sketch.terms[main].links
    thing = next(other for role, other in links if role in SAYING)
    return clause(build, AList("clause", denied.parts[-1:]), thing)


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


RESTATED: Final[dict[str, Callable[[AList], AList]]] = {
    "pointed_out": _pointed_out,
    "placed": _placed,
    "here_it_is": _here,
    "but_not_so": _not_so,
    "introduced": _introduced,
    "some_so": _some_so,
    "served": _served,
}


def _named(build: Build, named: AList) -> Fact:
    """The name is a lexical item of the thing's own node, as in the paper's figures."""
    with build.drawing(pattern=False):
        whose = named.find("own_name")
        if whose is not None:
            own = whose.slot("own")
            if own not in OWNING:
                raise NoMeaningError("a name of the speaker or of the robot")
            thing = build.pronoun(OWNING[own])
        else:
            owner = named.find("owner")
            if (np := named.find("np")) is not None and np.slot("ako") == "name":
                raise NoMeaningError("the name of a name")
            if np is not None and np.has("pron") and "PLACE" in BORN.readings(named.slot("name")):
                raise NoMeaningError("it's Tuesday")
            thing = build.thing(named.first("np")) if owner is None else build.thing(owner)
    if not build.finds:
        raise NoMeaningError("a name for nothing in particular")
    word = named.all("name")[-1].value or ""
    return Fact(Graphlet((Term(thing, frozenset((word,))),), thing), tuple(build.finds))
