"""The host's end against the far end, over good lines and bad ones, in virtual time."""

import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from firmware_proto.device import Device
from firmware_proto.errors import DefinitionMismatchError, ProtocolMismatchError
from firmware_proto.frame import FrameReader, encode_message
from firmware_proto.messages import (
    MOTION,
    Config,
    Drive,
    Event,
    EventCode,
    Heartbeat,
    Hello,
    Lift,
    Message,
    Result,
    State,
    Stop,
    Telem,
    number_of,
    unpack,
)
from firmware_proto.session import Session
from firmware_proto.told import SessionState, Settled

STEP_S = 0.005


class Road:
    """A session and a device with a line between them that drops, repeats and reorders whole frames."""

    def __init__(self, seed: int = 0, loss: float = 0.0, device: Device | None = None) -> None:
        self.chance = random.Random(seed)
        self.loss = loss
        self.device = device or Device(clock_ms=4_000_000_000)
        self.now_s = 100.0
        self.session = Session(9, 250, self.now_s)
        self.told: list[Message] = []
        self.wire: list[tuple[float, Message]] = []  # what the host wrote
        self.executed: list[Drive] = []
        self._up: list[tuple[float, bytes]] = []
        self._down: list[tuple[float, bytes]] = []
        self._reader = FrameReader()
        self.beating = True
        self.dead = False

    def run(self, seconds: float) -> None:
        for _ in range(round(seconds / STEP_S)):
            self.step()

    def connect(self) -> None:
        while self.session.state is not SessionState.READY:
            self.step()
        self.run(0.2)

    def step(self) -> None:
        self.now_s += STEP_S
        self.device.advance(self.now_s)
        self._pass(self._up, self._to_device)
        self._pass(self._down, self._to_host)
        if self.beating:
            self.session.beat(self.now_s)
        self.flush()
        self._travel(self._down, self.device.transmit())

    def flush(self) -> None:
        data = self.session.poll(self.now_s)
        for frame in self._reader.feed(data):
            self.wire.append((self.now_s, unpack(frame.number, frame.payload)))
        self._travel(self._up, data)
        self.told += self.session.receive(b"", self.now_s)

    def _to_device(self, data: bytes) -> None:
        before = self.device._drive
        self.device.receive(data, self.now_s)
        after = self.device._drive
        if after is not None and after is not before:
            self.executed.append(after)

    def _to_host(self, data: bytes) -> None:
        self.told += self.session.receive(data, self.now_s)

    def _travel(self, line: list[tuple[float, bytes]], data: bytes) -> None:
        for frame in data.split(b"\0")[:-1]:
            if not frame or self.dead or self.chance.random() < self.loss:
                continue
            for _ in range(2 if self.chance.random() < self.loss else 1):
                late = self.chance.uniform(0, 0.08) if self.chance.random() < self.loss else 0.0
                line.append((self.now_s + 0.004 + late, frame + b"\0"))

    def _pass(self, line: list[tuple[float, bytes]], take: object) -> None:
        arrived = sorted(item for item in line if item[0] <= self.now_s)
        line[:] = [item for item in line if item[0] > self.now_s]
        for _, data in arrived:
            assert callable(take)
            take(data)

    def send(self, message: Message) -> bool:
        taken = self.session.send(message, self.session.stop_epoch, self.now_s)
        self.flush()
        return taken

    def settled(self) -> list[Settled]:
        return [m for m in self.told if isinstance(m, Settled)]

    def written(self, kind: type[Message]) -> list[float]:
        return [at_s for at_s, m in self.wire if isinstance(m, kind)]


def ready(seed: int = 0, loss: float = 0.0) -> Road:
    road = Road(seed, loss)
    road.connect()
    return road


def test_hello_is_repeated_until_it_is_answered() -> None:
    road = Road()
    road.dead = True
    road.run(0.5)
    assert len(road.written(Hello)) == 3
    assert road.session.state is SessionState.OPENING
    road.dead = False
    road.run(0.2)
    assert road.session.state is SessionState.READY
    assert road.session.hello is not None


def test_a_far_end_that_never_answers_is_lost() -> None:
    road = Road()
    road.dead = True
    road.run(2.1)
    assert road.session.state is SessionState.LOST


def test_another_protocol_is_refused_by_name() -> None:
    road = Road(device=Device(proto=2))
    road.run(0.1)
    assert road.session.state is SessionState.REFUSED
    assert isinstance(road.session.refusal, ProtocolMismatchError)
    assert (road.session.refusal.ours, road.session.refusal.theirs) == (1, 2)


def test_another_definition_is_refused_and_never_driven() -> None:
    road = Road(device=Device(definition=0xBAD))
    road.run(0.1)
    assert isinstance(road.session.refusal, DefinitionMismatchError)
    assert "00000BAD" in str(road.session.refusal)
    assert not road.send(Drive(1, 1, 1))
    road.run(0.5)
    assert not road.written(Drive)
    assert not road.written(Heartbeat)


def test_heartbeats_leave_every_100_ms_and_only_when_the_loop_beats() -> None:
    road = ready()
    before = len(road.written(Heartbeat))
    road.run(1.0)
    assert 9 <= len(road.written(Heartbeat)) - before <= 11
    road.beating = False
    before = len(road.written(Heartbeat))
    road.run(1.0)
    assert len(road.written(Heartbeat)) == before
    assert road.session.state is SessionState.READY  # a silent host says nothing about the far end


def test_a_loop_of_30_hz_still_beats_every_100_ms() -> None:
    road = ready()
    road.beating = False
    start = len(road.written(Heartbeat))
    for tick in range(90):
        road.session.beat(road.now_s)
        road.run(0.035 if tick % 3 else 0.03)
    assert len(road.written(Heartbeat)) - start >= 28


def test_the_clock_offset_makes_a_command_fresh_for_a_quarter_of_a_second() -> None:
    road = ready()
    road.send(Drive(100, 100, 50))
    (drive,) = [m for _, m in road.wire if isinstance(m, Drive)]
    mcu_ms = road.device._mcu_ms()
    assert 240 <= (drive.not_after_ms - mcu_ms) & 0xFFFF <= 290


def test_silence_is_degraded_after_300_ms_and_lost_after_a_second() -> None:
    road = ready()
    road.dead = True
    states = []
    for _ in range(14):
        road.run(0.1)
        states.append(road.session.state)
    assert states[1] is SessionState.READY
    assert states[5] is SessionState.DEGRADED
    assert states[-1] is SessionState.LOST


def test_a_hung_host_does_not_take_its_own_silence_for_the_far_ends() -> None:
    road = ready()
    while road.session._waiting_since_s is None:  # until a PONG is due
        road.step()
    road.now_s += 5.0
    road.flush()
    assert not road.session.over


def test_degraded_recovers_with_the_next_pong() -> None:
    road = ready()
    road.dead = True
    road.run(0.6)
    assert road.session.state is SessionState.DEGRADED
    road.dead = False
    road.run(0.2)
    assert road.session.state is SessionState.READY


def test_one_command_is_under_way_at_a_time() -> None:
    road = ready()
    road.dead = True
    for target in (100, 200, 300):
        road.send(Lift(target, 500))
    assert len(road.written(Lift)) == 1


def test_without_an_answer_a_command_is_sent_four_times_and_given_up() -> None:
    road = ready()
    road.dead = True
    drive = Drive(100, 100, 100)
    road.send(drive)
    road.run(0.5)
    sent = [m for _, m in road.wire if isinstance(m, Drive)]
    assert len(sent) == 4
    assert len(set(sent)) == 1  # the same bytes: not_after_ms is not refreshed
    (settled,) = road.settled()
    assert settled.message is drive
    assert settled.result is None


def test_what_waits_in_the_queue_gets_old_and_is_refused() -> None:
    road = ready()
    road.dead = True
    road.send(Lift(100, 500))
    drive = Drive(100, 100, 100)
    road.send(drive)
    road.run(0.4)
    road.dead = False
    road.device.receive(
        encode_message(Heartbeat(0), 9, 0), road.now_s
    )  # the lease is not the reason
    road.run(0.3)
    assert {s.message: s.result for s in road.settled()}[drive] is Result.STALE
    assert not road.executed


def test_while_the_link_is_down_nothing_is_queued() -> None:
    road = Road()
    assert not road.send(Drive(1, 1, 1))
    road.connect()
    road.run(0.3)
    assert not road.written(Drive)
    assert [s.result for s in road.settled()] == [None]


@settings(max_examples=15)
@given(st.integers(0, 2**32), st.floats(0.0, 0.25))
def test_an_acknowledged_command_was_executed_exactly_once(seed: int, loss: float) -> None:
    road = ready(seed, loss)
    sent: list[Drive] = []
    for number in range(1, 30):
        if road.session.over:
            break
        sent.append(Drive(number, -number, 1))
        road.send(sent[-1])
        road.run(road.chance.uniform(0.0, 0.1))
    for _ in range(200):
        if len(road.settled()) == len(sent):
            break
        road.run(0.1)
    values = [drive.left_permille for drive in road.executed]
    assert len(values) == len(set(values))
    assert set(values) <= {drive.left_permille for drive in sent}
    settled = {s.message.left_permille: s for s in road.settled() if isinstance(s.message, Drive)}
    for value, told in settled.items():
        if told.result is Result.OK:
            assert value in values
    assert len(settled) == len(sent)
    assert len(road.settled()) == len(sent)


def test_stop_goes_past_the_queue_and_drops_it() -> None:
    road = ready()
    road.dead = True
    for target in (100, 200, 300):
        road.send(Lift(target, 500))
    epoch = road.session.stop(road.now_s)
    road.flush()
    assert epoch == 1 == road.session.stop_epoch
    assert isinstance(road.wire[-1][1], Stop)
    road.run(0.05)
    assert len(road.written(Lift)) == 1
    assert [s.result for s in road.settled()] == [None, None, None]


def test_motion_of_an_older_epoch_is_refused_and_settings_are_not() -> None:
    road = ready()
    road.session.stop(road.now_s)
    assert not road.session.send(Drive(1, 1, 1), 0, road.now_s)
    assert road.session.send(Config(50, 300, 0, 0, 0), 0, road.now_s)
    assert road.session.send(Drive(1, 1, 1), 1, road.now_s)


def test_stop_is_repeated_without_heartbeats_until_the_lease_has_ended() -> None:
    road = ready()
    road.send(Drive(400, 400, 2000))
    road.run(0.1)
    assert road.device.state is State.DRIVING
    road.dead = True
    stopped_s = road.now_s
    road.session.stop(road.now_s)
    road.run(0.45)
    assert 5 <= len(road.written(Stop)) <= 8
    assert not [at_s for at_s in road.written(Heartbeat) if at_s > stopped_s]
    assert road.device.state is State.IDLE
    road.run(0.3)
    assert len(road.written(Stop)) <= 10
    assert not road.session.stopping


def test_an_acknowledged_stop_is_not_repeated_and_the_next_epoch_moves() -> None:
    road = ready()
    road.send(Drive(400, 400, 2000))
    road.run(0.1)
    road.session.stop(road.now_s)
    road.run(0.3)
    assert len(road.written(Stop)) == 1
    assert road.device.state is State.READY
    assert road.send(Drive(100, 100, 100))
    road.run(0.05)
    assert road.device.state is State.DRIVING


def test_the_next_epoch_waits_until_the_stop_has_arrived() -> None:
    """Else a repeated STOP, meant for what was before it, would end what comes after it."""
    road = ready()
    road.dead = True
    road.session.stop(road.now_s)
    road.send(Lift(500, 500))
    road.run(0.15)
    assert not road.written(Lift)
    road.dead = False
    road.run(0.2)
    assert len(road.written(Lift)) == 1


def test_a_cut_off_frame_in_front_of_stop_does_not_hide_it() -> None:
    road = ready()
    road.session.stop(road.now_s)
    data = road.session.poll(road.now_s)
    road.device.receive(b"\x05\x03\x09" + data, road.now_s)
    assert number_of(Stop) in [
        f.payload[0] for f in FrameReader().feed(road.device.transmit()) if f.number == 0x80
    ]


def test_no_wheel_command_follows_a_stop_at_1000_random_moments() -> None:
    """A drive is renewed all the time over a line that loses, repeats and reorders; STOP comes somewhere."""
    stops = 0
    for seed in range(20):
        road = ready(seed, loss=0.15)
        while stops < 50 * (seed + 1) and not road.session.over:
            epoch = road.session.stop_epoch
            for _ in range(road.chance.randrange(1, 16)):
                if road.chance.random() < 0.3:
                    road.session.send(Drive(400, 400, 2000), epoch, road.now_s)
                road.step()
            road.session.stop(road.now_s)
            road.flush()
            stops += 1
            wire, executed = len(road.wire), len(road.executed)
            for _ in range(road.chance.randrange(1, 16)):
                road.session.send(
                    Drive(400, 400, 2000), epoch, road.now_s
                )  # the mind is a tick late
                road.step()
            assert not [m for _, m in road.wire[wire:] if isinstance(m, MOTION)]
            while road.session.stopping:
                road.step()
            assert road.device.state is not State.DRIVING
            road.run(0.05)
            assert road.device.state is not State.DRIVING
            late = road.executed[executed:]
            assert (
                len(late) <= 1
            )  # one that was on the line ahead of STOP, and that STOP then ended
    assert stops == 1000


def test_move_done_names_the_number_that_settled_told() -> None:
    road = ready()
    road.send(Drive(100, 100, 50))
    road.run(0.2)
    (settled,) = road.settled()
    done = [m for m in road.told if isinstance(m, Event) and m.code == EventCode.MOVE_DONE]
    assert [event.arg for event in done] == [settled.seq]


def test_a_resent_command_tells_how_long_it_waited() -> None:
    road = ready()
    road.dead = True
    road.send(Drive(100, 100, 50))
    road.run(0.03)
    road.dead = False
    road.run(0.2)
    (settled,) = road.settled()
    assert settled.result is Result.OK
    assert settled.waited_s == pytest.approx(0.06, abs=0.011)


def test_telemetry_arrives() -> None:
    road = ready()
    assert [m for m in road.told if isinstance(m, Telem)]
