"""What is so when a lesson is followed: conditions, exceptions and enablements into graphlets."""

from __future__ import annotations

from typing import TYPE_CHECKING

from grammars.alist import AList
from grammars.clauses import clause
from grammars.mentions import left_out
from grammars.mutual import of_each
from grammars.timing import it_is, o_clock
from kernel.net.graphlet import Graphlet

if TYPE_CHECKING:
    from grammars.build import Build


def flat(conds: AList) -> list[AList]:
    """The clauses of a list of conditions."""
    inner = [clause for part in conds.all("conds") for clause in flat(part)]
    return [*(each for part in conds.all("clause") for each in of_each(part)), *inner]


def condition(build: Build, conds: AList) -> Graphlet:
    """All conditions in one graphlet; main is the predicate of the first."""
    with build.drawing(pattern=True):
        return stated(build, conds)


def stated(build: Build, conds: AList) -> Graphlet:
    """The same on the present board: what is definite is looked up where that is drawn no pattern."""
    if (time := conds.slot("daypart")) or (time := o_clock(conds.find("hour"))):
        return build.graphlet(it_is(build, time))
    if len(conds.parts) == 1 and conds.has("conds"):
        return stated(build, conds.first("conds"))
    first, *more = flat(conds) or [conds]
    mains = [clause(build, first, topical=True), *(clause(build, part) for part in more)]
    build.claims.update(mains)
    return build.graphlet(mains[0])


def exception(build: Build, alist: AList) -> tuple[Graphlet, ...]:
    """What stands after "unless", each way out by itself."""
    if (excepted := alist.find("excepted")) is not None:
        alist = AList(alist.name, (left_out(excepted.first("np")),))
    found = alist.find("exception")
    if found is None:
        return ()
    return (condition(build, found.first("conds")), *exception(build, found))


def enablement(build: Build, alist: AList) -> tuple[Graphlet, ...]:
    """What stands after "if" or "while" where an action is the trigger."""
    return tuple(condition(build, conds) for conds in alist.all("conds"))
