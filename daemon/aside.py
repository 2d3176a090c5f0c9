"""Work beside the loop, in a thread that nothing waits for on the way out."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable
from contextlib import suppress
from queue import SimpleQueue
from typing import ParamSpec, TypeVar

P = ParamSpec("P")
R = TypeVar("R")


class Aside:
    """One thread, one thing after another. Unlike an executor's, it is not joined when the process ends: a sentence
    that takes long to parse must not hold up SIGTERM.

    Args:
        name: of the thread.
    """

    def __init__(self, name: str) -> None:
        self._jobs: SimpleQueue[Callable[[], None] | None] = SimpleQueue()
        threading.Thread(target=self._work, name=name, daemon=True).start()

    def run(self, do: Callable[P, R], *args: P.args, **kwargs: P.kwargs) -> asyncio.Future[R]:
        """Do it over there; what it returns or raises comes with the future. Call from a running loop."""
        loop = asyncio.get_running_loop()
        future: asyncio.Future[R] = loop.create_future()

        def work() -> None:
            try:
                result = do(*args, **kwargs)
            except BaseException as error:  # the waiting side decides what to make of it
                told: Callable[[], None] = _telling_error(future, error)
            else:
                told = _telling(future, result)
            with suppress(RuntimeError):  # the loop is closed: nobody waits any more
                loop.call_soon_threadsafe(told)

        self._jobs.put(work)
        return future

    def close(self) -> None:
        """End the thread after what is queued; does not wait."""
        self._jobs.put(None)

    def _work(self) -> None:
        while (job := self._jobs.get()) is not None:
            job()


def _telling(future: asyncio.Future[R], result: R) -> Callable[[], None]:
    return lambda: None if future.done() else future.set_result(result)


def _telling_error(future: asyncio.Future[R], error: BaseException) -> Callable[[], None]:
    return lambda: None if future.done() else future.set_exception(error)
