"""Addresses, right and wrong."""

import pytest

from daemon.link.port import (
    Address,
    AddressError,
    SerialAddress,
    SimulatedAddress,
    read_address,
)
from kernel.bodies.forklift.faults import PROFILES, Faults


@pytest.mark.parametrize(
    ("text", "means"),
    [
        ("serial:/dev/rfcomm0", SerialAddress("/dev/rfcomm0", 57600)),
        ("serial:/dev/ttyUSB0?baud=115200", SerialAddress("/dev/ttyUSB0", 115200)),
        ("serial:/dev/ttyUSB0#forklift", SerialAddress("/dev/ttyUSB0", 57600)),
        ("sim://forklift", SimulatedAddress("forklift", Faults(), 0)),
        ("sim://forklift/", SimulatedAddress("forklift", Faults(), 0)),
        (
            "sim://forklift?faults=hc05&seed=7",
            SimulatedAddress("forklift", PROFILES["hc05"], 7),
        ),
        (
            "sim://forklift?faults=drop=0.1,flip=0.2",
            SimulatedAddress("forklift", Faults(0.1, 0, 0.2)),
        ),
    ],
)
def test_an_address_means(text: str, means: Address) -> None:
    assert read_address(text) == means


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "expected serial:/dev/... or sim://forklift"),
        ("/dev/ttyUSB0", "expected serial:/dev/..."),
        ("usb:/dev/ttyUSB0", "expected serial:/dev/..."),
        ("bt://00:11:22:33:44:55/1", "not available in this version"),
        ("tcp://localhost:5000", "not available in this version"),
        ("serial:", "expected a device"),
        ("serial:/dev/x?speed=9600", "unknown option speed"),
        ("serial:/dev/x?baud=fast", "baud=fast: expected a whole number"),
        ("serial:/dev/x?baud=1", "baud=1: expected 300"),
        ("serial:/dev/x?baud=", "expected a whole number"),
        ("sim://submarine", "submarine"),
        ("sim://", "no name"),
        ("sim://forklift?faults=rain", "rain"),
        ("sim://forklift?seed=-1", "seed=-1"),
    ],
)
def test_a_wrong_address_is_told_what_is_wrong(text: str, says: str) -> None:
    with pytest.raises(AddressError) as caught:
        read_address(text)
    assert says in str(caught.value)
    assert isinstance(caught.value, ValueError)
