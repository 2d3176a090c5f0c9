"""What somebody or something is, has or does all the time, as a question asks it."""

from __future__ import annotations

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.clauses import clause
from grammars.comparing import regarding
from grammars.doings import WISHES
from grammars.questions.topics import does_so
from grammars.relatives import predicate


def state(build: Build, asks: AList, who: str) -> str:
    """What somebody or something is, has or does all the time."""
    if (pred := asks.find("pred")) is not None:
        return predicate(build, who, pred, negated=False)
    if (topmost := asks.find("topmost")) is not None:
        hq = build.quality(who, topmost)
        if (mark := topmost.find("np")) is not None:
            build.add("loc", "to", loc=hq, wrt=build.aside(mark))
        return hq
    if (complement := asks.find("complement")) is not None:  # "afraid of cats", "tired of turning"
        return regarding(build, who, complement)
    if (qual := asks.find("qual")) is not None:
        return build.quality(who, qual)
    if (does := asks.find("does_q")) is not None:
        if (verb := _alone(does)) == "have" or (verb in WISHES and not asks.has("modal_q")):
            return build.add("act", verb, agt=who)  # what, is asked
        offered = asks.slot("modal_q") == "would" and does.slot("state") in WISHES
        if offered or (does.slot("state") == "know" and does.has("dest")):
            raise NoMeaningError(str(does))  # "what would you like to drink", "know where it is"
        return does_so(build, does, who)
    if asks.has("habit") or asks.has("habit_s"):
        return clause(build, AList("q", tuple(asks.all("habit", "habit_s"))), who)
    if (owned := asks.find("owned")) is not None:
        counted = owned.find("counted")
        thing = build.thing(
            owned.first("np") if counted is None else AList("np", counted.parts[1:])
        )
        if counted is not None:
            build.add("cnt", literal=counted.slot("num"), cnt=thing)
        return build.add("act", "have", agt=who, obj=thing)
    if (been := asks.find("been_to")) is not None:
        there = build.add("loc", loc=who)
        if (np := been.find("np", "name")) is not None:
            build.sketch.link(there, "wrt", build.aside(np if np.name == "np" else been))
            build.sketch.change(there, lex=frozenset(("in",)))
        return there
    raise NoMeaningError(str(asks))


def _alone(does: AList) -> str:
    """The verb, where nothing stands with it."""
    return does.value or (does.slot("state") if len(does.parts) == 1 else "")
