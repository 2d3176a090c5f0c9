"""Qualities that regard something else into nets: "taller than Mary", "the same size as the ball", "afraid of cats"."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from grammars.alist import AList

if TYPE_CHECKING:
    from grammars.build import Build
    from grammars.things import Things

MUCH: Final = {"a bit": "little", "a little": "little", "slightly": "little", "even": "even"}
# "Within ten inches", "more than two feet away".
APART: Final = {"nearer": "close", "farther": "far"}
SAME: Final = "same"


def comparison(build: Things, name: str, compared: AList, negated: bool) -> str:
    """Say of a thing how it compares with another; the node of that."""
    apart = compared.find(*APART) or compared
    if (measure := apart.find("measure")) is not None:  # "closer than ten inches"
        hq = build.add(
            "hq", APART.get(apart.name) or compared.slot("adjer"), hq=name, negated=negated
        )
        build.add("deg", "more", deg=hq)
        build.add("amt", measure.slot("unit"), literal=measure.slot("num"), amt=hq)
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


def regarding(build: Build, who: str, complement: AList, negated: bool = False) -> str:
    """ "Afraid of cats", "tired of turning", "married to Lucy"."""
    hq = build.quality(who, complement, negated)
    doing = complement.find("gerunding")
    about = build.thing(complement.first("np")) if doing is None else build.action(doing)
    build.add("loc", complement.slot("regard", "of"), loc=hq, wrt=about)
    return hq
