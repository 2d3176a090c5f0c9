"""Who gets a resource when several actions want it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

from kernel.action.call import Bid

PATIENCE_S: Final = 10.0  # mind.md: without its resource for so long, an action fails


@dataclass(frozen=True, slots=True)
class Claim:
    """A bid and the focus it is made for."""

    focus: int
    bid: Bid


@dataclass(frozen=True, slots=True)
class Ruling:
    """Attributes:
    winners: bids to be carried out.
    lost: claims that have to wait, with the focus that has the resource.
    conflicts: tickets of one focus that want the same component at once; neither is carried out.
    """

    winners: tuple[Bid, ...]
    lost: tuple[tuple[Claim, int], ...]
    conflicts: frozenset[int]


def arbitrate(claims: Iterable[Claim]) -> Ruling:
    """Give each resource whole to the newest focus that wants it.

    Within one focus, different commands for one resource mix (travel and turn make an arc); two of the same kind are a
    conflict. The voice is a queue and is not arbitrated here.

    Source: Connell 2019, section 4: "attentional foci that are posted more recently have a higher priority".
    """
    claims = tuple(claims)
    owner: dict[str, int] = {}
    for claim in claims:
        resource = claim.bid.resource
        owner[resource] = max(owner.get(resource, 0), claim.focus)
    won = [c for c in claims if owner[c.bid.resource] == c.focus]
    lost = tuple((c, owner[c.bid.resource]) for c in claims if owner[c.bid.resource] != c.focus)
    by_component: dict[tuple[str, type], set[int]] = {}
    for claim in won:
        component = (claim.bid.resource, type(claim.bid.command))
        by_component.setdefault(component, set()).add(claim.bid.ticket)
    conflicts = frozenset(
        t for tickets in by_component.values() if len(tickets) > 1 for t in tickets
    )
    winners = tuple(c.bid for c in won if c.bid.ticket not in conflicts)
    return Ruling(winners, lost, conflicts)
