"""The far end: what moves it, and the things that stop it."""

import itertools

import pytest

from firmware_proto.device import Device
from firmware_proto.frame import Frame, FrameReader, encode, encode_message
from firmware_proto.messages import (
    CLEAR_KEY,
    Ack,
    Clear,
    Config,
    Drive,
    Estop,
    Event,
    EventCode,
    Flag,
    Grip,
    Heartbeat,
    Hello,
    HelloAck,
    Lift,
    Message,
    Pong,
    Result,
    State,
    Stop,
    Telem,
    number_of,
    unpack,
)

SESSION = 7


class Bench:
    """A device on a bench: whole frames in, messages out, time by hand."""

    def __init__(self, hello: bool = True, lease: bool = True) -> None:
        self.device = Device(
            clock_ms=2**32 - 1000
        )  # its clock wraps in every test that takes a second
        self.now_s = 0.0
        self.seq = 10
        self._reader = FrameReader()
        if hello:
            self.say(Hello(1), 10)
        if lease:
            self.say(Heartbeat(0))

    def say(
        self, message: Message, seq: int | None = None, session: int = SESSION
    ) -> list[Message]:
        """Send, by default with the next number; what comes back but for telemetry."""
        if seq is None:
            seq = self.seq = (self.seq + (not isinstance(message, Heartbeat))) & 0xFF
        self.device.receive(encode_message(message, session, seq), self.now_s)
        return [m for m in self.heard() if not isinstance(m, Telem)]

    def result(
        self, message: Message, seq: int | None = None, session: int = SESSION
    ) -> Result | None:
        answers = [m for m in self.say(message, seq, session) if isinstance(m, Ack)]
        return Result(answers[0].result) if answers else None

    def heard(self) -> list[Message]:
        return [unpack(f.number, f.payload) for f in self._reader.feed(self.device.transmit())]

    def wait(self, seconds: float, beating: bool = False) -> list[Message]:
        heard: list[Message] = []
        for step in itertools.count(1):
            if step > round(seconds * 1000):
                return heard
            self.now_s = round(self.now_s + 0.001, 3)
            self.device.advance(self.now_s)
            if beating and step % 100 == 0:
                self.device.receive(encode_message(Heartbeat(step), SESSION, 0), self.now_s)
            heard += self.heard()
        return heard

    @property
    def in_ms(self) -> int:
        """not_after_ms for 250 ms from now."""
        return (2**32 - 1000 + round(self.now_s * 1000) + 250) & 0xFFFF

    def drive(self, hold_ms: int = 1000, left: int = 400, right: int = 400) -> Drive:
        return Drive(left, right, hold_ms, self.in_ms)

    @property
    def turning(self) -> bool:
        pulses = self.device.pulses
        return (pulses.left_us, pulses.right_us) != (1500, 1500)


def events(heard: list[Message], code: EventCode) -> list[Event]:
    return [m for m in heard if isinstance(m, Event) and m.code == code]


def test_a_drive_runs_exactly_its_hold_and_says_so() -> None:
    bench = Bench()
    assert bench.result(bench.drive(700), seq=11) == Result.OK
    assert (bench.device.pulses.left_us, bench.device.pulses.right_us) == (1700, 1700)
    assert not events(bench.wait(0.699, beating=True), EventCode.MOVE_DONE)
    assert bench.turning
    (done,) = events(bench.wait(0.001), EventCode.MOVE_DONE)
    assert done.arg == 11
    assert not bench.turning


def test_without_heartbeats_the_lease_ends_it_after_300_ms() -> None:
    bench = Bench()
    bench.say(bench.drive(2000))
    bench.wait(0.299)
    assert bench.turning
    heard = bench.wait(0.001)
    assert not bench.turning
    assert [e.arg for e in events(heard, EventCode.LEASE_LOST)] == [1]
    assert bench.device.state == State.IDLE


def test_with_heartbeats_the_lease_goes_on() -> None:
    bench = Bench()
    bench.say(bench.drive(2000))
    bench.wait(1.9, beating=True)
    assert bench.turning


def test_a_heartbeat_of_another_session_renews_nothing() -> None:
    bench = Bench()
    bench.say(bench.drive(2000))
    bench.wait(0.25)
    assert bench.result(Heartbeat(1), session=SESSION + 1) == Result.BAD_SESSION
    bench.wait(0.05)
    assert not bench.turning


@pytest.mark.parametrize("command", [Drive(400, 400, 100), Lift(500, 500), Grip(0, 500)])
def test_nothing_moves_without_a_lease(command: Message) -> None:
    bench = Bench(lease=False)
    before = bench.device.pulses
    assert bench.result(command) == Result.NO_LEASE
    bench.wait(0.1)
    assert bench.device.pulses == before


def test_nothing_moves_before_a_session() -> None:
    bench = Bench(hello=False, lease=False)
    assert bench.result(Heartbeat(1)) == Result.BAD_SESSION
    assert bench.result(bench.drive()) == Result.BAD_SESSION
    assert not bench.wait(0.5)
    assert bench.device.state == State.BOOT


@pytest.mark.parametrize(
    "command",
    [
        Drive(1001, 0, 100, 250),
        Drive(0, -1001, 100, 250),
        Drive(1, 1, 0, 250),
        Drive(1, 1, 2001, 250),
        Lift(1001, 1, 250),
        Grip(0, 0, 250),
        Config(0, 300, 0, 0, 0),
        Config(50, 299, 0, 0, 0),
        Config(50, 501, 0, 0, 0),
        Clear(0),
    ],
)
def test_a_value_out_of_range_is_refused(command: Message) -> None:
    bench = Bench()
    bench.wait(1.0, beating=True)  # the clock's low 16 bits are at zero now
    assert bench.result(command) == Result.BAD_ARG
    assert not bench.turning


def test_a_late_command_is_refused_across_the_wrap_of_the_clock() -> None:
    bench = Bench()
    bench.wait(0.9, beating=True)
    written = bench.drive(1000)
    bench.wait(0.2, beating=True)
    assert bench.result(written) == Result.OK
    bench.wait(0.051, beating=True)
    assert bench.result(written) == Result.STALE


def test_a_repeated_number_is_answered_again_and_not_executed_again() -> None:
    bench = Bench()
    command = bench.drive(100)
    assert bench.result(command, seq=11) == Result.OK
    bench.wait(0.2)
    assert bench.result(command, seq=11) == Result.OK
    assert not bench.turning
    assert bench.result(bench.drive(101), seq=11) == Result.DUP
    assert not bench.turning


@pytest.mark.parametrize("seq", [10, 9, 200, (11 + 128) & 0xFF])
def test_a_number_behind_is_stale(seq: int) -> None:
    bench = Bench()
    bench.say(bench.drive(1), seq=11)
    bench.wait(0.1)
    assert bench.result(bench.drive(), seq=seq) == Result.STALE
    assert not bench.turning


@pytest.mark.parametrize(("session", "seq"), [(SESSION, 11), (SESSION + 1, 200), (0, 0)])
def test_stop_counts_in_any_session_with_any_number(session: int, seq: int) -> None:
    bench = Bench()
    bench.say(bench.drive(2000))
    bench.say(Lift(1000, 500, bench.in_ms))
    bench.wait(0.2)
    assert bench.result(Stop(), seq, session) == Result.OK
    lift = bench.device.pulses.lift_us
    bench.wait(0.05)
    assert not bench.turning
    assert bench.device.pulses.lift_us == lift < 1200


def test_a_command_that_stop_overtook_is_stale() -> None:
    bench = Bench()
    assert bench.result(Stop(), seq=12) == Result.OK
    assert bench.result(bench.drive(), seq=11) == Result.STALE
    assert not bench.turning


def test_estop_latches_until_cleared_with_the_key() -> None:
    bench = Bench()
    bench.say(bench.drive(2000))
    heard = bench.say(Estop())
    assert events(heard, EventCode.ESTOP)
    bench.say(Heartbeat(1))
    assert bench.result(bench.drive()) == Result.ESTOPPED
    assert bench.result(Clear(CLEAR_KEY + 1)) == Result.BAD_ARG
    assert bench.device.state == State.ESTOPPED
    assert bench.result(Clear()) == Result.OK
    assert bench.result(bench.drive()) == Result.NO_LEASE
    bench.say(Heartbeat(2))
    assert bench.result(bench.drive()) == Result.OK


def test_a_new_session_stops_the_wheels_and_takes_the_lease() -> None:
    bench = Bench()
    bench.say(bench.drive(2000))
    bench.say(Hello(1), seq=50, session=SESSION + 1)
    assert not bench.turning
    assert bench.result(bench.drive(), seq=51, session=SESSION + 1) == Result.NO_LEASE
    assert bench.result(bench.drive()) == Result.BAD_SESSION


def test_a_late_copy_of_hello_disturbs_nothing() -> None:
    bench = Bench()
    bench.say(bench.drive(2000), seq=11)
    (answer,) = bench.say(Hello(1), seq=10)
    assert isinstance(answer, HelloAck)
    assert bench.turning
    assert bench.result(bench.drive(5), seq=11) == Result.DUP


def test_lift_and_grip_slew_at_their_rate_and_hold_when_the_lease_ends() -> None:
    bench = Bench()
    bench.say(Lift(1000, 500, bench.in_ms))
    bench.say(Grip(0, 1000, bench.in_ms))
    bench.wait(0.2)
    assert bench.device.pulses.lift_us == pytest.approx(1100, abs=2)
    assert bench.device.pulses.grip_us == pytest.approx(1800, abs=2)
    bench.wait(0.5)
    assert bench.device.pulses.lift_us == pytest.approx(1150, abs=2)
    assert bench.device.pulses.grip_us == pytest.approx(1700, abs=2)


def test_the_guard_ends_a_forward_drive_and_lets_a_backward_one_pass() -> None:
    bench = Bench()
    bench.say(Config(50, 300, 2000, 0, 0))
    bench.device.sense(1999, 0, 0)
    bench.say(bench.drive())
    bench.wait(0.1)
    assert bench.turning
    bench.device.sense(2000, 0, 0)
    heard = bench.wait(0.1)
    assert [e.arg for e in events(heard, EventCode.GUARD)] == [2000]
    assert not events(heard, EventCode.MOVE_DONE)
    assert [Flag(m.flags) for m in heard if isinstance(m, Telem)][-1] == Flag.GUARDED
    assert bench.result(bench.drive(left=-400, right=-400)) == Result.OK
    bench.wait(0.05)
    assert bench.turning


def test_trims_move_neutral_and_config_lengthens_the_lease() -> None:
    bench = Bench()
    bench.say(Config(50, 500, 0, 12, -7))
    bench.say(Heartbeat(1))
    assert (bench.device.pulses.left_us, bench.device.pulses.right_us) == (1512, 1493)
    bench.say(bench.drive(2000))
    bench.wait(0.499)
    assert bench.device.state == State.DRIVING
    bench.wait(0.001)
    assert bench.device.state == State.IDLE


def test_telemetry_comes_twenty_times_a_second() -> None:
    bench = Bench()
    bench.device.sense(1, 2, 3)
    telemetry = [m for m in bench.wait(1.0, beating=True) if isinstance(m, Telem)]
    assert 19 <= len(telemetry) <= 21
    assert (telemetry[-1].range_adc, telemetry[-1].grip_adc, telemetry[-1].battery_adc) == (1, 2, 3)


def test_pong_returns_the_hosts_clock_and_its_own() -> None:
    bench = Bench()
    bench.wait(0.1)
    assert bench.say(Heartbeat(123456)) == [Pong(123456, 2**32 - 900)]


def test_unknown_messages_and_wrong_lengths_are_answered() -> None:
    bench = Bench()
    for frame, result in (
        (Frame(0x55, SESSION, 11, b""), Result.UNKNOWN),
        (Frame(number_of(Drive), SESSION, 11, b"\0"), Result.BAD_LEN),
        (Frame(number_of(Ack), SESSION, 11, b"\0\0\0"), Result.UNKNOWN),
    ):
        bench.device.receive(encode(frame), bench.now_s)
        (answer,) = (m for m in bench.heard() if not isinstance(m, Telem))
        assert answer == Ack(frame.number, 11, result)


def test_damaged_frames_are_counted_in_telemetry() -> None:
    bench = Bench()
    wire = bytearray(encode_message(Drive(1, 1, 1), SESSION, 11))
    wire[5] ^= 4
    bench.device.receive(bytes(wire) + b"\x01\x01\0", bench.now_s)
    telemetry = [m for m in bench.wait(0.1) if isinstance(m, Telem)]
    assert (telemetry[-1].crc_err, telemetry[-1].rx_drop) == (1, 1)
