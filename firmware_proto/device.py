"""The far end as a model: bytes in, bytes out, pulse widths for the servos; the firmware must behave like this.

Four things stop the wheels here: the hold time of every DRIVE, the lease that heartbeats renew, ESTOP, and a new
session. (The hardware watchdog has no model: this code cannot hang.) Motion needs all of them to agree.
"""

from __future__ import annotations

from firmware_proto import messages as wire
from firmware_proto.errors import PayloadError, UnknownMessageError
from firmware_proto.frame import Frame, FrameReader, encode_message
from firmware_proto.layout import Message, number_of, unpack
from firmware_proto.pulses import (
    NEUTRAL_US,
    SERVO_ZERO_US,
    SLEW_MAX_PERMILLE_S,
    WHEEL_US_PER_PERMILLE,
    Pulses,
    Slew,
)

FIRMWARE_VERSION = 1
CAPABILITIES = 0
TELEM_MS = 50
ANY_SESSION = (number_of(wire.Hello), number_of(wire.Stop), number_of(wire.Estop))


class Device:
    """Protocol, lease, hold time, slew and safety of the far end.

    The caller hands in bytes and sensor values, calls advance() often (the firmware: every millisecond), and takes
    bytes and pulses out. Times are seconds of the caller's clock, which must not go back; the microcontroller's own
    millisecond clock runs beside it from clock_ms.
    """

    def __init__(
        self,
        boot_id: int = 1,
        reset_cause: wire.ResetCause = wire.ResetCause.POWER_ON,
        clock_ms: int = 0,
        definition: int = wire.DEFINITION_HASH,
        proto: int = wire.PROTOCOL_VERSION,
    ) -> None:
        self._boot_id, self._reset_cause = boot_id, reset_cause
        self._clock_ms, self._definition, self._proto = clock_ms, definition, proto
        self._reader = FrameReader()
        self._out = bytearray()
        self._now_s = 0.0
        self._session: int | None = None
        self._opened_by: tuple[int, int] | None = None
        self._last_seq = 0
        self._answer: tuple[Frame, wire.Ack] | None = None
        self._lease_ms = wire.LEASE_MS
        self._lease_until_s: float | None = None
        self._estopped = False
        self._drive: wire.Drive | None = None
        self._drive_seq, self._drive_until_s = 0, 0.0
        self._lift, self._grip = Slew(0.0, 0.0), Slew(1000.0, 1000.0)
        self._config = wire.Config(TELEM_MS, wire.LEASE_MS, 0, 0, 0)
        self._telem_due_s = 0.0
        self._adc = (0, 0, 0)
        self._guarded = False

    @property
    def pulses(self) -> Pulses:
        """What the four servos are being told now."""
        drive = self._drive
        return Pulses(
            self._wheel_us(drive.left_permille if drive else 0, self._config.trim_left_us),
            self._wheel_us(drive.right_permille if drive else 0, self._config.trim_right_us),
            SERVO_ZERO_US + round(self._lift.at),
            SERVO_ZERO_US + round(self._grip.at),
        )

    @property
    def state(self) -> wire.State:
        """As reported in telemetry."""
        if self._estopped:
            return wire.State.ESTOPPED
        if self._session is None:
            return wire.State.BOOT
        if self._drive is not None:
            return wire.State.DRIVING
        return wire.State.READY if self._lease_until_s is not None else wire.State.IDLE

    def sense(self, range_adc: int, grip_adc: int, battery_adc: int) -> None:
        """The latest converted sensor values, 0 to 4095."""
        self._adc = (range_adc, grip_adc, battery_adc)

    def receive(self, data: bytes, now_s: float) -> None:
        """Take bytes from the host."""
        self.advance(now_s)
        if data:
            for frame in self._reader.feed(data):
                self._handle(frame)

    def advance(self, now_s: float) -> None:
        """Let time pass: hold time, lease, slew, guard, telemetry."""
        dt_s, self._now_s = max(0.0, now_s - self._now_s), max(now_s, self._now_s)
        for slew in (self._lift, self._grip):
            if slew.moving:
                slew.advance(dt_s)
        if self._lease_until_s is not None and self._now_s >= self._lease_until_s:
            self._lease_until_s = None
            turning = self._halt()
            self._tell(wire.EventCode.LEASE_LOST, int(turning))
        if self._drive is not None and self._now_s >= self._drive_until_s:
            self._drive = None
            self._tell(wire.EventCode.MOVE_DONE, self._drive_seq)
        self._guard()
        if self._session is not None and self._now_s >= self._telem_due_s:
            self._telem_due_s = self._now_s + self._config.telem_ms / 1000
            self._send(self._telemetry(), 0)

    def transmit(self) -> bytes:
        """Bytes for the host since the last call."""
        data, self._out = bytes(self._out), bytearray()
        return data

    def _handle(self, frame: Frame) -> None:
        try:
            message = unpack(frame.number, frame.payload)
        except UnknownMessageError:
            self._refuse(frame, wire.Result.UNKNOWN)
            return
        except PayloadError:
            self._refuse(frame, wire.Result.BAD_LEN)
            return
        if frame.number not in ANY_SESSION and frame.session != self._session:
            self._refuse(frame, wire.Result.BAD_SESSION)
            return
        match message:
            case wire.Hello():
                self._hello(frame)
            case wire.Stop() | wire.Estop():
                self._stop(frame, latch=isinstance(message, wire.Estop))
            case wire.Heartbeat(host_ms):
                if not self._estopped:
                    self._lease_until_s = self._now_s + self._lease_ms / 1000
                self._send(wire.Pong(host_ms, self._mcu_ms()), frame.seq)
            case wire.Drive() | wire.Lift() | wire.Grip() | wire.Clear() | wire.Config():
                self._in_order(frame, message)
            case _:
                self._refuse(frame, wire.Result.UNKNOWN)

    def _hello(self, frame: Frame) -> None:
        opened_by = (frame.session, frame.seq)
        # else it is a repeat, possibly a late one: answer, and disturb nothing
        if opened_by != self._opened_by:
            self._opened_by = opened_by
            self._session, self._last_seq = frame.session, frame.seq
            self._answer = self._lease_until_s = None
            self._halt()
            self._telem_due_s = self._now_s
        self._send(
            wire.HelloAck(
                self._proto,
                FIRMWARE_VERSION,
                CAPABILITIES,
                self._boot_id,
                self._reset_cause,
                self._lease_ms,
                wire.MAX_HOLD_MS,
                self._mcu_ms(),
                self._definition,
            ),
            frame.seq,
        )

    def _stop(self, frame: Frame, latch: bool) -> None:
        self._halt()
        if latch and not self._estopped:
            self._estopped = True
            self._lease_until_s = None
            self._tell(wire.EventCode.ESTOP, 0)
        if frame.session == self._session and self._ahead(frame.seq):
            # what the host sent before this, and the line still holds, is behind from now on
            self._last_seq = frame.seq
            self._answer = None
        self._send(wire.Ack(frame.number, frame.seq, wire.Result.OK), frame.seq)

    def _in_order(self, frame: Frame, message: Message) -> None:
        """Execute a sequenced command once, whatever the line repeats."""
        if self._answer is not None and frame.seq == self._last_seq:
            known, answer = self._answer
            self._send(
                answer if known == frame else wire.Ack(frame.number, frame.seq, wire.Result.DUP),
                frame.seq,
            )
            return
        if not self._ahead(frame.seq):
            self._refuse(frame, wire.Result.STALE)
            return
        answer = wire.Ack(frame.number, frame.seq, self._execute(message, frame.seq))
        self._last_seq, self._answer = frame.seq, (frame, answer)
        self._send(answer, frame.seq)

    def _execute(self, message: Message, seq: int) -> wire.Result:
        match message:
            case wire.Clear(key):
                if key != wire.CLEAR_KEY:
                    return wire.Result.BAD_ARG
                self._estopped = False
                return wire.Result.OK
            case wire.Config() as config:
                if (
                    config.telem_ms == 0
                    or not wire.LEASE_MS <= config.lease_ms <= wire.MAX_LEASE_MS
                ):
                    return wire.Result.BAD_ARG
                self._config, self._lease_ms = config, config.lease_ms
                return wire.Result.OK
            case wire.Drive() | wire.Lift() | wire.Grip():
                if self._estopped:
                    return wire.Result.ESTOPPED
                if self._lease_until_s is None:
                    return wire.Result.NO_LEASE
                if self._late(message.not_after_ms):
                    return wire.Result.STALE
                return self._move(message, seq)
            case _:
                return wire.Result.UNKNOWN

    def _move(self, message: wire.Drive | wire.Lift | wire.Grip, seq: int) -> wire.Result:
        if isinstance(message, wire.Drive):
            if not 1 <= message.hold_ms <= wire.MAX_HOLD_MS:
                return wire.Result.BAD_ARG
            if max(abs(message.left_permille), abs(message.right_permille)) > 1000:
                return wire.Result.BAD_ARG
            neutral = message.left_permille == message.right_permille == 0
            self._drive, self._drive_seq = (None if neutral else message), seq
            self._drive_until_s = self._now_s + message.hold_ms / 1000
            self._guarded = False
            return wire.Result.OK
        if message.target_permille > 1000 or not 0 < message.rate_permille_s <= SLEW_MAX_PERMILLE_S:
            return wire.Result.BAD_ARG
        slew = self._lift if isinstance(message, wire.Lift) else self._grip
        slew.target, slew.rate = message.target_permille, message.rate_permille_s
        return wire.Result.OK

    def _halt(self) -> bool:
        """Wheels neutral, lift and grip hold. Whether the wheels were turning."""
        turning = self._drive is not None
        self._drive = None
        self._lift.hold()
        self._grip.hold()
        return turning

    def _guard(self) -> None:
        drive, limit, range_adc = self._drive, self._config.guard_adc, self._adc[0]
        if drive is None or limit == 0 or range_adc < limit:
            return
        if drive.left_permille + drive.right_permille > 0:
            self._drive = None
            self._guarded = True
            self._tell(wire.EventCode.GUARD, range_adc)

    def _ahead(self, seq: int) -> bool:
        return 0 < (seq - self._last_seq) & 0xFF < 0x80

    def _late(self, not_after_ms: int) -> bool:
        return (not_after_ms - self._mcu_ms()) & 0xFFFF >= 0x8000

    def _mcu_ms(self) -> int:
        return (self._clock_ms + round(self._now_s * 1000)) & 0xFFFFFFFF

    def _refuse(self, frame: Frame, result: wire.Result) -> None:
        self._send(wire.Ack(frame.number, frame.seq, result), frame.seq)

    def _tell(self, code: wire.EventCode, arg: int) -> None:
        if self._session is not None:
            self._send(wire.Event(self._mcu_ms(), code, arg), 0)

    def _send(self, message: Message, seq: int) -> None:
        self._out += encode_message(message, self._session or 0, seq)

    def _telemetry(self) -> wire.Telem:
        flags = (
            (wire.Flag.LIFT_SLEWING if self._lift.moving else wire.Flag(0))
            | (wire.Flag.GRIP_SLEWING if self._grip.moving else wire.Flag(0))
            | (wire.Flag.GUARDED if self._guarded else wire.Flag(0))
        )
        pulses = self.pulses
        return wire.Telem(
            self._mcu_ms(),
            self.state,
            flags,
            *self._adc,
            pulses.left_us,
            pulses.right_us,
            pulses.lift_us,
            pulses.grip_us,
            min(self._reader.crc_errors, 0xFFFF),
            min(self._reader.dropped, 0xFFFF),
        )

    @staticmethod
    def _wheel_us(permille: int, trim_us: int) -> int:
        return NEUTRAL_US + trim_us + round(permille * WHEEL_US_PER_PERMILLE)
