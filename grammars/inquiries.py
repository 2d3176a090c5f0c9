"""What is to be found out, into nets: whether something is so, what it is like, of what kind it is or where."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from grammars.alist import AList
from grammars.clauses import names
from grammars.conditions import flat, stated
from grammars.errors import NoMeaningError
from grammars.mentions import Thing, somebody
from grammars.sorts import is_attribute, is_bare, kind, usages
from kernel.action.chain import Directive

if TYPE_CHECKING:
    from grammars.build import Build

WONDERS: Final = {"what_like": "hq", "what_kind": "ako", "whereabout": "loc"}


def inquired(build: Build, inquiry: AList) -> Directive:
    """To find something out as a step: what is definite is looked up first, "something" is any thing."""
    before, build.telling = build.telling, True
    with build.drawing(pattern=False):
        directive = sought(build, inquiry)
    build.telling = before
    return directive


def sought(build: Build, inquiry: AList) -> Directive:
    """CHK for whether something is so; FIND for what something is like, of what kind it is or where."""
    if (whether := inquiry.find("whether")) is not None:
        conds = whether.first("conds")
        if any(names(said) and kind(said.first("np")) for said in flat(conds)):
            raise NoMeaningError(str(whether))  # "whether the gripper is Mary"
        return Directive("CHK", stated(build, conds))
    if (asked := inquiry.find("who_where")) is not None:
        return Directive("FIND", build.graphlet(build.thing(somebody(asked.first("loc")))))
    if inquiry.has("nearby"):
        return Directive("DO", build.graphlet(build.add("act", "look around")))
    if (done := inquiry.find("what_done")) is not None:
        uses = usages(done.slot("does"))
        if "alone" in uses or ("having" not in uses and is_attribute(done.slot("attribute"))):
            raise NoMeaningError(str(done))  # "what color the block cha-chas"
        wanted = build.add("obj")
        build.add("ako", done.slot("attribute"), ako=wanted)
        build.add("act", done.slot("does"), agt=build.aside(done.first("np")), obj=wanted)
        build.things.append(Thing(wanted, done.slot("attribute")))
        return Directive("FIND", build.graphlet(wanted))
    if (how := inquiry.find("how_so")) is not None:  # "how heavy it is"
        hq = build.quality(_asked_of(build, how), how)
        return Directive("FIND", build.graphlet(build.add("deg", deg=hq)))
    for name, sort in WONDERS.items():
        if (asked := inquiry.find(name)) is not None:
            thing = _asked_of(build, asked)
            wanted = build.add(sort, **{sort: thing})
            if attribute := asked.slot("attribute"):
                if not is_attribute(attribute):
                    raise NoMeaningError(str(asked))  # "what burrito the block is"
                build.add("ako", attribute, ako=wanted)
            return Directive("FIND", build.graphlet(wanted))
    raise NoMeaningError(str(inquiry))


def _asked_of(build: Build, asked: AList) -> str:
    """Whose nature or whereabouts are asked: "what color it is", "its color", "the color of it"."""
    if own := asked.slot("own"):
        return build.whom(own)
    np = asked.first("np", "owner")
    if is_bare(np) and any(rel.has("going") for rel in np.all("rel")):
        raise NoMeaningError(str(np))  # "what color yodeling the block is"
    return build.thing(np)
