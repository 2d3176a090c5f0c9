"""One definition: packing, the hash, and PROTOCOL.md in step with the code."""

import re
from dataclasses import dataclass
from enum import IntEnum
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import firmware_proto
from firmware_proto import messages
from firmware_proto.errors import LayoutError, PayloadError, UnknownMessageError
from firmware_proto.layout import Uint8, message
from firmware_proto.messages import Drive, Message, Stop, layouts, pack, unpack

PROTOCOL = Path(firmware_proto.__path__[0]) / "PROTOCOL.md"
RANGES = {
    "u8": (0, 255),
    "i8": (-128, 127),
    "u16": (0, 65535),
    "i16": (-32768, 32767),
    "u32": (0, 2**32 - 1),
}
ENUMS: tuple[type[IntEnum], ...] = (
    messages.Result,
    messages.State,
    messages.Flag,  # type: ignore[assignment]
    messages.EventCode,
    messages.ResetCause,
)


@st.composite
def any_message(draw: st.DrawFn) -> Message:
    layout = draw(st.sampled_from(layouts()))
    kind = getattr(messages, layout.name)
    made = kind(*(draw(st.integers(*RANGES[t])) for _, t in layout.fields))
    assert isinstance(made, Message)
    return made


@given(any_message())
def test_every_message_comes_back_as_it_was(sent: Message) -> None:
    number, payload = pack(sent)
    assert unpack(number, payload) == sent


def rows(columns: int) -> list[list[str]]:
    """The table rows of PROTOCOL.md with so many columns, without their headings."""
    found = []
    for line in PROTOCOL.read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if line.startswith("|") and len(cells) == columns and not set(line) <= set("|-"):
            found.append(cells)
    return found


def test_the_table_of_messages_is_the_code() -> None:
    table = [r for r in rows(4) if re.fullmatch(r"[0-9A-F]{2}", r[0])]
    code = [
        [
            f"{layout.number:02X}",
            layout.name,
            "to robot" if layout.number < 0x80 else "to host",
            ", ".join(f"{name} {kind}" for name, kind in layout.fields) or "-",
        ]
        for layout in layouts()
    ]
    assert table == code


def test_the_table_of_values_is_the_code() -> None:
    table = [r for r in rows(3) if r[1].isdigit()]
    assert table == [[e.__name__, str(int(m)), str(m.name)] for e in ENUMS for m in e]


def test_the_hash_covers_names_types_and_numbers() -> None:
    text = messages.definition_text()
    for layout in layouts():
        assert str(layout) in text
    assert "03 Drive left_permille:i16" in text
    assert "NO_LEASE=7" in text


def test_a_value_that_does_not_fit_is_named() -> None:
    with pytest.raises(LayoutError, match="left_permille=40000"):
        pack(Drive(40000, 0, 1))


def test_a_payload_of_another_length_is_refused() -> None:
    with pytest.raises(PayloadError) as caught:
        unpack(3, b"\0" * 7)
    assert (caught.value.name, caught.value.expected, caught.value.got) == ("Drive", 8, 7)


def test_an_unknown_number_is_refused() -> None:
    with pytest.raises(UnknownMessageError):
        unpack(0x7F, b"")


def test_two_messages_cannot_share_a_number() -> None:
    with pytest.raises(LayoutError, match="already Stop"):

        @message(0x06)
        @dataclass(frozen=True, slots=True)
        class Other(Message):
            value: Uint8

    assert unpack(0x06, b"") == Stop()


def test_a_field_without_a_wire_type_is_refused() -> None:
    with pytest.raises(LayoutError, match="value has no wire type"):

        @message(0x60)
        @dataclass(frozen=True, slots=True)
        class Loose(Message):
            value: int
