"""Plays into nets: acts side by side, loops, and what is watched, brought about or stopped."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Final, TypeVar

from grammars.alist import AList
from grammars.alternatives import alternatives, one_each
from grammars.clauses import clause, names
from grammars.conditions import condition
from grammars.errors import NoMeaningError
from grammars.inquiries import inquired
from grammars.mentions import somebody
from grammars.pacing import HOLDING, TIMES, count, paced, whole
from grammars.several import spread
from grammars.sorts import HERE, is_nothing, usages
from grammars.usage import is_odd_end, particles
from grammars.vocabulary import BORN
from grammars.ways import TURNERS
from kernel.action.chain import Chain, Directive, Loop, Part, Play
from kernel.net.graphlet import Graphlet, Term

if TYPE_CHECKING:
    from grammars.build import Build


P = TypeVar("P", Directive, Loop)
TURNS: Final = frozenset(("left", "right", "clockwise", "counterclockwise", "around"))
TURNING: Final = TURNERS | {"roll"}
DOING: Final = ("action", "acting")
LEAST_DEGREES: Final = 10  # nobody turns "right 3"
FRACTIONS: Final = {"quarter": 0.25, "half": 0.5}
LIFTS: Final = {"up": "raise", "down": "lower"}


def is_odd(action: AList) -> bool:
    """ "Look on the bed" looks there and has no bed to "look on"; "turn left in ten seconds" turns no way "in"."""
    ways = [way.value or "" for way in action.all("dir")]
    amt = action.find("amt")
    if "in" in ways and amt is not None and amt.slot("unit") in TIMES:
        return True
    if any((one, other) == ("right", "away") for one, other in pairwise(ways)):
        return True
    of_place = [way for way in ways if "PREP" in BORN.readings(way)]
    before_thing = [part.name for part in action][1:3] == ["dir", "np"]
    if before_thing and ways[0] in HERE:  # "close there the door"
        return True
    return before_thing and bool(of_place) and f"{action.slot('act')} {ways[0]}" not in particles()


def plays(build: Build, play: AList) -> list[Play]:
    """A play, and before it the look-ups it needs."""
    play = AList(play.name, tuple(spread(build, p) if p.name in DOING else p for p in play))
    if sum(part.has("every") for part in play) > 1:  # "raise the forks and close the doors"
        apart = [build.chain(AList("chain", (AList("play", (part,)),))) for part in play]
        return [
            Play(tuple(part for chain in apart for one in chain.plays for part in one.required))
        ]
    required: list[Part] = []
    beside: list[Part] = []
    for part in play:
        match part.name:
            case "action" if "halting" in usages(part.slot("act")) and _moves(play.find("acting")):
                raise NoMeaningError(str(play))  # "stop while driving forward"
            case "action" | "acting":
                with build.drawing(pattern=False):
                    required.append(Directive("DO", build.graphlet(build.action(part))))
            case "acting_too":
                if (doing := part.first("acting", "action")).slot(
                    "act"
                ) in HOLDING:  # so long as it holds it
                    raise NoMeaningError(str(part))
                with build.drawing(pattern=False):
                    required.append(
                        Directive("DO", build.graphlet(build.action(spread(build, doing))))
                    )
            case "inquiry" if (asked := part.find("who_where")) is not None:
                found = AList("action", (AList("act", value="find"), somebody(asked.first("loc"))))
                with build.drawing(pattern=False):
                    required.append(Directive("DO", build.graphlet(build.action(found))))
            case "inquiry":
                required.append(inquired(build, part))
            case "over_all" if len(part.first("chain").parts) < 2:
                raise NoMeaningError(str(part))
            case "loop" | "over_all":
                required.append(_loop(build, paced(part)))
            case "kept" if _is_odd_keeping(part.first("keeping")):
                raise NoMeaningError(str(part))
            case "kept":
                beside.append(Directive("KEEP", _claim(build, part.first("keeping"))))
                until = part.first("until").first("conds")
                if len(alternatives(until)) > 1:
                    raise NoMeaningError(str(part))
                required.append(Directive("WAIT", condition(build, until)))
            case "ensuring":
                if names(part.first("clause")):  # nobody is made to be Mary
                    raise NoMeaningError(str(part))
                required.append(Directive("ACH", _claim(build, part.first("clause"))))
            case "keeping" if _is_odd_keeping(part):
                raise NoMeaningError(str(part))
            case "keeping":
                beside.append(Directive("KEEP", _claim(build, part)))
            case "avoiding":
                beside += [Directive("KEEP", avoided) for avoided in _avoided(build, part)]
            case "waiting":
                first, *others = _watched(build, part)
                required.append(_or_until(Directive("WAIT", first), others))
            case "ceasing":
                with build.drawing(pattern=True):
                    act = build.action(part.first("gerunding"))
                    required.append(Directive("STOP", build.graphlet(act)))
    whole = Play(tuple(required), tuple(beside)) if required else Play(tuple(beside))
    made = [*build.looked_up(), whole]
    if build.each is not None:
        made = [Play((Loop(Chain(tuple(made)), build.times, each=build.each),))]
        build.each, build.times = None, None
    return made


def _moves(acting: AList | None) -> bool:
    """It is done with the wheels, so far as the verb tells."""
    return acting is not None and "steering" in usages(acting.slot("act"))


def _is_odd_keeping(keeping: AList) -> bool:
    kept = keeping.first("np")
    nobody = is_nothing(kept) or kept.slot("pron") == "you"
    return nobody or is_odd_end(kept, keeping.first("qual"))


def _claim(build: Build, part: AList) -> Graphlet:
    """What is to be so; the things it is about are looked up before, "something" and "nothing" are not."""
    known = len(build.finds)
    with build.drawing(pattern=False):
        claim = build.graphlet(clause(build, part))
    build.finds[known:] = [g for g in build.finds[known:] if g.terms != (Term(g.main),)]
    return claim


def _avoided(build: Build, avoiding: AList) -> list[Graphlet]:
    """What the robot is not to be doing meanwhile: "without turning or stopping". It is watched, and nothing is looked
    up for it."""
    found = []
    for part in avoiding:
        if part.name == "avoiding":
            found += _avoided(build, part)
            continue
        with build.drawing(pattern=True):
            act = build.action(part)
            build.sketch.change(act, negated=True)
            found.append(build.graphlet(act))
    return found


def _loop(build: Build, loop: AList) -> Loop:
    """What is repeated, and how long; what it is done to is looked up once, before the loop, but for that of "each"."""
    if (every := loop.find("every")) is not None:
        build.every(every)
        (each, build.each), (times, build.times) = (build.each, None), (build.times, None)
        return Loop(build.chain(loop.first("chain")), times, each=each)
    times, body, others = None, Chain(), []
    conditions: dict[str, Graphlet] = {}
    for part in loop:
        match part.name:
            case "until" | "whiling":
                conditions[part.name], *more = _watched(build, part)
                if more and part.name == "whiling":
                    raise NoMeaningError(str(part))
                others += more
            case "cnt":
                times = whole(count(part))
            case "chain" | "play":
                body = build.chain(part if part.name == "chain" else AList("chain", (part,)))
    build.finds += [graphlet for play in body.plays if (graphlet := _sought(play)) is not None]
    body = Chain(tuple(play for play in body.plays if _sought(play) is None))
    made = Loop(body, times, conditions.get("until"), conditions.get("whiling"))
    return _or_until(made, others)


def _watched(build: Build, part: AList) -> list[Graphlet]:
    """What is waited for: this or that."""
    return [condition(build, conds) for conds in alternatives(part.first("conds"))]


def _or_until(part: P, others: list[Graphlet]) -> P | Loop:
    """It ends when any of these is so as well: one round, watched for each."""
    made: P | Loop = part
    for other in others:
        made = Loop(Chain((Play((made,)),)), 1, until=other)
    return made


def one_by_one(several: AList) -> AList:
    """ "Grab the box and the ball": the same done to each, one after another."""
    return AList("chain", tuple(AList("play", (act,)) for act in one_each(several)))


def with_gaps(gapped: AList) -> AList:
    """ "Put the cup on the table and the plate on the shelf": the same done with each, one after another."""
    verb, *gaps = gapped.parts
    return AList(
        "chain", tuple(AList("play", (AList("action", (verb, *gap.parts)),)) for gap in gaps)
    )


def that_too(chain: AList, elliptic: AList) -> AList:
    """The step before, at another place, to somewhere else or upon another thing: "then under it", "then the blue
    one"."""
    at = chain.parts.index(elliptic)
    done = [part for before in chain.parts[:at] for part in before.walk() if part.name == "action"]
    new = elliptic.first("loc", "dest", "np", "manner", "amt")
    if len(elliptic.parts) > 1:
        return _with_each(done, elliptic)
    if new.name == "loc":
        new = AList("place", (new,))
    if not done or not done[-1].has(new.name):
        raise NoMeaningError(str(elliptic))
    old = done[-1].first(new.name)
    if new.name == "np" and new.has("one"):
        kind = [part for part in old if part.name in ("ako", "akos", "sub")]
        new = AList(
            "np", tuple(p for part in new for p in (kind if part.name == "one" else [part]))
        )
    action = AList("action", tuple(new if part is old else part for part in done[-1]))
    return AList("chain", (AList("play", (action,)),))


def _with_each(done: list[AList], elliptic: AList) -> AList:
    """ "Put a plate on the table, then a cup beside it": the same done with another thing elsewhere."""
    if not done or not all(done[-1].has(new.name) for new in elliptic):
        raise NoMeaningError(str(elliptic))
    rest = (part for part in done[-1] if part.name not in {new.name for new in elliptic})
    return AList("chain", (AList("play", (AList("action", (*rest, *elliptic.parts)),)),))


def turned(action: AList) -> AList:
    """ "Take a left": turn left."""
    side, *rest = action.parts
    way = side.slot("dir") or side.value
    if way not in TURNS:
        raise NoMeaningError(str(action))
    return AList("action", (AList("act", value="turn"), AList("dir", value=way), *rest))


def degrees_so(build: Build, act: str, said: AList) -> None:
    """ "Turn right ninety": degrees."""
    number = said.slot("num")
    if build.sketch.terms[act].lex.isdisjoint(TURNING) or float(number) < LEAST_DEGREES:
        raise NoMeaningError(str(said))
    build.add("amt", "degree", literal=number, amt=act)


def turns(turns: AList) -> float:
    """How often all around: "a quarter", "half", "a full" turn."""
    number = turns.slot("num")
    return float(number) if number else FRACTIONS.get(turns.value or "", 1.0)


def _sought(play: Play) -> Graphlet | None:
    """What a play that is nothing but a look-up looks for."""
    part = play.required[0]
    return part.graphlet if isinstance(part, Directive) and part.tag == "FIND" else None


def bare_chain(bare: AList) -> AList:
    """ "Forward" is driving, "left" is turning, "higher" is raising the lift."""
    plays = []
    for part in bare.all("barely"):
        parts = part.parts or (AList("dir", value=part.value),)
        if (deeds := part.find("deeds_in_all")) is not None:  # "two turns to the left"
            if "UNIT" in BORN.readings(deeds.slot("act")):  # "ten inches left"
                raise NoMeaningError(str(part))
            times = AList("cnt", tuple(deeds.all("num")))
            done = tuple(deeds.all("act", "dir"))
            plays.append(AList("play", (AList("action", (*done, times)),)))
            continue
        ahead = next((p.value for p in parts if p.name == "dir"), None)
        way = "up" if part.find("higher") is not None else (ahead or "")
        unit = next((p.slot("unit") for p in parts if p.name == "amt"), "")
        if unit in TIMES or (unit != "degree" and unit and way in ("left", "around")):
            # "two minutes left", "ten inches left": what remains; "around three inches"
            raise NoMeaningError(str(part))
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
