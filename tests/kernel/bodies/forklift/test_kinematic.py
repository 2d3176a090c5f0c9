"""The body without wire and physics: it does what it is bid, and only while it is bid."""

import math

import pytest

from kernel.action.call import Bid, BodyState, MoveGrip, MoveLift, Rotate, Travel
from kernel.bodies.forklift.kinematic import Kinematic

FORWARD = Bid("wheels", Travel(0.2, 1.0), 1)


def run(body: Kinematic, *bids: Bid, seconds: float = 1.0, dt_s: float = 0.1) -> BodyState:
    for _ in range(round(seconds / dt_s)):
        body.act(bids, dt_s)
    return body.state


@pytest.mark.parametrize("dt_s", [0.01, 1 / 30, 0.1, 0.25, 1.0])
def test_a_travel_ends_where_it_should_whatever_the_step(dt_s: float) -> None:
    state = run(Kinematic(), FORWARD, seconds=2.0, dt_s=dt_s)
    assert state.x_m == pytest.approx(0.2)
    assert state.done == {1}
    assert not state.moving


def test_it_moves_only_while_it_is_bid() -> None:
    body = Kinematic()
    run(body, FORWARD, seconds=0.5)
    assert body.state.moving
    state = run(body, seconds=5.0)
    assert state.x_m == pytest.approx(0.1)
    assert not state.moving
    assert state.done == frozenset()


def test_an_end_is_told_until_its_bid_is_gone() -> None:
    body = Kinematic()
    run(body, FORWARD, seconds=3.0)
    assert body.state.done == {1}
    assert body.state.x_m == pytest.approx(0.2)
    run(body, seconds=0.1)
    assert body.state.done == frozenset()


def test_without_end_it_goes_on() -> None:
    state = run(Kinematic(), Bid("wheels", Travel(-0.2, None), 1), seconds=10.0)
    assert state.x_m == pytest.approx(-2.0)
    assert state.done == frozenset()


def test_it_travels_where_it_looks() -> None:
    body = Kinematic()
    run(body, Bid("wheels", Rotate(math.pi / 2, 1.0), 1))
    state = run(body, Bid("wheels", Travel(0.2, 1.0), 2))
    assert (state.x_m, state.y_m) == (pytest.approx(0, abs=1e-9), pytest.approx(0.2))


def test_lift_and_gripper() -> None:
    body = Kinematic()
    lift, grip = Bid("lift", MoveLift(0.5), 1), Bid("grip", MoveGrip(0.0), 2)
    state = run(body, lift, grip, seconds=0.5)
    assert state.lift == pytest.approx(0.25)
    state = run(body, lift, grip, seconds=0.6)
    assert (state.lift, state.grip, state.holding) == (pytest.approx(0.5), pytest.approx(0.0), True)
    assert state.done == {1, 2}
    assert not run(body, Bid("grip", MoveGrip(1.0, must_hold=False), 3)).holding


def test_a_gripper_with_nothing_in_reach_misses() -> None:
    state = run(Kinematic(within_reach=False), Bid("grip", MoveGrip(0.0), 1), seconds=1.1)
    assert state.failed == {1: "missed"}
    assert not state.holding


def test_without_a_link_everything_fails() -> None:
    body = Kinematic(BodyState(connected=False))
    assert run(body, FORWARD, seconds=0.1).failed == {1: "link_lost"}
    assert body.state.x_m == 0


def test_what_is_ahead_comes_nearer_and_is_lost_by_turning() -> None:
    body = Kinematic(BodyState(range_m=0.3))
    assert run(body, FORWARD).range_m == pytest.approx(0.1)
    assert run(body, Bid("wheels", Rotate(1.5, 1.0), 2)).range_m is None
    body = Kinematic(BodyState(range_m=0.3))
    assert run(body, Bid("wheels", Travel(-0.2, 1.0), 1)).range_m is None, "out of reach"
