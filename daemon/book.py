"""What clients of a running daemon may read of what it was taught and told. Nothing here holds up the loop."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from daemon.aside import Aside
from daemon.lessons import Row, rows
from daemon.logbook import Entry, entries
from daemon.writer import Writer
from kernel.memory.change import Change
from kernel.memory.lesson import Resting


class Book:
    """Reads the journal of the mind, and the store through its writer; works it out in a thread of its own.

    Args:
        history: every change, oldest first; asked in the loop.
        resting: lessons that rest.
        writer: has the store.
    """

    def __init__(
        self,
        history: Callable[[], tuple[Change, ...]],
        resting: tuple[Resting, ...],
        writer: Writer,
    ) -> None:
        self._history, self._resting, self._writer = history, resting, writer
        self._aside = Aside("book")

    async def lessons(self, after: int = 0, most: int | None = None) -> tuple[Row, ...]:
        """Lessons with a greater number, at most so many."""
        return await self._aside.run(rows, self._history(), self._resting, after, most)

    async def log(self, last: int) -> tuple[Entry, ...]:
        """The last entries of the log.

        Raises:
            sqlite3.Error: the store cannot be read.
        """
        said = await asyncio.wrap_future(self._writer.ask(lambda store: store.utterances(last)))
        return await self._aside.run(entries, said, self._history(), last)

    def close(self) -> None:
        """End the thread; does not wait."""
        self._aside.close()
