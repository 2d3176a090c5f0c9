"""Who gets a resource."""

from hypothesis import given
from hypothesis import strategies as st

from kernel.action.arbiter import Claim, arbitrate
from kernel.action.call import Bid, MoveGrip, MoveLift, Rotate, Travel

COMMANDS = {
    "wheels": (Travel(0.2, 1.0), Rotate(1.0, 1.0)),
    "lift": (MoveLift(1.0),),
    "grip": (MoveGrip(0.0),),
}


@st.composite
def claims(draw: st.DrawFn) -> list[Claim]:
    made = []
    for ticket in range(draw(st.integers(0, 7))):
        resource = draw(st.sampled_from(("wheels", "lift", "grip")))
        command = draw(st.sampled_from(COMMANDS[resource]))
        made.append(Claim(draw(st.integers(1, 3)), Bid(resource, command, ticket)))  # type: ignore[arg-type]
    return made


@given(claims())
def test_every_claim_wins_waits_or_conflicts(made: list[Claim]) -> None:
    ruling = arbitrate(made)
    won = [bid.ticket for bid in ruling.winners]
    lost = [claim.bid.ticket for claim, _ in ruling.lost]
    assert sorted((*won, *lost, *ruling.conflicts)) == [claim.bid.ticket for claim in made]


@given(claims())
def test_a_resource_goes_whole_to_the_newest_focus_that_wants_it(made: list[Claim]) -> None:
    ruling = arbitrate(made)
    newest = {
        claim.bid.resource: max(c.focus for c in made if c.bid.resource == claim.bid.resource)
        for claim in made
    }
    by_ticket = {claim.bid.ticket: claim for claim in made}
    assert all(by_ticket[bid.ticket].focus == newest[bid.resource] for bid in ruling.winners)
    for claim, winner in ruling.lost:
        assert claim.focus < winner == newest[claim.bid.resource]


@given(claims())
def test_no_component_is_won_twice(made: list[Claim]) -> None:
    winners = arbitrate(made).winners
    components = [(bid.resource, type(bid.command)) for bid in winners]
    assert len(components) == len(set(components))


def test_travel_and_turn_of_one_focus_mix() -> None:
    both = [Claim(1, Bid("wheels", command, n)) for n, command in enumerate(COMMANDS["wheels"])]
    assert len(arbitrate(both).winners) == 2


def test_two_of_the_same_kind_in_one_focus_conflict_and_neither_moves() -> None:
    both = [Claim(1, Bid("wheels", Travel(speed, 1.0), n)) for n, speed in enumerate((0.2, -0.2))]
    ruling = arbitrate(both)
    assert ruling.winners == ()
    assert ruling.conflicts == {0, 1}


def test_a_conflict_is_none_while_a_newer_focus_has_the_resource() -> None:
    both = [Claim(1, Bid("wheels", Travel(speed, 1.0), n)) for n, speed in enumerate((0.2, -0.2))]
    ruling = arbitrate([*both, Claim(2, Bid("wheels", Rotate(1.0, 1.0), 9))])
    assert [bid.ticket for bid in ruling.winners] == [9]
    assert ruling.conflicts == frozenset()
