"""Clauses into nets: conditions of reactions and rules, and what facts say."""

from __future__ import annotations

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from kernel.net.graphlet import Graphlet


def flat(conds: AList) -> list[AList]:
    """The clauses of a list of conditions."""
    inner = [clause for part in conds.all("conds") for clause in flat(part)]
    return [*conds.all("clause"), *inner]


def condition(build: Build, conds: AList) -> Graphlet:
    """All conditions in one graphlet; main is the predicate of the first."""
    with build.drawing(pattern=True):
        mains = [clause(build, part) for part in flat(conds)]
        return build.graphlet(mains[0])


def clause(build: Build, part: AList) -> str:
    """Draw a clause on the present board; the node of its predicate."""
    build.negative = False
    negated = part.has("neg") or part.has("not_has")
    if (exists := part.find("exists")) is not None:
        return _exists(build, exists)
    subject = part.find("np", "base_np")
    if subject is None:
        raise NoMeaningError(str(part))
    agent = build.thing(subject)
    negated = negated or build.negative
    if (pred := part.find("pred")) is not None:
        return build.predicate(agent, pred, negated)
    if (qual := part.find("qual")) is not None:
        return build.quality(agent, qual, negated)
    verb = part.find("does", "going")
    objects = part.all("np")[1:] if subject.name == "np" else part.all("np")
    if verb is None:
        owned = build.thing(objects[0])
        return build.add("act", "have", agt=agent, obj=owned, negated=negated or build.negative)
    return _doing(build, part, agent, negated)


def _exists(build: Build, exists: AList) -> str:
    """ "There is something close": the quality of the thing, or its kind, is the predicate."""
    before = len(build.board)
    name = build.thing(exists.first("np"))
    if build.negative:
        raise NoMeaningError(str(exists))
    said = [build.sketch.terms[n] for n in build.board[before:] if build.sketch.terms[n].links]
    for role in ("hq", "loc", "ako"):
        for term in said:
            if (role, name) in term.links:
                return term.name
    raise NoMeaningError(str(exists))


def _doing(build: Build, part: AList, agent: str, negated: bool) -> str:
    going = part.find("going")
    if going is not None and not part.has("does"):
        verb = going.slot("gerund") or going.value or ""
        body = going
    else:
        verb, body = part.slot("does"), part
    links: dict[str, str] = {"agt": agent}
    objects = [np for np in body.all("np") if not (body is part and np is part.find("np", "base_np"))]
    if objects:
        links["obj"] = build.thing(objects[0])
    if (dest := body.find("dest")) is not None:
        links["dest"] = build.thing(dest.first("np"))
    act = build.add("act", verb, negated=negated or build.negative, **links)
    build.modifiers(act, body)
    if going is not None and body is part and objects:
        build.add("act", going.slot("gerund") or going.value or "", agt=links["obj"])
    return act
