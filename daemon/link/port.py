"""Ports by address: what an address means, and what a port is to the link.

    serial:/dev/rfcomm0    serial:/dev/ttyUSB0?baud=57600    sim://forklift    sim://forklift?faults=hc05&seed=1

A part after "#" names the body and is not the port's business.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol
from urllib.parse import parse_qsl

from kernel.bodies.forklift import faults as line_faults
from kernel.bodies.forklift.faults import PROFILES, Faults, FaultsError

BAUD = 57600
LATER = {
    "bt": "Bluetooth addresses are not available in this version; bind it and use serial:/dev/rfcomm0",
    "tcp": "TCP addresses are not available in this version; use serial:/dev/... or sim://forklift",
}


class PortError(Exception):
    """A port cannot be opened, or has failed."""

    def __init__(self, where: str, problem: str) -> None:
        super().__init__(f"{where}: {problem}")
        self.where, self.problem = where, problem


class AddressError(ValueError):
    """An address names no port."""

    def __init__(self, address: str, problem: str) -> None:
        super().__init__(f"robot address {address!r}: {problem}")
        self.address, self.problem = address, problem


@dataclass(frozen=True, slots=True)
class SerialAddress:
    """A serial device of the operating system."""

    path: str
    baud: int = BAUD


@dataclass(frozen=True, slots=True)
class SimulatedAddress:
    """The simulated robot, served on a PTY of its own."""

    body: str
    faults: Faults = PROFILES["none"]
    seed: int = 0


Address = SerialAddress | SimulatedAddress


class Port(Protocol):
    """Bytes to and from the far end, open from its making to close()."""

    async def read(self) -> bytes:
        """The next bytes.

        Raises:
            PortError: the port is gone.
        """

    def write(self, data: bytes) -> None:
        """Send bytes as soon as the port takes them; never waits.

        Raises:
            PortError: the port is gone, or has taken nothing for too long.
        """

    def urgent(self, data: bytes) -> None:
        """Send bytes at once; what was waiting is dropped. Never waits, never fails: for the way out."""

    def close(self) -> None:
        """Give the port back."""


def read_address(address: str) -> Address:
    """What an address means.

    Raises:
        AddressError: an unknown scheme or option, or a value out of range.
    """
    before, _, _ = address.partition("#")
    scheme, colon, rest = before.partition(":")
    if scheme in LATER and colon:
        raise AddressError(address, LATER[scheme])
    path, _, query = rest.partition("?")
    options = dict(parse_qsl(query, keep_blank_values=True))
    if scheme == "serial" and colon:
        return _serial(address, path, options)
    if scheme == "sim" and colon:
        return _simulated(address, path, options)
    raise AddressError(address, "expected serial:/dev/... or sim://forklift")


def _serial(address: str, path: str, options: dict[str, str]) -> SerialAddress:
    _only(address, options, ("baud",))
    if not path:
        raise AddressError(address, "expected a device, as in serial:/dev/ttyUSB0")
    baud = _number(address, options, "baud", BAUD)
    if not 300 <= baud <= 4_000_000:
        raise AddressError(address, f"baud={baud}: expected 300 to 4000000")
    return SerialAddress(path, baud)


def _simulated(address: str, path: str, options: dict[str, str]) -> SimulatedAddress:
    _only(address, options, ("faults", "seed"))
    body = path.strip("/")
    if body != "forklift":
        raise AddressError(address, f"{body or 'no name'}: the simulated robot is sim://forklift")
    try:
        faults = line_faults.read(options.get("faults", "none"))
    except FaultsError as error:
        raise AddressError(address, str(error)) from error
    return SimulatedAddress(body, faults, _number(address, options, "seed", 0))


def _only(address: str, options: dict[str, str], known: tuple[str, ...]) -> None:
    for name in options:
        if name not in known:
            raise AddressError(address, f"unknown option {name}; known are {', '.join(known)}")


def _number(address: str, options: dict[str, str], name: str, default: int) -> int:
    text = options.get(name, str(default))
    if not text.isascii() or not text.isdecimal():
        raise AddressError(address, f"{name}={text}: expected a whole number")
    return int(text)
