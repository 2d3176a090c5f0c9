"""Frames: COBS( type, session, seq, payload, crc16 ) 00.

A zero byte ends every frame and occurs nowhere else, so a reader that joins in the middle, or is fed noise, is in
step again at the next zero. The CRC (CRC-16/IBM-3740, check value 29B1) decides what is a frame.
"""

from __future__ import annotations

import binascii
from dataclasses import dataclass

from firmware_proto.errors import LayoutError
from firmware_proto.layout import MAX_PAYLOAD, Message, pack

HEADER = 3
CRC = 2
MAX_BODY = HEADER + MAX_PAYLOAD + CRC
MAX_ENCODED = MAX_BODY + 1  # COBS adds one byte to anything shorter than 254


@dataclass(frozen=True, slots=True)
class Frame:
    """One checked frame. seq counts sequenced messages of a session; elsewhere it only names what is answered."""

    number: int
    session: int
    seq: int
    payload: bytes


def crc16(data: bytes) -> int:
    """CRC-16/IBM-3740 (avr-libc: _crc_xmodem_update from 0xFFFF)."""
    return binascii.crc_hqx(data, 0xFFFF)


def cobs_encode(data: bytes) -> bytes:
    """The same information without a zero byte, one byte longer. data is shorter than 254 bytes."""
    return b"".join(bytes((len(run) + 1,)) + run for run in data.split(b"\0"))


def cobs_decode(data: bytes) -> bytes | None:
    """The bytes behind an encoding that holds no zero; None where data encodes nothing."""
    runs = []
    at = 0
    while at < len(data):
        end = at + data[at]
        if end > len(data):
            return None
        runs.append(data[at + 1 : end])
        at = end
    return b"\0".join(runs)


def encode(frame: Frame) -> bytes:
    """A frame as it lies on the wire, with its closing zero.

    Raises:
        LayoutError: the payload is too long.
    """
    if len(frame.payload) > MAX_PAYLOAD:
        raise LayoutError(f"{len(frame.payload)} bytes of payload, at most {MAX_PAYLOAD}")
    body = bytes((frame.number, frame.session, frame.seq)) + frame.payload
    return cobs_encode(body + crc16(body).to_bytes(CRC, "little")) + b"\0"


def encode_message(message: Message, session: int, seq: int) -> bytes:
    """A message as it lies on the wire."""
    number, payload = pack(message)
    return encode(Frame(number, session, seq, payload))


class FrameReader:
    """Finds checked frames in a stream cut anywhere.

    Attributes:
        crc_errors: candidates of a plausible length whose check failed.
        dropped: candidates that were too short, too long, or no COBS.
    """

    def __init__(self) -> None:
        self.crc_errors = 0
        self.dropped = 0
        self._pending = bytearray()
        self._too_long = False

    def feed(self, data: bytes) -> list[Frame]:
        """Take the next bytes, return the frames they complete."""
        frames = []
        *ends, rest = data.split(b"\0")
        for part in ends:
            self._take(part)
            frame = self._close()
            if frame is not None:
                frames.append(frame)
        self._take(rest)
        return frames

    def _take(self, part: bytes) -> None:
        if len(self._pending) + len(part) > MAX_ENCODED:
            self._too_long = True
            self._pending.clear()
        elif not self._too_long:
            self._pending += part

    def _close(self) -> Frame | None:
        encoded, too_long = bytes(self._pending), self._too_long
        self._pending.clear()
        self._too_long = False
        if not encoded and not too_long:
            return None
        body = None if too_long else cobs_decode(encoded)
        if body is None or len(body) < HEADER + CRC:
            self.dropped += 1
            return None
        if crc16(body[:-CRC]) != int.from_bytes(body[-CRC:], "little"):
            self.crc_errors += 1
            return None
        return Frame(body[0], body[1], body[2], body[HEADER:-CRC])
