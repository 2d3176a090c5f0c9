"""When and how often something is done, as brackets: in a while, every two seconds, three times with pauses."""

from __future__ import annotations

from typing import Final

from grammars.alist import AList
from grammars.errors import NoMeaningError

TIMES: Final = frozenset(("second", "minute", "hour"))
FINER: Final = {"minute": ("second", 60), "hour": ("minute", 60)}
# What one does without end: no deed beside another, and no event.
HOLDING: Final = frozenset("hold carry have see hear".split())


def whole(number: str) -> int:
    """The number of things or times, of which there are no halves."""
    if not number.isdecimal():
        raise NoMeaningError(number)
    return int(number)


def count(cnt: AList) -> str:
    """How many times, in digits."""
    for name, times in (("twice", "2"), ("thrice", "3")):
        if cnt.has(name) or cnt.value == name:
            return times
    return cnt.slot("num", "1")


def in_a_while(play: AList) -> AList | None:
    """What is to be done in a while, where the play is that alone."""
    action = play.find("delayed", "action")
    return (
        action if action is not None and len(play.parts) == 1 and action.has("in_a_while") else None
    )


def _is_back(action: AList) -> bool:
    """ "Back in an hour": who is there again, and no way to drive."""
    return (action.value or action.slot("act")) == "back" and not action.has("dir")


def waited(delayed: AList) -> AList:
    """ "In ten seconds turn left": wait as long, then do it."""
    action = delayed.find("action") or delayed
    amt = (delayed if action is not delayed else action).first("in_a_while").first("amt")
    wait = _waiting(amt)
    if _is_back(action):
        raise NoMeaningError(str(delayed))
    now = AList("action", tuple(part for part in action if part.name != "in_a_while"))
    return AList("chain", tuple(AList("play", (a,)) for a in (wait, now)))


def paced(loop: AList) -> AList:
    """ "Beep every two seconds": again and again that, and beside it to wait so long."""
    if (pace := loop.find("paced")) is None:
        return loop
    amt, again = pace.first("amt"), loop.first("play")
    if (cnt := pace.find("cnt")) is not None:  # "twice a second", "ten times a minute"
        unit, parts = FINER.get(amt.slot("unit"), (amt.slot("unit"), 1))
        each = AList("num", value=f"{parts / whole(count(cnt)):.2g}")
        amt = AList("amt", (each, AList("unit", value=unit)))
    both = AList("play", (*again.parts, _waiting(amt)))
    return AList(
        loop.name, tuple(both if part is again else part for part in loop if part is not pace)
    )


def spaced(spaced: AList) -> AList:
    """ "Turn left three times, pausing a second between each": all rounds but the last are waited after."""
    pause, again = spaced.first("amt"), spaced.first("play", "chain")
    cnt = spaced.find("cnt")
    if again.name == "play":
        once, cnt = _once(again.parts[0])
        again = AList("chain", (AList("play", (once, *again.parts[1:])),))
    if cnt is None or len(again.parts[0].parts) > 1:
        raise NoMeaningError(str(spaced))
    rounds = whole(count(cnt)) - (0 if spaced.has("each_time") else 1)
    wait = AList("play", (_waiting(pause),))
    rest = () if spaced.has("each_time") else again.parts
    if rounds < 1:
        raise NoMeaningError(str(spaced))
    if rounds == 1:
        return AList("chain", (*again.parts, wait, *rest))
    times = AList("cnt", (AList("num", value=str(rounds)),))
    loop = AList("loop", (AList("chain", (*again.parts, wait)), times))
    return AList("chain", (AList("play", (loop,)), *rest))


def _once(action: AList) -> tuple[AList, AList | None]:
    """The deed, or what is said, without how many times; and that."""
    said = action.find("speech") or action
    cnt = said.find("cnt")
    once = AList(said.name, tuple(part for part in said if part is not cnt), said.value)
    if said is action:
        return once, cnt
    return AList(action.name, tuple(once if part is said else part for part in action)), cnt


def _waiting(amt: AList) -> AList:
    """To wait so long: no inches."""
    if amt.slot("unit") not in TIMES:
        raise NoMeaningError(str(amt))
    return AList("action", (AList("act", value="wait"), amt))
