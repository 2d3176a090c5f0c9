"""The single definition of every message of protocol fk/1: a frozen dataclass and a number each.

The fields are the layout, in order, little-endian, without padding; both directions and the definition hash are
derived from them. A message is at most 24 bytes long. PROTOCOL.md is this file in prose; a test compares the two.
"""

from __future__ import annotations

import binascii
from dataclasses import dataclass
from enum import IntEnum, IntFlag

from firmware_proto.layout import (
    Int8,
    Int16,
    Message,
    Uint8,
    Uint16,
    Uint32,
    layouts,
    message,
    number_of,
    pack,
    unpack,
)

__all__ = ["Message", "layouts", "number_of", "pack", "unpack"]

PROTOCOL_VERSION = 1
MAX_HOLD_MS = 2000
LEASE_MS = 300
MAX_LEASE_MS = 500
CLEAR_KEY = 0xC1EA


class Result(IntEnum):
    """What became of a command, in Ack.result."""

    OK = 0
    DUP = 1  # this sequence number was already used for another message
    STALE = 2  # behind the last sequence number, or past its not_after_ms
    BAD_SESSION = 3
    BAD_LEN = 4
    BAD_ARG = 5
    ESTOPPED = 6
    NO_LEASE = 7
    UNKNOWN = 8


class State(IntEnum):
    """What the far end is doing, in Telem.state."""

    BOOT = 0  # no session yet
    IDLE = 1  # a session, but no lease: wheels neutral
    READY = 2  # the lease is held, wheels neutral
    DRIVING = 3  # a hold time is running
    ESTOPPED = 4  # latched; only CLEAR ends it


class Flag(IntFlag):
    """Bits of Telem.flags."""

    LIFT_SLEWING = 1
    GRIP_SLEWING = 2
    GUARDED = 4


class EventCode(IntEnum):
    """What happened, in Event.code. Best effort: the state is always derivable from Telem."""

    BOOT = 1  # arg: reset cause
    LEASE_LOST = 2  # arg: 1 if the wheels were turning
    MOVE_DONE = 3  # arg: sequence number of the DRIVE whose hold ran to its end
    ESTOP = 4
    GUARD = 5  # arg: range ADC that ended the drive


class ResetCause(IntEnum):
    """Why the microcontroller started, in HelloAck.reset_cause."""

    POWER_ON = 1
    EXTERNAL = 2
    BROWN_OUT = 4
    WATCHDOG = 8


@message(0x01)
@dataclass(frozen=True, slots=True)
class Hello(Message):
    """Host to robot. Open the session named in the header: wheels stop, the lease is cleared. Repeating is harmless."""

    proto: Uint8


@message(0x02)
@dataclass(frozen=True, slots=True)
class Heartbeat(Message):
    """Host to robot, every 100 ms from the control loop itself. Renews the lease; unsequenced; answered by Pong."""

    host_ms: Uint32


@message(0x03)
@dataclass(frozen=True, slots=True)
class Drive(Message):
    """Host to robot. Turn the wheels; the robot ends it by itself when the time is up. Both zero: neutral at once."""

    left_permille: Int16
    right_permille: Int16
    hold_ms: Uint16
    not_after_ms: Uint16 = 0


@message(0x04)
@dataclass(frozen=True, slots=True)
class Lift(Message):
    """Host to robot. Bring the lift to a height at a rate; on any failsafe it holds where it is."""

    target_permille: Uint16
    rate_permille_s: Uint16
    not_after_ms: Uint16 = 0


@message(0x05)
@dataclass(frozen=True, slots=True)
class Grip(Message):
    """Host to robot. Bring the gripper to an opening at a rate; on any failsafe it holds, a load is never dropped."""

    target_permille: Uint16
    rate_permille_s: Uint16
    not_after_ms: Uint16 = 0


@message(0x06)
@dataclass(frozen=True, slots=True)
class Stop(Message):
    """Host to robot. Wheels neutral, lift and grip hold. Valid in any session, with any number, without a lease."""


@message(0x07)
@dataclass(frozen=True, slots=True)
class Estop(Message):
    """Host to robot. As Stop, and latched: nothing moves until Clear."""


@message(0x08)
@dataclass(frozen=True, slots=True)
class Clear(Message):
    """Host to robot. Unlatch an Estop, nothing else."""

    key: Uint16 = CLEAR_KEY


@message(0x09)
@dataclass(frozen=True, slots=True)
class Config(Message):
    """Host to robot. Telemetry period, lease, guard (0: off) and neutral trims; the trims survive a power cycle."""

    telem_ms: Uint16
    lease_ms: Uint16
    guard_adc: Uint16
    trim_left_us: Int8
    trim_right_us: Int8


@message(0x80)
@dataclass(frozen=True, slots=True)
class Ack(Message):
    """Robot to host. Names what it answers."""

    of_type: Uint8
    of_seq: Uint8
    result: Uint8


@message(0x81)
@dataclass(frozen=True, slots=True)
class HelloAck(Message):
    """Robot to host. Who is there; the host refuses to arm on another proto or definition hash."""

    proto: Uint8
    fw: Uint16
    caps: Uint16
    boot_id: Uint16
    reset_cause: Uint8
    lease_ms: Uint16
    max_hold_ms: Uint16
    mcu_ms: Uint32
    definition: Uint32


@message(0x82)
@dataclass(frozen=True, slots=True)
class Pong(Message):
    """Robot to host. Answers a Heartbeat: round trip and clock offset follow from it."""

    host_ms: Uint32
    mcu_ms: Uint32


@message(0x90)
@dataclass(frozen=True, slots=True)
class Telem(Message):
    """Robot to host, 20 Hz. All that the far end knows; 12-bit oversampled ADC values, pulse widths in microseconds."""

    mcu_ms: Uint32
    state: Uint8
    flags: Uint8
    range_adc: Uint16
    grip_adc: Uint16
    battery_adc: Uint16
    left_us: Uint16
    right_us: Uint16
    lift_us: Uint16
    grip_us: Uint16
    crc_err: Uint16
    rx_drop: Uint16


@message(0x91)
@dataclass(frozen=True, slots=True)
class Event(Message):
    """Robot to host. Something happened; may be lost."""

    mcu_ms: Uint32
    code: Uint8
    arg: Uint16


MOTION = (Drive, Lift, Grip)


def definition_text() -> str:
    """What the hash covers: one line a message, then the numbers of the enumerations."""
    lines = [str(layout) for layout in layouts()]
    for kind in (Result, State, Flag, EventCode, ResetCause):
        lines.append(f"{kind.__name__} " + ",".join(f"{m.name}={int(m)}" for m in kind))
    return "\n".join(lines)


DEFINITION_HASH = binascii.crc32(definition_text().encode())
"""Both ends must have been made from the same definition; its CRC-32 is exchanged in HelloAck."""
