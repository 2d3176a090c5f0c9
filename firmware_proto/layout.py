"""How a dataclass becomes a message: its annotated fields are the layout, little-endian, without padding."""

from __future__ import annotations

import struct
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Annotated, TypeVar, get_type_hints

from firmware_proto.errors import LayoutError, PayloadError, UnknownMessageError

MAX_PAYLOAD = 24

Uint8 = Annotated[int, "B"]
Int8 = Annotated[int, "b"]
Uint16 = Annotated[int, "H"]
Int16 = Annotated[int, "h"]
Uint32 = Annotated[int, "I"]

TYPE_NAMES: Mapping[str, str] = {"B": "u8", "b": "i8", "H": "u16", "h": "i16", "I": "u32"}


class Message:
    """Base of everything that passes between the two ends, or is told by the session in their place."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class Layout:
    """How one message lies in its frame.

    Attributes:
        number: message id in the frame.
        name: class name.
        fields: (field, type) in order, types as u8, i16 ...
        packer: the same as a struct.
    """

    number: int
    name: str
    fields: tuple[tuple[str, str], ...]
    packer: struct.Struct

    def __str__(self) -> str:
        return f"{self.number:02X} {self.name} " + ",".join(f"{n}:{t}" for n, t in self.fields)


_MESSAGES: dict[int, type[Message]] = {}
_LAYOUTS: dict[type[Message], Layout] = {}

M = TypeVar("M", bound=type[Message])


def message(number: int) -> Callable[[M], M]:
    """Register a frozen dataclass as the message with this number. Apply it above @dataclass(slots=True).

    Raises:
        LayoutError: the number is taken, a field has no wire type, or the payload is too long.
    """

    def register(cls: M) -> M:
        if number in _MESSAGES:
            raise LayoutError(f"0x{number:02X} is already {_MESSAGES[number].__name__}")
        codes = []
        for name, hint in get_type_hints(cls, include_extras=True).items():
            code = getattr(hint, "__metadata__", (None,))[0]
            if code not in TYPE_NAMES:
                raise LayoutError(f"{cls.__name__}.{name} has no wire type")
            codes.append((name, str(code)))
        packer = struct.Struct("<" + "".join(code for _, code in codes))
        if packer.size > MAX_PAYLOAD:
            raise LayoutError(f"{cls.__name__} takes {packer.size} bytes, at most {MAX_PAYLOAD}")
        fields = tuple((name, TYPE_NAMES[code]) for name, code in codes)
        _MESSAGES[number] = cls
        _LAYOUTS[cls] = Layout(number, cls.__name__, fields, packer)
        return cls

    return register


def layouts() -> tuple[Layout, ...]:
    """Every message's layout, by number."""
    return tuple(_LAYOUTS[_MESSAGES[number]] for number in sorted(_MESSAGES))


def number_of(kind: type[Message]) -> int:
    """The number of a message class."""
    return _LAYOUTS[kind].number


def pack(msg: Message) -> tuple[int, bytes]:
    """Number and payload of a message.

    Raises:
        LayoutError: it is no message of the wire, or a value does not fit its field.
    """
    layout = _LAYOUTS.get(type(msg))
    if layout is None:
        raise LayoutError(f"{type(msg).__name__} is not a message of the wire")
    try:
        return layout.number, layout.packer.pack(*(getattr(msg, name) for name, _ in layout.fields))
    except struct.error as error:
        raise LayoutError(f"{msg}: {error}") from error


def unpack(number: int, payload: bytes) -> Message:
    """The message in a checked frame.

    Raises:
        UnknownMessageError: nobody declared this number.
        PayloadError: the payload has another length.
    """
    kind = _MESSAGES.get(number)
    if kind is None:
        raise UnknownMessageError(number)
    layout = _LAYOUTS[kind]
    if len(payload) != layout.packer.size:
        raise PayloadError(layout.name, layout.packer.size, len(payload))
    return kind(*layout.packer.unpack(payload))
