"""What is said of a thing, and relative clauses and what else narrows one down, into nets."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from grammars.alist import AList
from grammars.comparing import comparison
from grammars.errors import NoMeaningError
from grammars.mentions import PLACES, VERB_SLOTS, compounded, is_time
from grammars.morphology import lemmas
from grammars.pacing import TIMES
from grammars.sorts import (
    POSITIONS,
    classes,
    is_attribute,
    is_bare,
    is_kind_of_it,
    kind,
    may_regard,
    usages,
)
from grammars.usage import PUTTING, TIMES_OF_DAY, particles

if TYPE_CHECKING:
    from grammars.things import Things

POSTURES: Final = ("sit", "stand", "lie", "rest", "hang", "lean", "sleep", "wait", "live")
# Where something is brought, and not where it is.
LEADING: Final = ("into", "onto", "through", "past", "out of", "away from")


def relative(build: Things, name: str, np: AList, rel: AList) -> None:
    """Narrow a thing down: "that is not blue", "next to the wall", "on the left", "called Pookie"."""
    if (loc := rel.find("loc")) is not None and is_time(loc):
        raise NoMeaningError(str(rel))  # "noise at night" is no sort of noise
    if rel.has("name"):
        build.sketch.change(name, lex=frozenset({rel.slot("name")}))
    elif (pred := rel.find("pred")) is not None:
        if rel.has("sub") and not is_attribute(rel.slot("sub")):
            raise NoMeaningError(str(rel))  # "whose lid is open" is not open itself
        if (kindof := pred.find("kindof")) is not None and not is_kind_of_it(np, kindof):
            raise NoMeaningError(str(rel))
        if pred.has("isname") or any(q.slot("hq") in TIMES_OF_DAY for q in pred.all("qual")):
            raise NoMeaningError(str(rel))  # "the block that is Janey", "that is morning"
        predicate(build, name, pred, rel.has("neg"))
    elif (made := rel.find("made_of")) is not None:
        build.quality(name, made)
    elif (belongs := rel.find("belongs")) is not None:  # "anything of Mary's"
        build.owned(name, belongs)
    elif (owner := rel.find("owner_of", "of_owner")) is not None:
        build.owned(name, owner)
    elif (loc := rel.find("loc")) is not None and loc.slot("prep") in LEADING:
        raise NoMeaningError(str(rel))
    elif any(map(rel.has, ("loc", "side", "compared", "hereabouts"))):
        predicate(build, name, rel, negated=False)
    elif (posed := rel.find("posed")) is not None:  # "sitting on the sofa" is on it
        if posed.slot("gerund") not in POSTURES:
            raise NoMeaningError(str(rel))
        predicate(build, name, posed.first("place"), negated=False)
    elif any(rel.has(part) for part in ("going", "has_it", "habit", "habit_s")):
        _doing(build, name, rel)
    elif (seen := rel.find("seen_by")) is not None and _may_be_told_apart(np):
        _seen(build, name, seen)
    elif rel.has("gerund"):
        build.add("act", rel.slot("gerund"), agt=build.oneself("you"), obj=name)
    else:
        raise NoMeaningError(str(rel))


def _may_be_told_apart(np: AList) -> bool:
    """By what somebody does to it: not "bowl Rosie saw", nor "the basket she spins she scores", nor "the block that is
    not blue you stop"."""
    clauses = sum(rel.has("seen_by") or rel.has("pred") for rel in np.all("rel"))
    return not (is_bare(np) and np.has("ako")) and clauses == 1


def _seen(build: Things, name: str, seen: AList) -> None:
    """What is said by a clause that misses the thing: "the cup Mary gave me", "the chair Tom sat on"."""
    agent, strand = _seer(build, seen.first("seer")), seen.slot("left_over")
    verb = next(filter(None, map(seen.slot, VERB_SLOTS)), "")
    way = f"{verb} {strand or seen.slot('dir')}"
    if not verb:  # "the box the cat is in"
        build.add("loc", PLACES.get(strand, strand), loc=agent, wrt=name)
        return
    if way in particles():
        verb, way = particles()[way]
        strand = ""
    elif seen.has("dir"):
        raise NoMeaningError(str(seen))
    if "halting" in usages(verb):  # "the kitchen you can stop now"
        raise NoMeaningError(str(seen))
    if verb in PUTTING and not (seen.has("place") or strand):  # "the cup I put on the bed"
        raise NoMeaningError(str(seen))
    links = {"agt": agent}
    if (obj := seen.find("np")) is not None:
        links["obj"] = build.thing(obj)
    elif not strand and "alone" in usages(verb):  # "the basket she sleeps"
        raise NoMeaningError(str(seen))
    elif not strand:
        links["obj"] = name
    if (receiver := seen.find("receiver")) is not None:
        links["dest"] = build.thing(receiver, person=True)
    act = build.add("act", verb, negated=seen.has("neg"), **links)
    if strand:
        build.add("loc", PLACES.get(strand, strand), loc=act, wrt=name)
    build.modifiers(act, AList("seen_by", tuple(seen.all("place"))))


def _seer(build: Things, seer: AList) -> str:
    """Who sees, has or likes the thing: "the ball you see", "the cup Mary has"."""
    if (np := seer.find("np")) is not None:
        return build.thing(np)
    if seer.has("name"):
        return build.thing(seer, person=True)
    return build.oneself("me" if seer.has("me") else "you")


def _doing(build: Things, name: str, rel: AList) -> None:
    """What a thing does or has: "who is holding a cup", "that has wheels"."""
    going = rel.find("going", "habit", "habit_s") or rel
    links = {"agt": name}
    verb = next(filter(None, map(going.slot, VERB_SLOTS)), going.value or "")
    if (obj := going.find("np")) is not None:
        links["obj"] = build.thing(obj)
    elif going.name.startswith("habit") and "needing" in usages(verb):
        raise NoMeaningError(str(rel))  # "the block that thanks"
    denied = rel.has("neg")
    act = build.add("act", "have" if rel.has("has_it") else verb, negated=denied, **links)
    build.modifiers(act, going)


def predicate(build: Things, name: str, pred: AList, negated: bool) -> str:
    """Say something of a thing; the node of the predicate."""
    if (made := pred.find("made_of")) is not None:
        return build.quality(name, made, negated)
    if pred.has("qual"):
        if not may_regard(pred):
            raise NoMeaningError(str(pred))
        main, *_ = [build.quality(name, part, negated) for part in pred.all("qual")]
        if (for_so_long := pred.find("for_so_long")) is not None:  # "stuck for a minute"
            if for_so_long.slot("unit") not in TIMES:
                raise NoMeaningError(str(pred))
            number = for_so_long.slot("num", "1")
            build.add("amt", for_so_long.slot("unit"), literal=number, amt=main)
        about = pred.find("loc")
        if about is not None and not _is_of_its_kind(build, name, pred, about):  # "afraid of dogs"
            build.place("loc", main, about)
        return main
    if stuff := pred.slot("stuff_so"):
        if stuff not in classes()["mass"]:
            raise NoMeaningError(str(pred))
        return build.kind(name, stuff, negated=negated)
    if (kindof := pred.find("kindof")) is not None:
        return kind_of(build, name, kindof, negated)
    if (loc := pred.find("loc")) is not None:
        if pred.has("back_there") and loc.slot("prep") == "from":  # is where he was before
            raise NoMeaningError(str(pred))
        return build.place("loc", name, loc, negated)
    if (side := pred.find("side")) is not None:
        return build.add("loc", side.slot("dir") or side.value or "", loc=name, negated=negated)
    if (compared := pred.find("compared")) is not None:
        return comparison(build, name, compared, negated)
    if (called := pred.find("isname")) is not None:
        if build.sketch.terms[name].lex & {"you", "me"}:  # "if you are idle"
            return build.add("hq", called.slot("name"), hq=name, negated=negated)
        if negated or build.sketch.terms[name].lex:  # it would be told that it is; "Mary is Mary"
            raise NoMeaningError(str(pred))
        build.sketch.change(name, lex=frozenset((called.slot("name"),)))
        return build.put(name)
    if (measured := pred.find("measured")) is not None:  # "3 meters long"
        if measured.slot("unit") in TIMES and measured.slot("hq") != "long":
            raise NoMeaningError(str(measured))  # "twenty minutes late"
        if not measured.has("unit"):  # "Lily is seven"
            measured = _years(build, name, measured)
        hq = build.quality(name, measured, negated)
        build.add(
            "amt", measured.slot("unit").removesuffix("s"), literal=measured.slot("num"), amt=hq
        )
        return hq
    if here := pred.slot("hereabouts"):
        return build.add("loc", here, loc=name, negated=negated)
    if pred.has("here"):
        return build.add("loc", "in front of", loc=name, wrt=build.oneself("you"), negated=negated)
    if (belongs := pred.find("belongs")) is not None:
        return build.owned(name, belongs, negated)
    raise NoMeaningError(str(pred))


def _is_of_its_kind(build: Things, name: str, pred: AList, about: AList) -> bool:
    """ "The red box is the heaviest of the boxes": which such it is, is said already."""
    most = any(qual.has("most") or qual.has("most_of") for qual in pred.all("qual"))
    kinds = {
        word
        for term in build.sketch.terms.values()
        if ("ako", name) in term.links
        for word in term.lex
    }
    return most and not kinds.isdisjoint({lemmas(kind(np), "noun")[0] for np in about.all("np")})


def _years(build: Things, name: str, measured: AList) -> AList:
    """ "Lily is seven": so many years old, which nobody says so of but persons."""
    if not any(thing.name == name and (thing.person or thing.called) for thing in build.things):
        raise NoMeaningError(str(measured))
    return AList(
        "measured", (*measured.parts, AList("unit", value="year"), AList("hq", value="old"))
    )


def kind_of(build: Things, name: str, kindof: AList, negated: bool) -> str:
    """Say of what kind a thing is, with all that is said of the kind; the node of that.

    What is "not a big dog" is a dog, and not big; our choice.
    """
    called, quals = kind(kindof), kindof.all("qual")
    if not called or (negated and len(quals) > 1):
        raise NoMeaningError(str(kindof))
    if any(qual.slot("hq") in POSITIONS for qual in quals):  # "cups are on shelves"
        raise NoMeaningError(str(kindof))
    described = bool(quals) and not build.pattern and not kindof.has("rel")
    denied = [build.quality(name, qual, negated and described) for qual in quals]
    node = build.kind(name, called, compounded(kindof), negated and not described)
    node = denied[0] if negated and described else node
    for rel in kindof.all("rel"):
        relative(build, name, kindof, rel)
    if (belongs := kindof.find("belongs")) is not None:  # "a friend of Lucy's"
        build.owned(name, belongs)
    if (of := kindof.find("np")) is not None:
        build.add("own", own=name, of=build.thing(of, person=True))
    build.possessed(name, kindof)
    return node
