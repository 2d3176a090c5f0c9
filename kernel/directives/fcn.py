"""FCN: call a grounding function and wait for its verdict."""

from __future__ import annotations

from kernel.action.step import Run, Step, directive


@directive("FCN")
def fcn(step: Step) -> Run:
    """The bridge to the body; the function's verdict is the directive's.

    Source: Connell 2019, section 4, operator with FCN[fcn-1 -lex- base_drive -arg-> act-1].
    """
    return (yield from step.call())
