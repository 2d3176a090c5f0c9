"""The host's end of a session: numbers, acknowledgement, resending, heartbeats, stop. No port and no clock.

One Session is one connection attempt. It opens with HELLO, is ready once the far end has answered with the same
protocol and definition, and ends as lost or refused; trying again is somebody else's job. The caller feeds received
bytes to receive() and writes what poll() returns.

Stop and wait with a window of one: the next command leaves when the last has been answered. stop() goes past all
of that. Whatever became of a command handed to send() is told once, as Settled, among the received messages.
"""

from __future__ import annotations

import dataclasses
from collections import deque
from dataclasses import dataclass

from firmware_proto.errors import (
    DefinitionMismatchError,
    HandshakeError,
    PayloadError,
    ProtocolMismatchError,
    UnknownMessageError,
)
from firmware_proto.frame import Frame, FrameReader, encode_message
from firmware_proto.messages import (
    DEFINITION_HASH,
    MAX_LEASE_MS,
    MOTION,
    PROTOCOL_VERSION,
    Ack,
    Estop,
    Event,
    Heartbeat,
    Hello,
    HelloAck,
    Message,
    Pong,
    Result,
    Stop,
    Telem,
    number_of,
    unpack,
)
from firmware_proto.round_trip import RoundTrip
from firmware_proto.told import SessionState, Settled

HEARTBEAT_S = 0.1
EARLY_S = 0.02  # a heartbeat may leave this much early, so a 30 Hz loop beats every third tick, not every fourth
DEGRADED_S = 0.3
LOST_S = 1.0
OPENING_S = 2.0
HELLO_AGAIN_S = 0.2
RETRIES = 3
FRESH_S = 0.250  # a motion command is refused by the far end when it arrives later than this plus a round trip
HUNG_S = 0.2  # longer between two polls: it was this program that was silent, not the far end


@dataclass(slots=True)
class _Flight:
    """A sequenced command on the wire, waiting for its answer."""

    message: Message
    data: bytes
    seq: int
    queued_s: float
    sent_s: float
    copies: int = 1


class Session:
    """See the module. Times are seconds of one monotonic clock.

    Args:
        number: session number, 1 to 255, best random.
        first_seq: sequence number of HELLO, best random: with the session number it tells a repeat from a newcomer.
        now_s: now.
        stop_epoch: epoch to start from; a link hands it from attempt to attempt.
    """

    def __init__(self, number: int, first_seq: int, now_s: float, stop_epoch: int = 0) -> None:
        self.round_trip = RoundTrip()
        self.refusal: HandshakeError | None = None
        self.hello: HelloAck | None = None
        self._number, self._seq = number, first_seq & 0xFF
        self._state = SessionState.OPENING
        self._stop_epoch = stop_epoch
        self._reader = FrameReader()
        self._out = bytearray()
        self._told: list[Message] = []
        self._queue: deque[tuple[Message, float]] = deque()
        self._flight: _Flight | None = None
        self._stopping: _Flight | None = None
        self._opened_s = self._polled_s = self._beat_due_s = self._beat_sent_s = now_s
        self._waiting_since_s: float | None = None
        self._hello_due_s = now_s

    @property
    def state(self) -> SessionState:
        """Where this session stands."""
        return self._state

    @property
    def ready(self) -> bool:
        """The far end may be commanded."""
        return self._state in (SessionState.READY, SessionState.DEGRADED)

    @property
    def over(self) -> bool:
        """Nothing more comes of this session."""
        return self._state in (SessionState.LOST, SessionState.REFUSED)

    @property
    def stopping(self) -> bool:
        """A STOP is on its way and not acknowledged yet."""
        return self._stopping is not None

    @property
    def stop_epoch(self) -> int:
        """How many stops there were; a motion command computed under an earlier one is refused."""
        return self._stop_epoch

    def send(self, message: Message, epoch: int, now_s: float) -> bool:
        """Queue a command that was computed under this epoch. Whether it was taken; Settled follows either way."""
        if not self.ready or (isinstance(message, MOTION) and epoch < self._stop_epoch):
            self._told.append(Settled(message, None, None, 0.0))
            return False
        self._queue.append((message, now_s))
        return True

    def stop(self, now_s: float, latch: bool = False) -> int:
        """STOP (ESTOP with latch) past every queue; what was on its way is dropped. The new epoch."""
        self._stop_epoch += 1
        self._drop()
        seq, message = self._next_seq(), Estop() if latch else Stop()
        data = encode_message(message, self._number, seq)
        self._stopping = _Flight(message, data, seq, now_s, now_s)
        self._out[:] = b"\0" + data  # the zero ends whatever frame was cut off
        return self._stop_epoch

    def beat(self, now_s: float) -> None:
        """The control loop is alive; renews the far end's lease, every 100 ms."""
        if not self.ready or now_s < self._beat_due_s - EARLY_S or self._stopping is not None:
            return
        due_s = self._beat_due_s + HEARTBEAT_S
        self._beat_due_s = due_s if due_s > now_s else now_s + HEARTBEAT_S
        self._beat_sent_s = now_s
        if self._waiting_since_s is None:
            self._waiting_since_s = now_s
        beat = Heartbeat(int(now_s * 1000) & 0xFFFFFFFF)
        self._out += encode_message(beat, self._number, self._seq)

    def receive(self, data: bytes, now_s: float) -> list[Message]:
        """Take bytes from the far end; telemetry, events and settled commands come back, in order."""
        if data:
            for frame in self._reader.feed(data):
                if frame.session == self._number and not self.over:
                    self._handle(frame, now_s)
        told, self._told = self._told, []
        return told

    def poll(self, now_s: float) -> bytes:
        """Let time pass: resending, liveness. The bytes to write now."""
        if self._state is SessionState.OPENING:
            self._open(now_s)
        elif self.ready:
            self._watch(now_s)
        self._polled_s = now_s
        self._repeat_stop(now_s)
        if self.ready:
            self._resend(now_s)
        data, self._out = bytes(self._out), bytearray()
        return data

    def _handle(self, frame: Frame, now_s: float) -> None:
        try:
            message = unpack(frame.number, frame.payload)
        except (UnknownMessageError, PayloadError):
            return  # checked, and yet not ours: the definition hash decides about that at HELLO
        match message:
            case HelloAck():
                self._greeted(message, now_s)
            case Pong():
                self._alive(message, now_s)
            case Ack():
                self._answered(message, now_s)
            case Telem() | Event():
                if self.ready:
                    self._told.append(message)

    def _greeted(self, message: HelloAck, now_s: float) -> None:
        if self._state is not SessionState.OPENING:
            return
        self.hello = message
        if message.proto != PROTOCOL_VERSION:
            self._end(SessionState.REFUSED)
            self.refusal = ProtocolMismatchError(PROTOCOL_VERSION, message.proto)
        elif message.definition != DEFINITION_HASH:
            self._end(SessionState.REFUSED)
            self.refusal = DefinitionMismatchError(DEFINITION_HASH, message.definition)
        else:
            self._state = SessionState.READY
            self.round_trip.clocks(now_s, message.mcu_ms, HELLO_AGAIN_S)

    def _alive(self, message: Pong, now_s: float) -> None:
        seconds = ((int(now_s * 1000) - message.host_ms) & 0xFFFFFFFF) / 1000
        if seconds > LOST_S:
            return  # late beyond use
        self._waiting_since_s = None
        self.round_trip.took(seconds)
        self.round_trip.clocks(now_s, message.mcu_ms, seconds)
        if self._state is SessionState.DEGRADED:
            self._state = SessionState.READY

    def _answered(self, ack: Ack, now_s: float) -> None:
        stopping, flight = self._stopping, self._flight
        if stopping is not None and ack.of_seq == stopping.seq:
            self._stopping = None
        if (
            flight is None
            or ack.of_seq != flight.seq
            or ack.of_type != number_of(type(flight.message))
        ):
            return
        if flight.copies == 1:  # an answer to one of several copies measures nothing
            self.round_trip.took(now_s - flight.sent_s)
        self._flight = None
        waited_s = flight.sent_s - flight.queued_s
        result = Result(min(ack.result, max(Result)))
        self._told.append(Settled(flight.message, flight.seq, result, waited_s))
        if ack.result == Result.BAD_SESSION:
            self._end(SessionState.LOST)

    def _open(self, now_s: float) -> None:
        if now_s - self._opened_s > OPENING_S:
            self._end(SessionState.LOST)
        elif now_s >= self._hello_due_s:
            self._hello_due_s = now_s + HELLO_AGAIN_S
            self._out += encode_message(Hello(PROTOCOL_VERSION), self._number, self._seq)

    def _watch(self, now_s: float) -> None:
        """Liveness is a missing PONG; what the operating system believes of the line is not asked."""
        if self._waiting_since_s is None:
            return
        if now_s - self._polled_s > HUNG_S:
            self._waiting_since_s += now_s - self._polled_s
        silent_s = now_s - self._waiting_since_s
        if silent_s > LOST_S:
            self._end(SessionState.LOST)
        elif silent_s > DEGRADED_S:
            self._state = SessionState.DEGRADED

    def _repeat_stop(self, now_s: float) -> None:
        """Until it is acknowledged, or the lease has ended, as no heartbeat leaves meanwhile."""
        flight = self._stopping
        if flight is None or self.over:
            return
        if now_s - max(self._beat_sent_s, self._opened_s) > MAX_LEASE_MS / 1000:
            self._stopping = None
        elif now_s - flight.sent_s >= self.round_trip.resend_s:
            flight.sent_s = now_s
            self._out += flight.data

    def _resend(self, now_s: float) -> None:
        flight = self._flight
        if flight is not None and now_s - flight.sent_s >= self.round_trip.resend_s:
            if flight.copies > RETRIES:
                self._flight = None
                self._told.append(Settled(flight.message, flight.seq, None, 0.0))
            else:
                flight.copies += 1
                flight.sent_s = now_s
                self._out += flight.data
        while self._flight is None and self._stopping is None and self._queue:
            self._launch(*self._queue.popleft(), now_s)

    def _launch(self, message: Message, queued_s: float, now_s: float) -> None:
        seq = self._next_seq()
        timed = message
        if isinstance(message, MOTION):
            fresh_until_s = queued_s + FRESH_S + (self.round_trip.srtt_s or 0.0)
            not_after_ms = self.round_trip.mcu_ms(fresh_until_s) & 0xFFFF
            timed = dataclasses.replace(message, not_after_ms=not_after_ms)
        data = encode_message(timed, self._number, seq)
        self._flight = _Flight(message, data, seq, queued_s, now_s)
        self._out += data

    def _next_seq(self) -> int:
        self._seq = (self._seq + 1) & 0xFF
        return self._seq

    def _drop(self) -> None:
        if self._flight is not None:
            self._told.append(Settled(self._flight.message, self._flight.seq, None, 0.0))
            self._flight = None
        while self._queue:
            self._told.append(Settled(self._queue.popleft()[0], None, None, 0.0))

    def _end(self, state: SessionState) -> None:
        self._state = state
        self._drop()
