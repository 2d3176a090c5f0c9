"""Work beside the loop: its results and errors come back, and nothing waits for it on the way out."""

from __future__ import annotations

import asyncio
import subprocess
import sys
import threading
from typing import NoReturn

import pytest

from daemon.aside import Aside


async def test_results_come_back_in_order_from_one_other_thread() -> None:
    aside = Aside("test")
    threads = await asyncio.gather(*(aside.run(threading.get_ident) for _ in range(5)))
    assert len(set(threads)) == 1
    assert threads[0] != threading.get_ident()
    assert await asyncio.gather(*(aside.run(pow, 2, n) for n in range(5))) == [1, 2, 4, 8, 16]
    aside.close()


async def test_errors_come_back() -> None:
    def fail() -> NoReturn:
        raise KeyError("act-1")

    aside = Aside("test")
    with pytest.raises(KeyError, match="act-1"):
        await aside.run(fail)
    assert await aside.run(lambda: 7) == 7  # the thread goes on
    aside.close()


async def test_who_no_longer_waits_is_no_problem() -> None:
    aside = Aside("test")
    go = threading.Event()
    waiting = aside.run(go.wait)
    waiting.cancel()
    go.set()
    assert await aside.run(lambda: 7) == 7
    aside.close()


def test_the_process_ends_while_it_works() -> None:
    code = (
        "import asyncio, time\n"
        "from daemon.aside import Aside\n"
        "async def main():\n"
        "    Aside('slow').run(time.sleep, 60)\n"
        "    await asyncio.sleep(0.05)\n"
        "asyncio.run(main())\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=20)
