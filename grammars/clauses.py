"""Clauses into nets: what is said of something, in conditions and in facts."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from grammars.alist import AList
from grammars.comparing import seen_from_robot
from grammars.doings import doing, had, undergone
from grammars.errors import NoMeaningError
from grammars.manners import SO_MANY, how_many
from grammars.relatives import predicate
from grammars.sorts import (
    classes,
    is_abstract,
    is_kind_of_it,
    is_nothing,
    kind,
    may_be_called,
    usages,
)
from grammars.timing import tells_time
from grammars.usage import TIMES_OF_DAY
from grammars.ways import WAYS
from kernel.memory.contraries import PAIRS

if TYPE_CHECKING:
    from grammars.build import Build

SENSED: Final = ("see", "hear", "feel", "smell")
DENIALS: Final = ("neg", "not_has", "neg_own")


def names(clause: AList) -> bool:
    """It tells who somebody is."""
    pred = clause.find("pred")
    return pred is not None and pred.has("isname")


def clause(build: Build, part: AList, subject: str = "", topical: bool = False) -> str:
    """Draw a clause on the present board; the node of its predicate.

    Args:
        build: the drawing.
        part: the bracket that holds the clause's parts.
        subject: node it is about, where that is no noun phrase of the clause.
        topical: its subject is what the sentence is about.
    """
    build.negative = False
    part = seen_from_robot(part)
    negated = any(part.has(denial) for denial in DENIALS)
    if (exists := part.find("exists")) is not None:
        return _exists(build, exists)
    if (ordered := part.find("ordered")) is not None:
        act = build.act_or_any(ordered.find("action"))
        return told(build, ordered.first("np"), act)
    if (done := part.find("undergone")) is not None:
        return undergone(build, part, done, negated)
    if part.has("asking_me"):  # "without asking"
        return build.add("act", "ask", agt=build.oneself("you"), dest=build.oneself("me"))
    if (failing := part.find("failing")) is not None:
        if (sensed := failing.find("action")) is not None and sensed.slot("act") in SENSED:
            act = build.action(sensed)  # "you can not see anything"
            build.sketch.link(act, "agt", build.oneself("you"))
            build.sketch.change(act, negated=True)
            return act
        act = build.act_or_any(failing.find("action"))
        return build.add("act", "fail", agt=build.oneself("you"), obj=act)
    if (all_so := part.find("all_so")) is not None:
        return _all_so(build, all_so)
    if part.has("speaking"):  # "without saying goodbye"
        who = build.oneself("you")
        act = build.action(part)
        build.sketch.link(act, "agt", who)
        return act
    objects = part.all("np", "base_np")
    if subject:
        agent = subject
    elif part.has("going") and not objects:  # "after grabbing a vase"
        agent = build.oneself("you")
    elif objects:
        agent = _subject(build, np := objects.pop(0), part)
        if negated and not is_nothing(np):  # "something is not red"
            build.not_all(agent, np)
    else:
        raise NoMeaningError(str(part))
    build.topic = agent if topical else build.topic
    negated = negated or build.negative
    if (pred := part.find("pred")) is not None:
        before = len(build.board)
        main = predicate(build, agent, pred, negated)
        said = build.board[before:]
        build.claims.update(n for n in said if ("hq", agent) in build.sketch.terms[n].links)
        return main
    if (owner := part.find("owner_of")) is not None:
        return build.owned(agent, owner, negated)
    if (qual := part.find("qual")) is not None:
        if qual.slot("hq") in WAYS:  # "the light turns right"
            raise NoMeaningError(str(part))
        return build.quality(agent, qual, negated)
    if (where := part.find("whereis")) is not None:
        return build.add("act", "ask", agt=agent, obj=build.whereabouts(where))
    if (listener := part.find("listener")) is not None and listener.parts:
        asked = build.thing(listener, person=True)
        verb = "tell" if part.has("tell") else "ask"
        return build.add("act", verb, agt=agent, dest=asked, negated=negated)
    if part.slot("quote").lower() == "so" or (
        part.has("able") and not (build.telling or _is_sensing(part))
    ):
        raise NoMeaningError(str(part))  # "unless I say so"
    if part.has("quote"):
        txt = build.add("txt", literal=part.slot("quote"))
        return build.add("act", "say", agt=agent, obj=txt)
    if part.has("habit") or part.has("habit_s"):
        return doing(build, part.first("habit", "habit_s"), agent, objects, negated)
    if (part.has("does") and not part.has("counted")) or part.has("going"):
        return doing(build, part, agent, objects, negated)
    if (counted := part.find("counted")) is not None:
        many = build.thing(_counted(counted))
        build.add("cnt", literal=how_many(build, counted), cnt=many)
        does = build.add("act", part.slot("does", "have"), agt=agent, obj=many, negated=negated)
        return had(build, part, does)
    if objects and not (build.telling and is_abstract(objects[0])):
        owned = build.thing(objects[0])
        has = build.add("act", "have", agt=agent, obj=owned, negated=negated or build.negative)
        return had(build, part, has)
    raise NoMeaningError(str(part))


def _subject(build: Build, np: AList, part: AList) -> str:
    """Node of a clause's subject; who has a name may be "it" too: "unless it is Mary"."""
    pred = part.find("pred")
    kindof = None if pred is None else pred.find("kindof")
    if kindof is not None and not is_kind_of_it(np, kindof):
        raise NoMeaningError(str(part))
    if np.slot("pron") == "it" and build.pattern and tells_time(pred or part):
        return build.add("obj", ref="it")
    if kind(np) in classes()["parts"] and "willing" in usages(part.slot("does")):
        raise NoMeaningError(str(part))  # "the gripper orders something"
    if _is_hour(pred) and np.slot("pron") != "it":
        raise NoMeaningError(str(part))  # "the gripper is morning"
    if names(part) and (not may_be_called(np) or (build.pattern and kind(np) == "name")):
        raise NoMeaningError(str(part))
    if np.slot("pron") == "it" and names(part):
        return build.pronoun("they")
    return build.thing(np)


def _is_sensing(part: AList) -> bool:
    """What one can see is seen."""
    return part.slot("does") in SENSED


def _is_hour(pred: AList | None) -> bool:
    """It tells what time of day it is."""
    return pred is not None and any(qual.slot("hq") in TIMES_OF_DAY for qual in pred.all("qual"))


def _exists(build: Build, exists: AList) -> str:
    """ "There is something close": the quality of the thing, or its kind, is the predicate."""
    before = len(build.board)
    if (counted := exists.find("counted")) is not None:
        name = build.thing(_counted(counted))
        build.add("cnt", literal=how_many(build, counted), cnt=name)
    else:
        name = build.thing(exists.first("np"))
    if here := exists.slot("hereabouts"):
        build.add("loc", here, loc=name)
    negated = build.negative or exists.has("neg")
    if (near := exists.find("qual")) is not None:  # "there is nobody around"
        return build.quality(name, near, negated)
    said = [build.sketch.terms[n] for n in build.board[before:] if build.sketch.terms[n].links]
    for role in ("loc", "hq", "ako") if negated else ("hq", "loc", "ako"):
        for term in said:
            if (role, name) in term.links:
                build.sketch.change(term.name, negated=negated)
                return term.name
    raise NoMeaningError(str(exists))


def _counted(counted: AList) -> AList:
    """What there are so many of."""
    return AList("np", tuple(p for p in counted if p.name != "num" and p.name not in SO_MANY))


def _all_so(build: Build, all_so: AList) -> str:
    """ "Everybody is awake": nobody is asleep. Of what has no one contrary the net cannot say it."""
    quality = all_so.slot("hq")
    contrary = [word for group in PAIRS if quality in group for word in group - {quality}]
    if not contrary:
        raise NoMeaningError(str(all_so))
    vague = "something" if all_so.has("everything") else "somebody"
    who = build.thing(AList("np", (AList("vague", value=vague),)))
    return build.add("hq", contrary[0], hq=who, negated=True)


def told(build: Build, speaker: AList, act: str) -> str:
    """Somebody tells the robot to do the act."""
    teller = build.thing(speaker, person=True)
    return build.add("act", "tell", agt=teller, dest=build.oneself("you"), cmd=act)
