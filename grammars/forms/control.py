"""Control: stop, cancel, undo, forget, repeat, go on, what was learned."""

from __future__ import annotations

from typing import Final, get_args

from grammars.alist import AList
from grammars.build import Build, NoMeaningError
from grammars.registry import FORMS, sentence_form
from kernel.memory.meaning import Act, Control, Fact, Teach

EXAMPLES = (
    "stop",
    "halt right now",
    "stop turning",
    "would you stop complaining",
    "you can stop now",
    "never mind",
    "you don't have to fetch the cup any more",
    "undo that",
    "undo everything from today",
    "forget how to dance",
    "forget the last lesson",
    "forget what I told you about Mary",
    "forget that Mary is a girl",
    "forget that if something is very close you should drive backwards",
    "keep both",
    "replace it",
    "Repeat that.",
    "go on",
    "continue dancing",
    "what did you learn today",
    "tell me everything you learned today",
    "what did Mary teach you",
    "forget everything about the red block",
    "forget everything you learned today",
)
ACTS: Final[tuple[Act, ...]] = get_args(Act)


@sentence_form("control", "control", EXAMPLES)
def control(alist: AList) -> Control:
    """What to do with what is going on, and with which action of it."""
    act = next((act for act in ACTS if alist.has(act)), ACTS[0])
    forget = alist.find("forget")
    if forget is not None and (told := forget.find("told_again")) is not None:
        (again,) = told.parts
        if again.has("several"):
            raise NoMeaningError("more than one lesson")
        meaning = FORMS[again.name].build(again)
        if not isinstance(meaning, Teach | Fact):
            raise NoMeaningError(str(alist))
        return Control(act, told=meaning)
    build = Build()
    with build.drawing(pattern=True):
        if (thing := (forget or alist.find("learned") or alist).find("np")) is not None:
            return Control(act, build.graphlet(build.thing(thing)))
    if forget is not None and (teacher := forget.find("teacher")) is not None:
        with build.drawing(pattern=True):
            who = build.thing(teacher.first("np"), person=True)
            taught = build.add("act", "teach", agt=who, dest=build.oneself("you"))
            return Control(act, build.graphlet(taught))
    named = (forget or alist.find("cancel", "resume") or alist).all("action", "gerunding", "act")
    if len(named) > 1 and forget is None:
        return Control(act)
    acts = []
    for action in named:
        with build.drawing(pattern=True, trigger=True):  # "greet somebody", as it was taught
            acts.append(build.graphlet(build.action(action)))
    return Control(act, acts[0] if acts else None, more=tuple(acts[1:]))
