"""Permissions: operators on ALLOW, which void the prohibitions they are at least as specific as."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.conditions import enablement, exception
from grammars.registry import sentence_form
from grammars.timing import by_time
from grammars.triggers import settled, taken_up
from kernel.action.chain import Chain, Directive, Play
from kernel.memory.lesson import Operator
from kernel.memory.meaning import Teach
from kernel.net.graphlet import Graphlet

# What "only" is said of, the likeliest first.
NARROWING: Final = ("manner", "amt", "cnt", "place", "dest", "np", "dir")
EXAMPLES = (
    "you can grab a person if she is hurt",
    "it is okay to lift the toy cat",
    "You may touch my sneakers.",
    "you are allowed to drive backwards now",
    "you may turn left again",
)


@sentence_form("permission", "permission", EXAMPLES)
def permission(alist: AList) -> Teach:
    """An exception to what is forbidden."""
    build = Build()
    if alist.has("is_fine") and any(part.has("speech") for part in alist.all("action")):
        raise NoMeaningError("a question to be asked")  # "ask Mary if she is okay"
    first = alist.parts[0].name == "conds"
    before = enablement(build, alist) if first else ()
    times: tuple[Graphlet, ...] = ()
    with build.drawing(pattern=True):
        if alist.has("no_further"):
            times, trigger = (
                (),
                build.graphlet(build.add("act", dest=build.aside(alist.first("np")))),
            )
        else:
            deed, times = by_time(build, _once_more(_deed(alist)))
            trigger = build.graphlet(build.action(deed))
    if first:
        trigger, before = settled(build, trigger, before)
    operator = Operator(
        Directive("ALLOW", trigger),
        Chain(),
        enablement=(*times, *(before or enablement(build, alist))),
        unless=exception(build, alist),
    )
    return Teach("permission", operator, _but_not(build, alist, operator))


def _deed(alist: AList) -> AList:
    """What may be done; of "you are allowed upstairs" going there."""
    if (there := alist.find("there")) is not None:
        return AList("action", (AList("act", value="go"), *there.parts))
    return alist.first("action", "gerunding")


def _but_not(build: Build, alist: AList, allowed: Operator) -> tuple[Operator, ...]:
    """What is forbidden in the same breath: "you may touch the cup but not the vase", "but never touch the vase"."""
    if (banned := alist.find("but_never")) is not None:
        return (_forbidden(build, banned.first("action"), allowed),)
    if (barred := alist.find("barred")) is not None:
        with build.drawing(pattern=True, trigger=True):
            away = build.graphlet(build.add("act", dest=build.aside(barred.first("np"))))
        return (Operator(Directive("ANTE", away), Chain((Play((Directive("PUNT"),)),))),)
    if alist.has("only_so") and not alist.has("conds"):
        return (_forbidden(build, _in_general(alist.first("action")), allowed),)
    if (left_out := alist.find("not_that")) is None:
        return ()
    if (deed := left_out.find("action")) is not None:
        return (_forbidden(build, deed, allowed),)
    action, (other, *_) = alist.first("action"), left_out.parts
    if not action.has(other.name) or (other.name == "np" and action.parts[-1].name != "np"):
        raise NoMeaningError(str(left_out))
    last = [part for part in action if part.name == other.name][-1]
    parts = tuple(other if part is last else part for part in action)
    return (_forbidden(build, AList("action", parts), allowed),)


def _forbidden(build: Build, action: AList, allowed: Operator) -> Operator:
    """A plain veto upon it."""
    with build.drawing(pattern=True, trigger=True):
        trigger = taken_up(build.graphlet(build.action(action)), allowed)
    return Operator(Directive("ANTE", trigger), Chain((Play((Directive("PUNT"),)),)))


def _in_general(action: AList) -> AList:
    """The deed without what it is narrowed down by, such as touching "something" for "the red block"."""
    narrow = next((action.first(name) for name in NARROWING if action.has(name)), None)
    if narrow is None:
        raise NoMeaningError(str(action))
    anything = (AList("np", (AList("vague", value="something"),)),) if narrow.name == "np" else ()
    rest = tuple(part for part in action if part is not narrow)
    return AList(action.name, (*rest, *anything))


def _once_more(action: AList) -> AList:
    """ "You may turn left again" permits turning left, not only doing so again."""
    return AList(
        action.name,
        tuple(part for part in action if not _is_again(part)),
        action.value,
    )


def _is_again(part: AList) -> bool:
    return part.name == "manner" and "again" in (part.value, part.slot("adv"))
