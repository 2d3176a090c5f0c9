"""Calling grounding functions: their bids become claims, their errors become explanations."""

from __future__ import annotations

import math
from typing import Final

from kernel.action.arbiter import Claim
from kernel.action.call import GROUNDINGS, Act, Bid, Call, Sighting, Speak
from kernel.action.step import Run
from kernel.action.verdict import Verdict
from kernel.commons import Commons
from kernel.errors import (
    KernelError,
    LimitError,
    MotionFailedError,
    NoSenseError,
    NotGroundedError,
)
from kernel.memory.attention import Failure, Focus
from kernel.memory.looking import seen
from kernel.memory.meaning import Command
from kernel.memory.reply import Reason, Saw
from kernel.net.describing import descriptions
from kernel.net.node import MODIFIER_ROLES, Node

_MOTION_REASONS: Final[dict[str, Reason]] = {
    "link_lost": "link_lost",
    "missed": "nothing_gripped",
    "stuck": "stuck",
    "refused": "crashed",
    "stopped": "stopped",
}


def call(commons: Commons, focus: Focus, name: str, act: Node, endless: bool = False) -> Run:
    """Run a grounding function to its end; every tick it bids, its bid is claimed for the focus."""
    grounding = GROUNDINGS.get(name)
    if grounding is None:
        focus.failure = Failure("no_way", act, name)
        return Verdict.FAILED
    commons.memory.refresh()
    ticket = commons.next_number()
    told = {"function": name, "text": act_text(act), "words": act_words(act), "ticket": ticket}
    commons.record("action_started", focus, **told)
    verdict = Verdict.STOPPED
    made = Call(act, commons.memory.depth, ticket, commons.next_number, endless)
    running = grounding.code(made, commons.tick)
    try:
        verdict = yield from _served(commons, focus, act, running, name, ticket)
    except KernelError as error:
        focus.failure = focus.failure or _explained(error, act)
        verdict = Verdict.FAILED
    finally:
        running.close()
        commons.record("action_ended", focus, verdict=verdict.value, **told)
    return verdict


def _served(commons: Commons, focus: Focus, act: Node, running: Act, name: str, ticket: int) -> Run:
    """Pass the function's bids on; end it when the mind has struck its ticket."""
    spoken, resource = False, ""
    while True:
        if ticket in commons.struck:
            why = commons.struck.pop(ticket)
            if why == "ended":
                return Verdict.SUCCEEDED
            if why == "stopped":
                return Verdict.STOPPED
            focus.failure = Failure(why, detail=resource)
            return Verdict.FAILED
        try:
            bid: Bid | None = next(running)
        except StopIteration as end:
            verdict: Verdict = end.value
            return verdict
        if bid is not None and isinstance(bid.command, Speak):
            if not spoken:
                commons.speech.append(bid)
                focus.said += 1
                spoken = True
        elif bid is not None and isinstance(bid.command, Sighting):
            sighted(commons, focus, act, bid.command)
        elif bid is not None:
            ticket, resource = bid.ticket, bid.resource
            commons.claims.append(Claim(focus.number, bid))
            if focus is commons.recent.focus and commons.recent.thing == "command":
                commons.recent.thing = "motion"
        focus.waits.add(name)
        try:
            yield
        except GeneratorExit:
            _withdraw(commons, focus, ticket)
            raise


def _withdraw(commons: Commons, focus: Focus, ticket: int) -> None:
    """What ends in the tick it bid in, because of something beside it, does not reach the body any more."""
    commons.claims[:] = [claim for claim in commons.claims if claim.bid.ticket != ticket]
    for bid in [bid for bid in commons.speech if bid.ticket == ticket]:
        commons.speech.remove(bid)
        focus.said -= 1


def _explained(error: KernelError, act: Node) -> Failure:
    match error:
        case NotGroundedError(wanted=wanted):
            return Failure("not_grounded", act, wanted)
        case LimitError(detail=detail):
            return Failure("too_much", act, detail)
        case NoSenseError(what=what):
            return Failure("no_sense", act, what)
        case MotionFailedError(why=why):
            return Failure(_MOTION_REASONS.get(why, "crashed"), act, why)
    return Failure("crashed", act, str(error))


def act_words(act: Node) -> tuple[str, ...]:
    """Words of an action: its verb, then those of what modifies it and of its arguments."""
    words = [min(act.lex)] if act.lex else []
    for role, other in (*act.into, *act.links):
        if role in MODIFIER_ROLES or role in ("obj", "dest"):
            words += [other.literal] if other.literal else []
            words += sorted(other.lex)[:1]
            words += [min(node.lex) for node in descriptions(other) if node.lex]
    return tuple(words)


def act_text(act: Node | None) -> str:
    """The action in a few words, for traces."""
    return " ".join(act_words(act)) if act is not None else ""


def sighted(commons: Commons, focus: Focus, act: Node, sighting: Sighting) -> None:
    """What a look found is in mind as long as the focus is; it is told where looking was the command itself."""
    for fact in seen(sighting):
        bound = commons.memory.instantiate(fact, {})
        focus.nodes |= dict.fromkeys(bound.values())
    meaning = focus.meaning
    if isinstance(meaning, Command) and any(
        directive.tag == "DO" and directive.graphlet and directive.graphlet.words() & act.words()
        for directive in meaning.chain.directives()
    ):
        bearing_deg = math.degrees(sighting.bearing_rad)
        commons.replies.append(Saw(sighting.distance_m, bearing_deg, sighting.swept))
