"""Bids in, motion out: the body over the whole chain of session, line, far end and physics, in virtual time."""

import math
from collections.abc import Callable, Sequence

import pytest

from daemon.link.virtual import VirtualLink
from firmware_proto.frame import FrameReader
from firmware_proto.messages import Drive, EventCode, Grip, Lift, Message, State, Telem, unpack
from firmware_proto.told import Settled
from kernel.action.call import (
    Bid,
    BodyCommand,
    BodyState,
    MoveGrip,
    MoveLift,
    Resource,
    Rotate,
    Travel,
)
from kernel.bodies.forklift.body import Forklift
from kernel.bodies.forklift.faults import PROFILES, Faults

TICK_S = 1 / 30
QUARTER = math.pi / 2


class Ride:
    """A body at the end of a virtual link, ticked as the control loop does."""

    def __init__(self, seed: int = 1, faults: Faults | None = None) -> None:
        self.link = VirtualLink(seed=seed, faults=faults)
        self.body = Forklift()
        self.state = BodyState(connected=False)
        self.done: set[int] = set()
        self.failed: dict[int, str] = {}
        self.drop: Callable[[Message], bool] = lambda message: False
        assert self.link.connect()
        self.tick([])
        self.link.sent.clear()

    def tick(self, bids: Sequence[Bid]) -> BodyState:
        self.link.advance(TICK_S)
        now_s = 1000 + self.link.now_s  # another clock than the link's
        heard = [m for m in self.link.received() if not self.drop(m)]
        self.state = self.body.sense(heard, now_s, self.link.connected)
        self.done |= self.state.done
        self.failed.update(self.state.failed)
        live = [b for b in bids if b.ticket not in self.done and b.ticket not in self.failed]
        self.link.send(self.body.act(live, now_s), self.link.stop_epoch)
        self.link.beat()
        return self.state

    def run(self, seconds: float, *bids: Bid) -> BodyState:
        for _ in range(round(seconds / TICK_S)):
            self.tick(bids)
        return self.state

    def finish(self, *bids: Bid, limit_s: float = 15.0) -> float:
        """Until every ticket has ended; how long that took."""
        began_s = self.link.now_s
        tickets = {bid.ticket for bid in bids}
        while not tickets <= self.done | self.failed.keys():
            assert self.link.now_s - began_s < limit_s, "it never ends"
            self.tick(bids)
        took_s = self.link.now_s - began_s
        self.run(0.3)
        return took_s

    def sent(self, *kinds: type[Message]) -> list[Message]:
        """What the host wrote, in order, without repeats of the same number."""
        found: dict[tuple[int, int, bytes], Message] = {}
        for frame in FrameReader().feed(b"".join(data for _, data in self.link.sent)):
            message = unpack(frame.number, frame.payload)
            if isinstance(message, kinds):
                found[frame.number, frame.seq, frame.payload] = message
        return list(found.values())

    @property
    def truth(self) -> tuple[float, float, float]:
        truth = self.link.simulated.world.truth()
        return truth.x_cm, truth.y_cm, math.degrees(truth.heading_rad)


def bid(ticket: int, command: BodyCommand) -> Bid:
    resource: Resource = "wheels"
    if isinstance(command, MoveLift):
        resource = "lift"
    elif isinstance(command, MoveGrip):
        resource = "grip"
    return Bid(resource, command, ticket)


def test_drive_forward_moves_20_cm_with_one_command() -> None:
    ride = Ride()
    took_s = ride.finish(bid(1, Travel(0.2, 1.0)))
    assert ride.truth == pytest.approx((20, 0, 0), abs=2)
    assert ride.done == {1}
    assert 1.0 <= took_s < 1.25
    (drive,) = ride.sent(Drive)
    assert isinstance(drive, Drive)
    assert drive.hold_ms == 1000


def test_turn_left_turns_90_degrees() -> None:
    ride = Ride()
    ride.finish(bid(1, Rotate(QUARTER, 1.0)))
    assert ride.truth == pytest.approx((0, 0, 90), abs=2)
    ride.finish(bid(2, Rotate(-QUARTER, 1.0)))
    assert ride.truth == pytest.approx((0, 0, 0), abs=2)


def test_a_long_drive_is_renewed_and_ends_exactly() -> None:
    ride = Ride()
    ride.finish(bid(1, Travel(0.2, 5.0)))
    assert ride.truth[0] == pytest.approx(100, abs=1.5)
    holds = [m.hold_ms for m in ride.sent(Drive) if isinstance(m, Drive)]
    assert holds[:3] == [2000, 2000, 2000]
    assert len(holds) == 4
    assert 1000 < holds[3] < 1200


def test_an_endless_drive_goes_on_until_nobody_bids_and_then_rests_at_once() -> None:
    ride = Ride()
    ride.run(6.0, bid(1, Travel(0.1, None)))
    assert ride.state.moving
    assert not ride.done
    assert len(ride.sent(Drive)) <= 6
    x_cm = ride.truth[0]
    ride.run(1.0)
    assert not ride.state.moving
    assert ride.truth[0] - x_cm < 1.5
    neutral = [m for m in ride.sent(Drive) if m == Drive(0, 0, 1, getattr(m, "not_after_ms", 0))]
    assert len(neutral) == 1
    assert not ride.done
    assert not ride.failed


def test_travel_and_turn_of_one_tick_mix_into_an_arc() -> None:
    ride = Ride()
    ride.finish(bid(1, Travel(0.2, 1.0)), bid(2, Rotate(QUARTER, 1.0)))
    radius_cm = 20 / QUARTER
    assert ride.truth == pytest.approx((radius_cm, radius_cm, 90), abs=2)
    assert ride.done == {1, 2}
    assert len(ride.sent(Drive)) == 1


def test_in_an_arc_the_shorter_ends_and_the_other_goes_on_with_its_rest() -> None:
    ride = Ride()
    ride.finish(bid(1, Travel(0.2, 0.5)), bid(2, Rotate(QUARTER, 2.0)))
    assert ride.truth[2] == pytest.approx(180, abs=5)
    assert math.hypot(*ride.truth[:2]) == pytest.approx(9.7, abs=1.5)
    assert ride.done == {1, 2}


def test_who_loses_the_wheels_goes_on_later_with_what_is_left() -> None:
    ride = Ride()
    mine, other = bid(1, Travel(0.2, 2.0)), bid(2, Rotate(QUARTER, 1.0))
    ride.run(1.0, mine)
    ride.finish(other)
    assert ride.done == {2}
    x_cm, _, heading = ride.truth
    assert heading == pytest.approx(90, abs=5)
    assert 15 < x_cm < 21
    ride.finish(mine)
    assert ride.done == {1, 2}
    assert x_cm + ride.truth[1] == pytest.approx(40, abs=2)


def test_another_speed_under_the_same_ticket_starts_over() -> None:
    ride = Ride()
    ride.run(0.5, bid(1, Travel(0.2, 1.0)))
    ride.finish(bid(1, Travel(0.1, 1.0)))
    assert 17 < ride.truth[0] < 21.5


def test_done_needs_the_far_ends_word_not_the_echo() -> None:
    ride = Ride()
    ride.drop = lambda m: isinstance(m, Telem) or getattr(m, "code", 0) == EventCode.MOVE_DONE
    ride.run(3.0, bid(1, Travel(0.2, 1.0)))
    assert ride.sent(Drive)
    assert not ride.done


def test_telemetry_stands_in_for_a_lost_move_done() -> None:
    ride = Ride()
    ride.drop = lambda m: getattr(m, "code", 0) == EventCode.MOVE_DONE
    assert ride.finish(bid(1, Travel(0.2, 1.0))) < 1.4
    assert ride.done == {1}


def test_a_move_done_that_overtakes_its_acknowledgement_counts() -> None:
    ride = Ride()
    held: list[Message] = []

    def late(message: Message) -> bool:
        if isinstance(message, Settled) and message not in held:
            held.append(message)
            return True
        return isinstance(message, Telem)

    ride.drop = late
    ride.run(0.3, bid(1, Travel(0.2, 0.1)))
    assert not ride.done
    ride.body.sense(held, 0.0, True)
    ride.tick([])
    assert ride.done == {1}


def test_the_reckoned_pose_is_near_the_true_one() -> None:
    ride = Ride()
    ride.finish(bid(1, Travel(0.2, 2.0)), bid(2, Rotate(0.7, 2.0)))
    ride.finish(bid(3, Travel(-0.2, 1.0)))
    x_cm, y_cm, heading = ride.truth
    assert (ride.state.x_m * 100, ride.state.y_m * 100) == pytest.approx((x_cm, y_cm), abs=3)
    assert math.degrees(ride.state.heading_rad) == pytest.approx(heading, abs=5)


def test_the_lift_goes_where_it_is_told_and_holds() -> None:
    ride = Ride()
    took_s = ride.finish(bid(1, MoveLift(0.5)))
    assert ride.state.lift == pytest.approx(0.5, abs=0.01)
    assert 1.0 <= took_s < 1.3
    ride.run(1.0)
    assert ride.state.lift == pytest.approx(0.5, abs=0.01)
    assert len(ride.sent(Lift)) == 1


def test_a_lift_nobody_bids_for_any_more_stays_where_it_is() -> None:
    ride = Ride()
    ride.run(0.5, bid(1, MoveLift(1.0)))
    at = ride.state.lift
    ride.run(1.0)
    assert ride.state.lift == pytest.approx(at, abs=0.05)
    assert 0.1 < ride.state.lift < 0.4


def test_wheels_lift_and_gripper_move_side_by_side() -> None:
    ride = Ride()
    ride.link.simulated.world.between_fingers("block", low=True)
    took_s = ride.finish(
        bid(1, Travel(0.1, 1.0)), bid(2, MoveLift(0.5)), bid(3, MoveGrip(0.0)), limit_s=3
    )
    assert took_s < 1.4
    assert ride.done == {1, 2, 3}


def test_a_grab_that_meets_nothing_has_missed() -> None:
    ride = Ride()
    ride.finish(bid(1, MoveGrip(0.0)))
    assert ride.failed == {1: "missed"}
    assert not ride.state.holding
    ride.finish(bid(2, MoveGrip(1.0)))
    assert ride.done == {2}
    assert ride.state.grip == pytest.approx(1.0, abs=0.01)


def test_closing_without_having_to_hold_is_no_miss() -> None:
    ride = Ride()
    ride.finish(bid(1, MoveGrip(0.0, must_hold=False)))
    assert ride.done == {1}


def test_a_block_is_gripped_carried_and_released() -> None:
    ride = Ride()
    ride.link.simulated.world.between_fingers("block", low=True)
    ride.finish(bid(1, MoveGrip(0.0)))
    assert ride.done == {1}
    assert ride.state.holding
    ride.finish(bid(2, Travel(-0.2, 1.0)))
    assert ride.state.holding
    assert ride.link.simulated.world.truth().holding is not None
    ride.finish(bid(3, MoveGrip(1.0)))
    assert not ride.state.holding
    assert len(ride.sent(Grip)) == 2


def test_a_load_that_is_taken_away_is_noticed() -> None:
    ride = Ride()
    ride.link.simulated.world.between_fingers("block", low=True)
    ride.finish(bid(1, MoveGrip(0.0)))
    ride.link.simulated.world.clear()
    ride.run(0.5)
    assert not ride.state.holding


@pytest.mark.parametrize("ahead_cm", [1, 4, 15, 38])
def test_the_range_is_from_the_grippers_front(ahead_cm: float) -> None:
    ride = Ride()
    ride.link.simulated.world.place("wall", ahead_cm)
    ride.run(0.2)
    assert ride.state.range_m is not None
    assert ride.state.range_m * 100 == pytest.approx(ahead_cm, abs=0.7)
    ride.link.simulated.world.nothing_within(40)
    ride.run(0.2)
    assert ride.state.range_m is None


def test_a_cut_link_fails_what_runs_and_nothing_is_resumed() -> None:
    ride = Ride()
    drive = bid(1, Travel(0.2, 2.0))
    paused = bid(2, Rotate(QUARTER, 1.0))
    ride.run(0.2, paused)
    ride.run(0.3, drive)
    ride.link.cut()
    ride.run(1.6, drive)
    assert not ride.state.connected
    assert ride.failed == {1: "link_lost", 2: "link_lost"}
    assert ride.link.simulated.device.state is not State.DRIVING
    ride.run(0.1, bid(3, MoveLift(1.0)))
    assert ride.failed[3] == "link_lost"
    ride.link.restore()
    ride.link.sent.clear()
    ride.run(2.0, drive, paused)
    assert ride.state.connected
    assert not ride.sent(Drive, Lift)


def test_a_lease_that_ended_on_the_way_is_a_failed_move() -> None:
    ride = Ride()
    drive = bid(1, Travel(0.2, 2.0))
    ride.run(0.5, drive)
    ride.link.cut()
    ride.run(0.5, drive)
    ride.link.restore()
    ride.run(1.0, drive)
    assert ride.failed == {1: "link_lost"}
    assert not ride.state.moving


def test_halt_forgets_everything_and_says_stopped() -> None:
    ride = Ride()
    bids = (bid(1, Travel(0.2, 2.0)), bid(2, MoveLift(1.0)), bid(3, MoveGrip(0.0)))
    ride.run(0.4, bids[0])
    ride.run(0.2, bid(4, Rotate(1.0, None)), bids[1], bids[2])
    ride.link.stop()
    ride.body.halt()
    ride.link.sent.clear()
    ride.run(1.0, *bids, bid(4, Rotate(1.0, None)))
    assert ride.failed == {1: "stopped", 2: "stopped", 3: "stopped", 4: "stopped"}
    assert not ride.sent(Drive, Grip)
    assert not ride.state.moving
    ride.finish(bid(5, Rotate(QUARTER, 1.0)))
    assert 5 in ride.done


def test_estop_is_reported_and_nothing_moves() -> None:
    ride = Ride()
    ride.run(0.3, bid(1, Travel(0.2, 2.0)))
    ride.link.stop(latch=True)
    ride.run(0.3, bid(1, Travel(0.2, 2.0)))
    assert ride.failed == {1: "stopped"}
    assert ride.state.estopped
    ride.run(0.3, bid(2, Travel(0.2, 2.0)))
    assert ride.failed[2] == "refused"
    assert not ride.state.moving


def test_an_ended_ticket_is_told_until_its_bid_is_gone_and_never_runs_again() -> None:
    ride = Ride()
    ride.finish(drive := bid(1, Travel(0.2, 0.2)))
    assert not ride.state.done
    now_s = 1000 + ride.link.now_s
    assert ride.body.act([drive], now_s) == []
    assert ride.body.sense([], now_s, True).done == {1}
    assert ride.body.act([drive], now_s) == []
    assert ride.body.sense([], now_s, True).done == {1}
    ride.body.act([], now_s)
    assert ride.body.sense([], now_s, True).done == frozenset()


def test_wheels_that_turn_though_nobody_wants_it_are_stopped() -> None:
    ride = Ride()
    ride.run(0.3, bid(1, Travel(0.2, 2.0)))
    ride.body.halt()  # but no STOP was sent
    ride.run(0.5)
    assert not ride.state.moving
    assert len(ride.sent(Drive)) == 2


@pytest.mark.parametrize("seed", range(3))
def test_a_dialogue_of_20_moves_finishes_over_a_stuttering_line(seed: int) -> None:
    ride = Ride(seed, PROFILES["hc05"])
    for number in range(20):
        turn = number % 2
        ride.finish(bid(number, Rotate(QUARTER, 0.5) if turn else Travel(0.2, 0.5)))
    assert len(ride.done) >= 18
    assert len(ride.done) + len(ride.failed) == 20


@pytest.mark.parametrize("seed", range(3))
def test_over_a_lossy_line_every_move_ends_one_way_or_the_other(seed: int) -> None:
    ride = Ride(seed, PROFILES["lossy"])
    for number in range(20):
        ride.finish(bid(number, Travel(0.2 - 0.4 * (number % 2), 0.5)))
    assert len(ride.done) >= 15
    assert len(ride.done) + len(ride.failed) == 20


def test_a_ride_replays_bit_for_bit() -> None:
    def run() -> tuple[list[tuple[float, bytes]], BodyState]:
        ride = Ride(3, PROFILES["lossy"])
        ride.run(2.0, bid(1, Travel(0.2, 1.0)), bid(2, Rotate(1.0, 2.0)))
        return ride.link.sent, ride.state

    assert run() == run()


def test_a_motion_without_end_is_smooth_and_ends_when_nobody_bids_for_it() -> None:
    """No pause at the renewals, and at rest within a moment of the end."""
    ride = Ride()
    forward = bid(1, Travel(0.2, None))
    ride.run(0.5, forward)
    last_m, slowest_m = ride.state.x_m, 1.0
    for _ in range(40):
        ride.run(0.2, forward)
        slowest_m, last_m = min(slowest_m, ride.state.x_m - last_m), ride.state.x_m
    assert slowest_m > 0.02
    assert ride.state.x_m == pytest.approx(0.2 * 8.5, abs=0.12)
    ride.run(0.3)
    at_rest_m = ride.state.x_m
    ride.run(1.0)
    assert ride.state.x_m == pytest.approx(at_rest_m, abs=0.001)
    assert at_rest_m - last_m < 0.04
