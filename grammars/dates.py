"""Days: "today is Tuesday" tells of today what day it is, "tomorrow is my birthday" of what kind that day is."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from grammars.alist import AList
from grammars.errors import NoMeaningError
from grammars.relatives import kind_of
from grammars.sorts import classes, kind
from kernel.memory.meaning import Question

if TYPE_CHECKING:
    from grammars.build import Build

TODAY: Final = AList("np", (AList("name", value="today"),))
PARTS: Final = ("own", "owner", "ako", "sub", "qual")


def dated(build: Build, said: AList) -> str:
    """Node of what a day is said to be; "it" is today."""
    days = [np for np in said.all("np") if np.slot("name") in classes()["days"]]
    day = build.thing(days[0] if days else TODAY)
    negated = said.has("neg")
    pred, owned = said.find("pred"), [np for np in said.all("np") if np not in days]
    if pred is not None and pred.value is not None:
        if pred.value not in classes()["weekdays"]:
            raise NoMeaningError(str(said))
        return build.add("hq", pred.value, hq=day, negated=negated)
    kindof = AList("kindof", owned[0].parts) if pred is None else pred.first("kindof")
    if kind(kindof) not in classes()["occasions"] or not all(p.name in PARTS for p in kindof):
        raise NoMeaningError(str(said))
    return kind_of(build, day, kindof, negated)


def day_asked(build: Build, body: AList) -> Question:
    """ "Is it Monday", "what day is tomorrow"."""
    if body.name == "day_so":
        return Question("yesno", build.graphlet(dated(build, body)))
    day = body.find("np") or TODAY
    if not day.has("name") and kind(day) not in classes()["occasions"]:  # "when is the bus"
        raise NoMeaningError(str(body))
    hq = build.add("hq", hq=build.thing(day))
    return Question("what", build.graphlet(hq), hq)
