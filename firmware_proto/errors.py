"""Errors of the wire. They carry data; the English for a person is made in grammars.replies."""

from __future__ import annotations


class WireError(Exception):
    """Base of every error raised by the wire."""


class LayoutError(WireError):
    """A message was declared, or filled, in a way its layout does not allow."""


class PayloadError(WireError):
    """The payload of a checked frame does not fit its message."""

    def __init__(self, name: str, expected: int, got: int) -> None:
        super().__init__(f"{name}: {expected} bytes expected, {got} received")
        self.name, self.expected, self.got = name, expected, got


class UnknownMessageError(WireError):
    """A checked frame carries a message number nobody declared."""

    def __init__(self, number: int) -> None:
        super().__init__(f"no message has the number 0x{number:02X}")
        self.number = number


class HandshakeError(WireError):
    """The far end answered, but it must not be driven."""


class ProtocolMismatchError(HandshakeError):
    """The far end speaks another protocol version."""

    def __init__(self, ours: int, theirs: int) -> None:
        super().__init__(f"the robot speaks protocol fk/{theirs}, this program fk/{ours}")
        self.ours, self.theirs = ours, theirs


class DefinitionMismatchError(HandshakeError):
    """Both ends speak the same version, but their messages were laid out from different definitions."""

    def __init__(self, ours: int, theirs: int) -> None:
        super().__init__(
            f"the robot's message definition is {theirs:08X}, this program's is {ours:08X}"
        )
        self.ours, self.theirs = ours, theirs
