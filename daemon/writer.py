"""How changes of the policy reach the store: at once (virtual time), or through the one writer thread (real time)."""

from __future__ import annotations

import sqlite3
import threading
from collections import deque
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass
from queue import SimpleQueue
from typing import Protocol, TypeVar

from daemon.store import Store
from kernel.memory.change import Change

R = TypeVar("R")


@dataclass(frozen=True, slots=True)
class Kept:
    """A change is durable; it carries its numbers now."""

    key: int
    change: Change


@dataclass(frozen=True, slots=True)
class NotKept:
    """A change could not be stored. why: for a person."""

    key: int
    why: str


class Keeper(Protocol):
    """Where changes of the policy are made durable, at once or in a thread of its own."""

    def keep(self, key: int, change: Change, source: str = "") -> None:
        """Begin to store it. source: where its words came from."""

    def results(self) -> list[Kept | NotKept]:
        """What was decided since the last call."""


def _kept(store: Store, key: int, change: Change, source: str) -> Kept | NotKept:
    try:
        return Kept(key, store.add(change, source))
    except sqlite3.Error as error:
        return NotKept(key, str(error))


class AtOnce:
    """Stores in the caller's thread: deterministic, for virtual time."""

    def __init__(self, store: Store) -> None:
        self._store = store
        self._results: list[Kept | NotKept] = []

    def keep(self, key: int, change: Change, source: str = "") -> None:
        """Store it now; the result waits for `results`."""
        self._results.append(_kept(self._store, key, change, source))

    def results(self) -> list[Kept | NotKept]:
        """Results since the last call."""
        results, self._results = self._results, []
        return results


class Writer:
    """Stores in a thread of its own.

    Args:
        store: used by that thread alone from now on, until `close` returns.
        wake: called from that thread after each result.
        failed: called from that thread with the reason when something other than a change could not be written.
    """

    def __init__(
        self, store: Store, wake: Callable[[], None], failed: Callable[[str], None]
    ) -> None:
        self._store, self._wake, self._failed = store, wake, failed
        self._jobs: SimpleQueue[Callable[[], None] | None] = SimpleQueue()
        self._results: deque[Kept | NotKept] = deque()
        self._thread = threading.Thread(target=self._run, name="store", daemon=True)
        self._thread.start()

    def keep(self, key: int, change: Change, source: str = "") -> None:
        """Queue a change."""
        self._jobs.put(lambda: self._keep(key, change, source))

    def results(self) -> list[Kept | NotKept]:
        """Results since the last call."""
        return [self._results.popleft() for _ in range(len(self._results))]

    def log(self, at_s: float, text: str, speaker: str, source: str, kind: str) -> None:
        """Queue a line of the utterance log."""
        self._jobs.put(lambda: self._store.log(at_s, text, speaker, source, kind))

    def ask(self, question: Callable[[Store], R]) -> Future[R]:
        """Ask the store something in its thread, after what is queued."""
        answer: Future[R] = Future()

        def job() -> None:
            try:
                answer.set_result(question(self._store))
            except Exception as error:  # whoever waits for it decides what to make of it
                answer.set_exception(error)

        self._jobs.put(job)
        return answer

    def close(self, timeout_s: float = 0.5) -> None:
        """Finish what is queued and end the thread."""
        self._jobs.put(None)
        self._thread.join(timeout_s)

    def _keep(self, key: int, change: Change, source: str) -> None:
        self._results.append(_kept(self._store, key, change, source))
        self._wake()

    def _run(self) -> None:
        while (job := self._jobs.get()) is not None:
            try:
                job()
            except sqlite3.Error as error:
                self._failed(str(error))
