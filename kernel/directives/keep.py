"""KEEP: see that it stays so."""

from __future__ import annotations

from typing import Final

from kernel.action.achieving import achieve
from kernel.action.step import Run, Step, directive
from kernel.action.verdict import Verdict

RETRY_S: Final = 1.0  # ours: between an attempt that failed and the next


@directive("KEEP")
def keep(step: Step) -> Run:
    """Watch; each time it is not so, achieve it as ACH does. Never ends by itself: its play ends it, or a stop.

    What cannot be achieved is said once and tried again every second, as the world may change. What the robot is not
    to do meanwhile ("drive to the door without turning") is ended as STOP does whenever it begins (both ours).

    Source: mind.md; KEEP is named but not described in Connell 2019.
    """
    while True:
        if step.avoids:
            step.halt()
        elif not step.is_so():
            verdict = yield from achieve(step)
            if verdict is Verdict.STOPPED:
                return verdict
            if verdict is Verdict.FAILED:
                step.complain("not_achieved")
                yield from step.pause(RETRY_S)
        step.waits("condition")
        yield
