"""Frames survive any cutting, and nothing that is not one passes for one."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from firmware_proto.errors import LayoutError
from firmware_proto.frame import (
    MAX_ENCODED,
    Frame,
    FrameReader,
    cobs_decode,
    cobs_encode,
    crc16,
    encode,
)

BYTE = st.integers(0, 255)
FRAMES = st.builds(Frame, BYTE, BYTE, BYTE, st.binary(max_size=24))
# bytes that look most like the beginning of a frame: delimiters, small run lengths, message numbers
TROUBLE = st.lists(st.sampled_from([0, 0, 1, 2, 3, 5, 6, 0x0E, 0xFF]), max_size=60).map(bytes)


def test_the_check_value_of_the_crc() -> None:
    assert crc16(b"123456789") == 0x29B1


@given(st.binary(max_size=253))
def test_cobs_hides_every_zero_and_gives_the_data_back(data: bytes) -> None:
    encoded = cobs_encode(data)
    assert 0 not in encoded
    assert len(encoded) == len(data) + 1
    assert cobs_decode(encoded) == data


@given(st.lists(FRAMES, max_size=6))
def test_frames_come_back_whole_when_fed_byte_by_byte(frames: list[Frame]) -> None:
    stream = b"".join(map(encode, frames))
    reader = FrameReader()
    read = [frame for byte in stream for frame in reader.feed(bytes((byte,)))]
    assert read == frames == FrameReader().feed(stream)
    assert (reader.crc_errors, reader.dropped) == (0, 0)


@given(TROUBLE, FRAMES)
def test_after_any_noise_the_next_frame_is_read(noise: bytes, frame: Frame) -> None:
    reader = FrameReader()
    assert reader.feed(noise + b"\0") == []
    assert reader.feed(encode(frame)) == [frame]


@given(FRAMES, st.data())
def test_one_wrong_bit_is_never_a_frame(frame: Frame, data: st.DataObject) -> None:
    wire = bytearray(encode(frame))
    bit = data.draw(st.integers(0, 8 * len(wire) - 1))
    wire[bit // 8] ^= 1 << bit % 8
    assert FrameReader().feed(bytes(wire) + b"\0") == []


def test_a_stream_without_end_is_bounded_and_counted() -> None:
    reader = FrameReader()
    for _ in range(1000):
        assert reader.feed(b"\x01" * 100) == []
    assert len(reader._pending) <= MAX_ENCODED
    assert reader.feed(b"\0" + encode(Frame(6, 1, 1, b""))) == [Frame(6, 1, 1, b"")]
    assert reader.dropped == 1


def test_a_failed_check_is_counted_apart_from_what_is_no_frame() -> None:
    reader = FrameReader()
    wire = bytearray(encode(Frame(3, 7, 9, b"\x01\x02\x03\x04")))
    wire[5] ^= 0x10
    reader.feed(bytes(wire))
    assert (reader.crc_errors, reader.dropped) == (1, 0)
    reader.feed(b"\x02\x01\0")
    assert (reader.crc_errors, reader.dropped) == (1, 1)


def test_a_payload_that_is_too_long_is_refused() -> None:
    with pytest.raises(LayoutError):
        encode(Frame(1, 1, 1, bytes(25)))
