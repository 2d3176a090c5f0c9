"""Prohibitions: operators on ANTE that end in PUNT."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.conditions import enablement, exception
from grammars.registry import sentence_form
from grammars.remarks import MENTAL
from grammars.sorts import classes, kind, usages
from grammars.timing import by_time
from grammars.triggers import settled, taken_up
from grammars.vocabulary import BORN
from kernel.action.chain import Chain, Directive, Play
from kernel.memory.lesson import Operator
from kernel.memory.meaning import Teach

INWARD: Final = MENTAL | set("trust obey understand have lose win cost fit hope".split())
EXAMPLES = (
    "Never touch my sneakers!",
    "You should never grab a person but instead say I'm not allowed to.",
    "don't ever lift a cat",
    "no shouting",
    "the vase must never be touched",
    "nothing on my desk is to be touched",
    "touching people is forbidden",
    "don't raise the lift if something is close",
    "if something is close, don't raise the lift",
    "Do not turn while you are holding something.",
    "never lift a cup unless it is empty",
)


@sentence_form("prohibition", "prohibition", EXAMPLES)
def prohibition(alist: AList) -> Teach:
    """A veto on an action, with what to do instead, when it holds and when it does not."""
    build = Build()
    deeds = ("there", "action", "not_one", "gerunding", "np", "conds")
    first = next(part.name for part in alist if part.name in deeds)
    before = enablement(build, alist) if first == "conds" else ()
    deed, times = by_time(build, _done(alist))
    if deed.slot("act") in INWARD or _is_proverb(deed):
        raise NoMeaningError(str(deed))
    with build.drawing(pattern=True, trigger=True):
        trigger = build.graphlet(
            build.add("act", dest=build.aside(deed))
            if alist.has("keep_off")
            else build.action(deed)
        )
        if alist.has("none_to") and not build.negative:
            raise NoMeaningError("what must be done")
    after = enablement(build, alist) if first != "conds" else ()
    instead = alist.find("chain")
    plays = () if instead is None else build.chain(instead).plays
    if before:
        trigger, before = settled(build, trigger, before)
    operator = Operator(
        Directive("ANTE", trigger),
        Chain((*plays, Play((Directive("PUNT"),)))),
        enablement=(*times, *(before or after)),
        unless=exception(build, alist),
    )
    return Teach("prohibition", operator, _but_may(build, alist, operator))


def _is_proverb(deed: AList) -> bool:
    """ "Never bite the hand that feeds you"."""
    things = deed.all("np") if "VERB" not in BORN.readings(deed.slot("act")) else []
    return any(rel.has("habit_s") for np in things for rel in np.all("rel"))


def _but_may(build: Build, alist: AList, banned: Operator) -> tuple[Operator, ...]:
    """What is allowed in the same breath: "never touch the vase, but you may touch the cup"."""
    if (allowed := alist.find("but_may")) is None:
        return ()
    with build.drawing(pattern=True):
        trigger = taken_up(build.graphlet(build.action(allowed.first("action"))), banned)
    return (Operator(Directive("ALLOW", trigger), Chain()),)


def _done(alist: AList) -> AList:
    """The deed; of "the vase must not be touched" too. What is kept away from is not done, but gone to."""
    if alist.has("keep_off"):
        return alist.first("np")
    if (there := alist.find("there")) is not None:
        return AList("action", (AList("act", value="go"), *there.parts))
    if (single := alist.find("not_one")) is not None:
        touched = single.first("np")
        if not kind(touched) and "taking" not in usages(single.slot("act")):
            raise NoMeaningError(str(single))  # "fear nothing"
        return AList("action", single.parts)
    if alist.has("off") and kind(alist.first("np")) in classes()["rooms"]:
        raise NoMeaningError("it is left for another")  # "leave the kitchen unless I say stay"
    if (verb := alist.find("done_to", "none_to")) is None and not alist.has("off"):
        return alist.first("action", "gerunding")
    np = alist.first("np")
    if np.has("pron") and verb is not None:
        raise NoMeaningError("it can not be helped")
    return AList("action", (AList("act", value="touch" if verb is None else verb.value), np))
