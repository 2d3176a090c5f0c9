"""Steps of a lesson: which one is meant, and steps in another order."""

from __future__ import annotations

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from kernel.action.chain import Directive, sequence
from kernel.memory.meaning import Beside, Revision
from kernel.net.graphlet import Graphlet


def reordered(build: Build, order: AList, of: Graphlet | None) -> Revision:
    """ "Swap the first two steps", "the wave should come before the bow"."""
    if (two := order.find("first_two")) is not None and two.slot("num") != "2":
        raise NoMeaningError(str(order))
    if order.has("first_two"):
        first, second = step_at(build, "first"), step_at(build, "second")
        return Revision(sequence(Directive("DO", second)), first, of, moved=True)
    moved, *others = (step_named(build, part) for part in order.all("stepping"))
    moving = sequence(Directive("DO", moved))
    if others:  # they change places
        return Revision(sequence(Directive("DO", others[0])), moved, of, moved=True)
    if order.has("at_end"):
        return Revision(moving, None, of, last=True, moved=True)
    beside = order.find("ahead_of", "behind")
    if beside is not None:
        where: Beside = "after" if beside.name == "behind" else "before"
        return Revision(
            moving, step_named(build, beside.first("stepping")), of, beside=where, moved=True
        )
    if not order.has("at_start"):  # between two
        raise NoMeaningError(str(order))
    return Revision(moving, step_at(build, "first"), of, beside="before", moved=True)


def step_named(build: Build, named: AList) -> Graphlet:
    """The step that is named or told by its place: "the last step", "the second turn", "turning left"."""
    with build.drawing(pattern=True):
        if (nth := named.find("nth")) is not None:
            return step_at(build, nth.slot("ord"))
        act = build.action(
            AList(named.name, tuple(part for part in named if part.name != "ord"), named.value)
        )
        if place := named.slot("ord"):
            build.add("hq", place, hq=act)
        return build.graphlet(act)


def step_at(build: Build, place: str) -> Graphlet:
    """The step in that place of the chain."""
    with build.drawing(pattern=True):
        step = build.add("act")
        build.add("hq", place, hq=step)
        return build.graphlet(step)
