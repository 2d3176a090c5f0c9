"""FIND: which thing is meant?"""

from __future__ import annotations

from kernel.action.step import Run, Step, directive
from kernel.action.verdict import Verdict


@directive("FIND")
def find(step: Step) -> Run:
    """Bind a description to something in memory, newest first; a later failure in the chain comes back for another.

    Source: mind.md; FIND is named but not described in Connell 2019.
    """
    verdict = yield from step.look_up()
    if verdict is Verdict.FAILED:
        step.explain("nothing_found")
    return verdict
