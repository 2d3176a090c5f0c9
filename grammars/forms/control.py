"""Control: stop, cancel, undo, forget, repeat, go on, what was learned."""

from __future__ import annotations

from typing import Final, Literal

from grammars.alist import AList
from grammars.build import Build
from grammars.registry import sentence_form
from kernel.memory.meaning import Control

EXAMPLES = (
    "stop",
    "halt right now",
    "stop turning",
    "never mind",
    "undo that",
    "forget how to dance",
    "Repeat that.",
    "go on",
    "what did you learn today",
)
Act = Literal["stop", "cancel", "undo", "forget", "repeat", "resume", "learned"]
ACTS: Final[tuple[Act, ...]] = (
    "stop",
    "cancel",
    "undo",
    "forget",
    "repeat",
    "resume",
    "learned",
)


@sentence_form("control", "control", EXAMPLES)
def control(alist: AList) -> Control:
    """What to do with what is going on, and with which action of it."""
    about = alist.find("gerunding")
    act = next((act for act in ACTS if alist.has(act)), ACTS[0])
    if (forget := alist.find("forget")) is not None:
        about = forget.find("action", "gerunding")
    if about is None:
        return Control(act)
    build = Build()
    with build.drawing(pattern=True):
        return Control(act, build.graphlet(build.action(about)))
