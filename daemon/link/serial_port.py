"""A serial device, opened with pyserial and read on its descriptor by the event loop."""

from __future__ import annotations

import asyncio
import os
import termios
from contextlib import suppress

import serial

from daemon.link.port import PortError, SerialAddress

CHUNK = 4096
BACKLOG = 4096  # bytes waiting for a port that takes none; a session never has that many under way


async def open_serial(address: SerialAddress) -> SerialPort:
    """Open the device, in a thread: opening /dev/rfcomm0 pages the far end for seconds.

    Raises:
        PortError: it does not exist, is in use, or cannot be opened.
    """
    opening = asyncio.ensure_future(asyncio.to_thread(_open, address))
    try:
        device = await asyncio.shield(opening)
    except asyncio.CancelledError:
        opening.add_done_callback(_abandon)
        raise
    except (serial.SerialException, OSError, ValueError) as error:
        raise PortError(address.path, str(error)) from error
    return SerialPort(address.path, device)


def _open(address: SerialAddress) -> serial.Serial:
    return serial.Serial(address.path, address.baud, exclusive=True, timeout=0, write_timeout=0)


def _abandon(opening: asyncio.Future[serial.Serial]) -> None:
    """Nobody waits for it any more: it must not stay open."""
    if not opening.cancelled() and opening.exception() is None:
        opening.result().close()


class SerialPort:
    """An open serial device. Made by open_serial, within the event loop that is to read it."""

    def __init__(self, path: str, device: serial.Serial) -> None:
        self._path, self._device = path, device
        self._descriptor: int = device.fileno()
        self._loop = asyncio.get_running_loop()
        self._arrived: asyncio.Queue[bytes] = asyncio.Queue()
        self._waiting = bytearray()
        self._failure: str | None = None
        self._closed = False
        self._loop.add_reader(self._descriptor, self._readable)

    async def read(self) -> bytes:
        """The next bytes.

        Raises:
            PortError: the port is gone.
        """
        if self._arrived.empty() and self._failure is not None:
            raise PortError(self._path, self._failure)
        data = await self._arrived.get()
        if not data:
            raise PortError(self._path, self._failure or "closed")
        return data

    def write(self, data: bytes) -> None:
        """Send bytes as soon as the port takes them.

        Raises:
            PortError: the port is gone, or has taken nothing for too long.
        """
        if self._failure is not None:
            raise PortError(self._path, self._failure)
        if len(self._waiting) + len(data) > BACKLOG:
            self._fail("it takes no more bytes")
            raise PortError(self._path, "it takes no more bytes")
        self._waiting += data
        self._writable()

    def urgent(self, data: bytes) -> None:
        """Send bytes at once; what was waiting is dropped."""
        if self._closed:
            return
        self._waiting.clear()
        with suppress(OSError, termios.error):
            termios.tcflush(self._descriptor, termios.TCOFLUSH)
        self._waiting += data
        self._writable()

    def close(self) -> None:
        """Give the port back; bytes the system has taken are still sent."""
        if self._closed:
            return
        self._closed = True
        self._loop.remove_reader(self._descriptor)
        self._loop.remove_writer(self._descriptor)
        self._failure = self._failure or "closed"
        self._arrived.put_nowait(b"")
        with suppress(OSError, serial.SerialException):
            self._device.close()

    def _readable(self) -> None:
        try:
            data = os.read(self._descriptor, CHUNK)
        except (BlockingIOError, InterruptedError):
            return
        except OSError as error:
            self._fail(error.strerror or str(error))
            return
        if data:
            self._arrived.put_nowait(data)
        else:
            self._fail("the other end is gone")

    def _writable(self) -> None:
        try:
            taken = os.write(self._descriptor, self._waiting)
        except (BlockingIOError, InterruptedError):
            taken = 0
        except OSError as error:
            self._fail(error.strerror or str(error))
            return
        del self._waiting[:taken]
        if self._waiting:
            self._loop.add_writer(self._descriptor, self._writable)
        else:
            self._loop.remove_writer(self._descriptor)

    def _fail(self, problem: str) -> None:
        self._failure = self._failure or problem
        self._waiting.clear()
        self._loop.remove_reader(self._descriptor)
        self._loop.remove_writer(self._descriptor)
        self._arrived.put_nowait(b"")
