"""The serial port against a real PTY."""

import asyncio
import os
import tty
from collections.abc import AsyncIterator

import pytest

from daemon.link.port import PortError, SerialAddress
from daemon.link.serial_port import BACKLOG, SerialPort, open_serial

Pair = tuple[SerialPort, int]


@pytest.fixture
async def pair() -> AsyncIterator[Pair]:
    """An open port and the master end of its PTY."""
    master, slave = os.openpty()
    tty.setraw(slave)
    os.set_blocking(master, False)
    port = await open_serial(SerialAddress(os.ttyname(slave)))
    os.close(slave)
    yield port, master
    port.close()
    try:
        os.close(master)
    except OSError:
        return  # the test closed it


async def arrived(master: int, count: int) -> bytes:
    """The next bytes at the other end."""
    data = b""
    async with asyncio.timeout(2):
        while len(data) < count:
            try:
                data += os.read(master, 65536)
            except BlockingIOError:
                await asyncio.sleep(0)
    return data


async def test_bytes_go_both_ways_as_they_are(pair: Pair) -> None:
    port, master = pair
    everything = bytes(range(256))
    port.write(everything)
    assert await arrived(master, 256) == everything
    os.write(master, everything)
    got = b""
    async with asyncio.timeout(2):
        while len(got) < 256:
            got += await port.read()
    assert got == everything


async def test_a_port_that_does_not_exist_is_named() -> None:
    with pytest.raises(PortError, match="/dev/nonsense"):
        await open_serial(SerialAddress("/dev/nonsense"))


async def test_a_port_is_opened_by_one_only(pair: Pair) -> None:
    port, _ = pair
    with pytest.raises(PortError):
        await open_serial(SerialAddress(port._path))


async def test_a_hang_up_ends_read_and_write(pair: Pair) -> None:
    port, master = pair
    os.close(master)
    async with asyncio.timeout(2):
        with pytest.raises(PortError):
            await port.read()
    with pytest.raises(PortError):
        port.write(b"x")
    port.urgent(b"x")  # on the way out nothing is raised


async def test_urgent_bytes_go_past_what_waits(pair: Pair) -> None:
    port, master = pair
    while not port._waiting:
        port.write(bytes(2000))  # until the system takes no more
    port.write(b"waiting")
    port.urgent(b"\0STOP")
    got = b""
    while not got.endswith(b"\0STOP"):
        got += await arrived(master, 1)
    # What the other end's system had taken may come first; what waited here never comes.
    assert got.strip(b"\0") == b"STOP"


async def test_a_port_that_takes_nothing_fails_instead_of_growing(pair: Pair) -> None:
    port, _ = pair
    while not port._waiting:
        port.write(bytes(2000))
    port.write(bytes(1))
    with pytest.raises(PortError, match="takes no more"):
        port.write(bytes(BACKLOG))


async def test_close_wakes_who_reads_and_may_be_repeated(pair: Pair) -> None:
    port, _ = pair
    reading = asyncio.create_task(port.read())
    await asyncio.sleep(0)
    port.close()
    port.close()
    with pytest.raises(PortError):
        await reading
    port.urgent(b"late")
