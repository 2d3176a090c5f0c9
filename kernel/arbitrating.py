"""Who gets which resource in this tick, and what becomes of those who wait for one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from kernel.action.arbiter import PATIENCE_S, arbitrate
from kernel.action.call import Bid, Halt
from kernel.action.verdict import Verdict
from kernel.commons import Commons
from kernel.memory.attention import Failure, Focus

TAKEOVERS: Final = 3  # the same reaction may pre-empt the same focus so often in TAKEOVER_S
TAKEOVER_S: Final = 10.0

Close = Callable[[Focus, Verdict], None]  # ends a focus


class Arbitration:
    """Rules on claims, tick after tick; remembers since when each ticket has waited."""

    def __init__(self, commons: Commons) -> None:
        self._commons = commons
        self._waiting_since: dict[int, float] = {}

    def clear(self) -> None:
        """Nobody waits any more."""
        self._waiting_since.clear()

    def rule(self, close: Close) -> tuple[Bid, ...]:
        """The bids that win; those who wait too long are struck, and a focus that is taken over too often ends."""
        commons, now_s = self._commons, self._commons.tick.now_s
        commons.struck.clear()
        halts = [c for c in commons.claims if isinstance(c.bid.command, Halt)]
        motions = [c for c in commons.claims if c not in halts]
        if halts:
            own = {claim.focus for claim in halts}
            # What the stop stands beside is done with, all else has been stopped.
            for claim in motions:
                commons.struck[claim.bid.ticket] = "ended" if claim.focus in own else "stopped"
            motions = []
        ruling = arbitrate(motions)
        for ticket in ruling.conflicts:
            commons.struck[ticket] = "conflict"
        waiting = {}
        by_number = {focus.number: focus for focus in commons.attention}
        for claim, winner in ruling.lost:
            ticket = claim.bid.ticket
            waiting[ticket] = self._waiting_since.get(ticket, now_s)
            focus = by_number[claim.focus]
            if ticket not in self._waiting_since:
                commons.record("resource_lost", focus, resource=claim.bid.resource)
                self._took_over(focus, by_number[winner], close)
            if now_s - waiting[ticket] > PATIENCE_S:
                commons.struck[ticket] = "resource_lost"
        self._waiting_since = waiting
        given_up = {c.bid.ticket for c in motions if by_number[c.focus].ended_s is not None}
        return tuple(bid for bid in ruling.winners if bid.ticket not in given_up)

    def _took_over(self, focus: Focus, winner: Focus, close: Close) -> None:
        """The same reaction taking over for the third time in 10 s ends the focus (mind.md)."""
        if winner.reaction is None or focus.ended_s is not None:
            return
        now_s, ident = self._commons.tick.now_s, winner.reaction.ident
        focus.preempted = [p for p in focus.preempted if now_s - p[0] < TAKEOVER_S]
        focus.preempted.append((now_s, ident))
        if sum(lesson == ident for _, lesson in focus.preempted) >= TAKEOVERS:
            focus.failure = focus.failure or Failure("resource_lost")
            close(focus, Verdict.FAILED)
