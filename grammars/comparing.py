"""Qualities that regard something else into nets: "taller than Mary", "the same size as the ball", "afraid of cats"."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from grammars.alist import AList
from grammars.errors import NoMeaningError
from grammars.pacing import TIMES

if TYPE_CHECKING:
    from grammars.build import Build
    from grammars.things import Things

MUCH: Final = {"a bit": "little", "a little": "little", "slightly": "little", "even": "even"}
# "Within ten inches", "more than two feet away", "two feet away".
APART: Final = {"nearer": "close", "farther": "far", "distant": "away"}
SAME: Final = "same"


def comparison(build: Things, name: str, compared: AList, negated: bool) -> str:
    """Say of a thing how it compares with another; the node of that."""
    if (apart := compared.find(*APART)) is not None:
        return _distance(build, name, apart, negated)
    if (measure := compared.find("measure")) is not None:  # "closer than ten inches"
        hq = build.add("hq", compared.slot("adjer"), hq=name, negated=negated)
        build.add("deg", "more", deg=hq)
        _measured(build, hq, measure)
        return hq
    other = build.aside(compared.first("np"))
    roles = {"hq": name, "as": other}
    if (alike := compared.find("alike")) is not None:
        return build.add("hq", alike.slot("hq"), negated=negated, **roles)
    if (same := compared.find("same_sort")) is not None:
        hq = build.add("hq", SAME, negated=negated, **roles)
        if attribute := same.slot("attribute"):
            build.add("ako", attribute, ako=hq)
        return hq
    word = compared.slot("adjer") or compared.slot("hq")
    hq = build.add("hq", word, hq=name, than=other, negated=negated)
    for deg in compared.all("deg"):  # "much heavier than that"
        build.add("deg", MUCH.get(deg.value or "", "much"), deg=hq)
    return hq


def _distance(build: Things, name: str, apart: AList, negated: bool) -> str:
    """How far from the robot something is. Of what lies between two other things only the measure can be said."""
    other = apart.find("np")
    if "you" in build.sketch.terms[name].lex:
        raise NoMeaningError(str(apart))  # away from what
    if other is not None and other.slot("pron") != "you":
        if apart.name != "distant":
            raise NoMeaningError(str(apart))
        loc = build.add("loc", "from", loc=name, wrt=build.aside(other), negated=negated)
        _measured(build, loc, apart.first("measure"))
        return loc
    hq = build.add("hq", APART[apart.name], hq=name, negated=negated)
    if apart.name != "distant":
        build.add("deg", "more", deg=hq)
    _measured(build, hq, apart.first("measure"))
    return hq


def seen_from_robot(clause: AList) -> AList:
    """ "You are within a foot of the wall": the wall is."""
    subject, pred = clause.find("np", "base_np"), clause.find("pred")
    compared = None if pred is None else pred.find("compared")
    apart = None if compared is None else compared.find(*APART)
    if subject is None or pred is None or compared is None or apart is None:
        return clause
    if subject.slot("pron") != "you" or (other := apart.find("np")) is None:
        return clause
    apart = AList(apart.name, tuple(part for part in apart if part is not other))
    turned = {subject: other, pred: AList("pred", (AList("compared", (apart,)),))}
    return AList(clause.name, tuple(turned.get(part, part) for part in clause))


def _measured(build: Things, name: str, measure: AList) -> None:
    """So much of it."""
    unit = measure.slot("unit")
    if unit in TIMES:  # "the match is two minutes away"
        raise NoMeaningError(str(measure))
    build.add("amt", unit, literal=measure.slot("num", "1"), amt=name)


def regarding(build: Build, who: str, complement: AList, negated: bool = False) -> str:
    """ "Afraid of cats", "tired of turning", "married to Lucy"."""
    hq = build.quality(who, complement, negated)
    doing = complement.find("gerunding")
    about = build.thing(complement.first("np")) if doing is None else build.action(doing)
    build.add("loc", complement.slot("regard", "of"), loc=hq, wrt=about)
    return hq
