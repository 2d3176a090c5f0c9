"""Chains of plays as English: then, and, while."""

from __future__ import annotations

from collections.abc import Iterable

from grammars.render.clauses import conditions
from grammars.render.deeds import VerbForm, deed
from grammars.render.telling import Telling
from grammars.render.things import thing
from kernel.action.chain import Chain, Directive, Play


def procedure(telling: Telling, chain: Chain, form: VerbForm = "base") -> str:
    """The chain as verb phrases: "drive forward then turn left while saying \\"left\\""."""
    spoken = {
        name
        for directive in chain.directives()
        if directive.graphlet
        for name in directive.graphlet.mentioned
        if (directive.tag, name) != ("FIND", directive.graphlet.main)
    }
    looked_up = [d.graphlet.main for d in chain.directives() if d.tag == "FIND" and d.graphlet]
    plays = (_play(telling, _by_mention(play, looked_up), form, spoken) for play in chain.plays)
    return " then ".join(filter(None, plays))


def without(chain: Chain, tag: str) -> Chain:
    """The chain less the directives of that tag."""
    plays = []
    for play in chain.plays:
        required, auxiliary = (_kept(parts, tag) for parts in (play.required, play.auxiliary))
        if required or auxiliary:
            plays.append(Play(required, auxiliary))
    return Chain(tuple(plays))


def _kept(parts: Iterable[Directive | Chain], tag: str) -> tuple[Directive | Chain, ...]:
    return tuple(
        without(part, tag) if isinstance(part, Chain) else part
        for part in parts
        if not (isinstance(part, Directive) and part.tag == tag)
    )


def _by_mention(play: Play, looked_up: list[str]) -> Play:
    """The parts of a play have no order, the look-ups before it have: what is looked up first is mentioned first."""

    def first(part: Directive | Chain) -> int | None:
        graphlet = part.graphlet if isinstance(part, Directive) else None
        mentioned = graphlet.mentioned if graphlet else ()
        return next((at for at, name in enumerate(looked_up) if name in mentioned), None)

    def ordered(parts: tuple[Directive | Chain, ...]) -> tuple[Directive | Chain, ...]:
        ranks = [(rank, at) for at, part in enumerate(parts) if (rank := first(part)) is not None]
        places = iter(sorted(ranks))
        return tuple(parts[next(places)[1]] if first(part) is not None else part for part in parts)

    return Play(ordered(play.required), ordered(play.auxiliary))


def _play(telling: Telling, play: Play, form: VerbForm, spoken: set[str]) -> str:
    required = [_part(telling, part, form, spoken) for part in play.required]
    beside = [_part(telling, part, "gerund", spoken) for part in play.auxiliary]
    together = " and ".join(filter(None, required))
    meanwhile = " and ".join(filter(None, beside))
    return f"{together} while {meanwhile}" if meanwhile else together


def _part(telling: Telling, part: Directive | Chain, form: VerbForm, spoken: set[str]) -> str:
    if isinstance(part, Chain):
        return procedure(telling, part, form)
    if part.graphlet is None:
        return ""
    main = part.graphlet.main
    match part.tag:
        case "FIND":
            return "" if main in spoken else f"find {thing(telling, main)}"
        case "CHK":
            return f"check whether {conditions(telling, part.graphlet)}"
        case "ACH":
            return f"make sure {conditions(telling, part.graphlet)}"
        case "FCN":
            return "do it"  # a skill of the body has no steps to tell
        case "NOTE":
            return f"note that {conditions(telling, part.graphlet)}"
    return deed(telling, main, form)
