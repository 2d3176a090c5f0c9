"""Parts that fail are started again, with patience, and it is said once; the rest goes on."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from typing import Final

FIRST_WAIT_S: Final = 0.5
LONGEST_WAIT_S: Final = 10.0
STEADY_S: Final = 30.0  # a part that ran this long before it failed is given the short wait again


async def supervise(
    name: str,
    part: Callable[[], Awaitable[None]],
    report: Callable[[str, str], None],
    *,
    first_wait_s: float = FIRST_WAIT_S,
    longest_wait_s: float = LONGEST_WAIT_S,
) -> None:
    """Run a part until it returns or this is cancelled; start it again when it fails.

    Args:
        name: the part, for reports.
        part: makes and runs it; returning means that it is done for good.
        report: called with name and reason when the reason is not the one reported last.
    """
    loop = asyncio.get_running_loop()
    wait_s, told = first_wait_s, ""
    while True:
        began_s = loop.time()
        try:
            await part()
        except Exception as error:  # whatever it is, the other parts go on
            reason = str(error) or type(error).__name__
            if loop.time() - began_s > STEADY_S:
                wait_s, told = first_wait_s, ""
            if reason != told:
                report(name, reason)
                told = reason
            await asyncio.sleep(wait_s)
            wait_s = min(wait_s * 2, longest_wait_s)
        else:
            return
