"""Plays into nets: acts side by side, loops, and what is watched, brought about or stopped."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from grammars.alist import AList
from grammars.clauses import clause, condition
from grammars.things import NoMeaningError
from kernel.action.chain import Chain, Directive, Loop, Part, Play
from kernel.net.graphlet import Graphlet, Term

if TYPE_CHECKING:
    from grammars.build import Build


TURNS: Final = frozenset(("left", "right", "clockwise", "counterclockwise", "around"))
TIMES: Final = frozenset(("second", "minute", "hour"))
LIFTS: Final = {"up": "raise", "down": "lower"}


def plays(build: Build, play: AList) -> list[Play]:
    """A play, and before it the look-ups it needs."""
    required: list[Part] = []
    beside: list[Part] = []
    for part in play:
        match part.name:
            case "action" | "acting":
                with build.drawing(pattern=False):
                    required.append(Directive("DO", build.graphlet(build.action(part))))
            case "inquiry":
                required.append(build.inquired(part))
            case "loop":
                required.append(_loop(build, part))
            case "ensuring":
                required.append(Directive("ACH", _claim(build, part.first("clause"))))
            case "keeping":
                beside.append(Directive("KEEP", _claim(build, part)))
            case "waiting":
                required.append(Directive("WAIT", condition(build, part.first("conds"))))
            case "ceasing":
                with build.drawing(pattern=True):
                    act = build.action(part.first("gerunding"))
                    required.append(Directive("STOP", build.graphlet(act)))
    whole = Play(tuple(required), tuple(beside)) if required else Play(tuple(beside))
    made = [*build.looked_up(), whole]
    if build.each is not None:
        made, build.each = [Play((Loop(Chain(tuple(made)), each=build.each),))], None
    return made


def _claim(build: Build, part: AList) -> Graphlet:
    """What is to be so; the things it is about are looked up before, "something" and "nothing" are not."""
    known = len(build.finds)
    with build.drawing(pattern=False):
        claim = build.graphlet(clause(build, part))
    build.finds[known:] = [g for g in build.finds[known:] if g.terms != (Term(g.main),)]
    return claim


def _loop(build: Build, loop: AList) -> Loop:
    """What is repeated, and how long; what it is done to is looked up once, before the loop, but for that of "each"."""
    if (every := loop.find("every")) is not None:
        build.every(every)
        each, build.each = build.each, None
        return Loop(build.chain(loop.first("chain")), each=each)
    times, body = None, Chain()
    conditions: dict[str, Graphlet] = {}
    for part in loop:
        match part.name:
            case "until" | "whiling":
                conditions[part.name] = condition(build, part.first("conds"))
            case "cnt":
                times = _whole(count(part))
            case "chain" | "play":
                body = build.chain(part if part.name == "chain" else AList("chain", (part,)))
    build.finds += [graphlet for play in body.plays if (graphlet := _sought(play)) is not None]
    body = Chain(tuple(play for play in body.plays if _sought(play) is None))
    return Loop(body, times, conditions.get("until"), conditions.get("whiling"))


def _whole(number: str) -> int:
    if not number.isdecimal():
        raise NoMeaningError(number)
    return int(number)


def _sought(play: Play) -> Graphlet | None:
    """What a play that is nothing but a look-up looks for."""
    part = play.required[0]
    return part.graphlet if isinstance(part, Directive) and part.tag == "FIND" else None


def count(cnt: AList) -> str:
    """How many times, in digits."""
    if cnt.has("twice"):
        return "2"
    return cnt.slot("num") or {"once": "1", "twice": "2"}.get(cnt.value or "", cnt.value or "1")


def bare_chain(bare: AList) -> AList:
    """ "Forward" is driving, "left" is turning, "higher" is raising the lift."""
    plays = []
    for part in bare.all("barely"):
        parts = part.parts or (AList("dir", value=part.value),)
        ahead = next((p.value for p in parts if p.name == "dir"), None)
        way = "up" if part.find("higher") is not None else (ahead or "")
        unit = parts[0].slot("unit") if parts[0].name == "amt" else ""
        if unit in TIMES or (unit != "degree" and unit and way == "left"):
            raise NoMeaningError(str(part))  # "two minutes left", "ten inches left": what remains
        verb = "turn" if way in TURNS else LIFTS.get(way, "drive")
        rest = parts
        if verb in LIFTS.values():
            rest = tuple(p for p in parts if p.name not in ("dir", "higher"))
        if verb in LIFTS.values():
            lift = AList("np", (AList("det", value="the"), AList("ako", value="lift")))
            rest = (lift, *rest)
        plays.append(AList("play", (AList("action", (AList("act", value=verb), *rest)),)))
    inner = [bare_chain(more) for more in bare.all("bare")]
    return AList("chain", (*plays, *inner))
