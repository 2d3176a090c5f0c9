"""Chains of plays as English: then, and, while."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from grammars.render.clauses import conditions
from grammars.render.deeds import VerbForm, deed
from grammars.render.qualities import measured, quality
from grammars.render.telling import Telling, is_predicate, linked, word
from grammars.render.things import thing
from grammars.render.wondering import wonder, wonders
from kernel.action.chain import Chain, Directive, Loop, Part, Play
from kernel.net.graphlet import Graphlet, Term


def procedure(
    telling: Telling,
    chain: Chain,
    form: VerbForm = "base",
    mentioned: frozenset[str] = frozenset(),
) -> str:
    """The chain as verb phrases: "drive forward then turn left while saying \\"left\\""."""
    telling.hold_back(claimed(chain))
    spoken = {
        name
        for directive in chain.directives()
        if directive.graphlet
        for name in directive.graphlet.mentioned
        if (directive.tag, name) != ("FIND", directive.graphlet.main)
    } | mentioned
    looked_up = [find.main for find in chain.tagged("FIND")]
    plays = (_play(telling, _by_mention(play, looked_up), form, spoken) for play in chain.plays)
    return " then ".join(filter(None, plays))


def claimed(chain: Chain) -> Iterator[Term]:
    """What is to become so, or to be found out: no description of anything yet."""
    return (term for graphlet in _watched(chain) for term in graphlet if is_predicate(term))


def _watched(chain: Chain) -> Iterator[Graphlet]:
    for directive in chain.directives():
        if directive.tag in ("ACH", "CHK", "KEEP", "WAIT") and directive.graphlet is not None:
            if _avoided(directive) is not None:
                continue
            yield directive.graphlet
    for play in chain.plays:
        for part in (*play.required, *play.auxiliary):
            if isinstance(part, Loop):
                yield from (g for g in (part.until, part.whilst) if g is not None)


def without(chain: Chain, tag: str) -> Chain:
    """The chain less the directives of that tag."""
    plays = []
    for play in chain.plays:
        required, auxiliary = (_kept(parts, tag) for parts in (play.required, play.auxiliary))
        if required or auxiliary:
            plays.append(Play(required, auxiliary))
    return Chain(tuple(plays))


def _kept(parts: Iterable[Part], tag: str) -> tuple[Part, ...]:
    return tuple(
        _less(part, tag) for part in parts if not (isinstance(part, Directive) and part.tag == tag)
    )


def _less(part: Part, tag: str) -> Part:
    if isinstance(part, Loop):
        return replace(part, body=without(part.body, tag))
    return without(part, tag) if isinstance(part, Chain) else part


def _by_mention(play: Play, looked_up: list[str]) -> Play:
    """The parts of a play have no order, the look-ups before it have: what is looked up first is mentioned first."""

    def first(part: Part) -> int | None:
        graphlet = part.graphlet if isinstance(part, Directive) else None
        mentioned = graphlet.mentioned if graphlet else ()
        return next((at for at, name in enumerate(looked_up) if name in mentioned), None)

    def ordered(parts: tuple[Part, ...]) -> tuple[Part, ...]:
        ranks = [(rank, at) for at, part in enumerate(parts) if (rank := first(part)) is not None]
        places = iter(sorted(ranks))
        return tuple(parts[next(places)[1]] if first(part) is not None else part for part in parts)

    return Play(ordered(play.required), ordered(play.auxiliary))


def _play(telling: Telling, play: Play, form: VerbForm, spoken: set[str]) -> str:
    if (until := _kept_until(play)) is not None:
        kept, ended = until
        return f"{_kept_so(telling, kept, 'keep')} until {conditions(telling, ended)}"
    required = [_part(telling, part, form, spoken) for part in play.required]
    avoided = [avoid for part in play.auxiliary if (avoid := _avoided(part)) is not None]
    others = (part for part in play.auxiliary if _avoided(part) is None)
    beside = [_part(telling, part, "gerund", spoken) for part in others]
    together = " and ".join(filter(None, required))
    if meanwhile := " and ".join(filter(None, beside)):
        together += f" while {meanwhile}"
    if avoided:
        together += f" without {' or '.join(deed(telling, g.main, 'gerund') for g in avoided)}"
    return together


def _avoided(part: Part) -> Graphlet | None:
    """What the robot is to keep from doing."""
    match part:
        case Directive("KEEP", Graphlet() as graphlet) if graphlet.main.startswith("act"):
            return graphlet
    return None


def _part(telling: Telling, part: Part, form: VerbForm, spoken: set[str]) -> str:
    if isinstance(part, Chain):
        return procedure(telling, part, form)
    if isinstance(part, Loop):
        return _loop(telling, part)
    if part.graphlet is None:
        return ""
    main = part.graphlet.main
    match part.tag:
        case "FIND" if wonders(telling, main):
            return f"find out {wonder(telling, main)}"
        case "FIND":
            return "" if main in spoken else f"find {thing(telling, main)}"
        case "CHK":
            return f"check whether {conditions(telling, part.graphlet)}"
        case "ACH":
            return f"make sure {conditions(telling, part.graphlet)}"
        case "KEEP":
            return _kept_so(telling, part.graphlet, "keep" if form == "base" else "keeping")
        case "WAIT":
            return f"wait until {conditions(telling, part.graphlet)}"
        case "STOP":
            return f"stop {deed(telling, main, 'gerund')}"
        case "FCN":
            return "do it"  # a skill of the body has no steps to tell
        case "NOTE":
            return f"note that {conditions(telling, part.graphlet)}"
    return deed(telling, main, form)


def _kept_until(play: Play) -> tuple[Graphlet, Graphlet] | None:
    """What is to be kept so, and until when, where the play is nothing else."""
    match [*play.required, *play.auxiliary]:
        case [Directive("WAIT", Graphlet() as ended), Directive("KEEP", Graphlet() as kept)]:
            return kept, ended
    return None


def _kept_so(telling: Telling, graphlet: Graphlet, verb: str) -> str:
    """ "Keep the gripper closed"."""
    term = telling.term(graphlet.main)
    telling.stated.add(term.name)
    kept = thing(telling, linked(term, "hq"))
    return f"{verb} {kept} {quality(telling, term)}"


def _or_until(loop: Loop) -> Part | None:
    """What ends when this is so or that: one round of it, watched for another condition."""
    inner = loop.body.plays[0].only if loop.times == 1 and len(loop.body.plays) == 1 else None
    watched = isinstance(inner, Loop) and inner.until is not None
    waiting = isinstance(inner, Directive) and inner.tag == "WAIT"
    return inner if watched or waiting else None


def _loop(telling: Telling, loop: Loop) -> str:
    """ "Repeat turn left then turn right 3 times"; one play alone needs no "repeat" before "until" and "while"."""
    if (near := _approach(telling, loop)) is not None:
        return near
    if loop.until is not None and (inner := _or_until(loop)) is not None:
        return f"{_part(telling, inner, 'base', set())} or {conditions(telling, loop.until)}"
    if loop.each is not None:
        if loop.times is not None:
            telling.count(loop.each.main, loop.times)
        if not (_taken(loop) or _taken_there(loop)):
            each = thing(telling, loop.each.main)
            said = procedure(telling, loop.body, mentioned=loop.each.mentioned)
            return f"for {each}, {said}"
        return procedure(telling, loop.body, mentioned=loop.each.mentioned)
    if loop.times is None and loop.until is None and loop.whilst is None:
        return f"keep {procedure(telling, loop.body, 'gerund')}"
    if loop.whilst is not None and _plain(loop.body) and _meant(loop):
        return f"while {conditions(telling, loop.whilst)}, {procedure(telling, loop.body)}"
    body = procedure(telling, loop.body)
    if loop.times is not None or not _plain(loop.body):
        body = f"repeat {body}"
    if loop.times is not None:
        body += f" {loop.times} times"
    if loop.until is not None:
        body += f" until {conditions(telling, loop.until)}"
    if loop.whilst is not None:
        body += f" while {conditions(telling, loop.whilst)}"
    return body


def _approach(telling: Telling, loop: Loop) -> str | None:
    """ "Drive to within 1 foot of the wall"."""
    until = loop.until.head if loop.until is not None else None
    if until is None or word(until) != "close" or not _plain(loop.body) or until.negated:
        return None
    (step,) = loop.body.plays[0].required[:1]
    act = (
        telling.term(step.graphlet.main) if isinstance(step, Directive) and step.graphlet else None
    )
    landmark = linked(until, "hq")
    if act is None or linked(act, "dest") != landmark or len(loop.body.plays[0].required) > 1:
        return None
    amounts = telling.about(until.name, "amt")
    if len(amounts) != 1 or not telling.about(until.name, "deg") or telling.about(act.name, "amt"):
        return None
    said = deed(telling, act.name)
    telling.hold_back([until, *amounts, *telling.about(until.name, "deg")])
    near = measured(amounts[0].literal or "1", word(amounts[0]))
    return said.replace(" to ", f" to within {near} of ", 1)


def _plain(chain: Chain) -> bool:
    """One play of acts."""
    parts = chain.plays[0].required if len(chain.plays) == 1 else ()
    return bool(parts) and all(isinstance(part, Directive) and part.tag == "DO" for part in parts)


def _meant(loop: Loop) -> bool:
    """Whether the body acts on what its condition describes: "while something is close, push it"."""
    described = loop.whilst.names if loop.whilst is not None else frozenset()
    return any(described & graphlet.mentioned for graphlet in loop.body.graphlets())


def _taken_there(loop: Loop) -> bool:
    """Whether it is taken somewhere that is looked up: "push each crate to the wall"."""
    done = tuple(play for play in loop.body.plays if play.find is None)
    acts = replace(loop, body=Chain(done))
    each = loop.each.main if loop.each is not None else ""
    placed = any(
        term.kind == "loc" and linked(term, "wrt") != each
        for g in loop.body.graphlets()
        for term in g
    )
    return not placed and not any(t.kind == "loc" for t in loop.each or ()) and _taken(acts)


def _taken(loop: Loop) -> bool:
    """Whether the thing stands in the body as what is acted on or spoken to: "grab each block"."""
    if loop.each is None or not _plain(loop.body):
        return False
    return any(
        other == loop.each.main
        and (role in ("obj", "wrt") or (role == "dest" and "say" in term.lex))
        for graphlet in loop.body.graphlets()
        for term in graphlet
        for role, other in term.links
    )
