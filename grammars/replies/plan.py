"""What would be done: a dry run as a plan."""

from __future__ import annotations

from collections.abc import Sequence

from grammars.render import act_in_words
from grammars.render.moments import lasting
from grammars.render.reasons import lines
from grammars.replies import Said, aloud, renders
from grammars.replies.because import trouble_in_words
from kernel.memory.explanation import Plan, PlanStep

MOST_SPOKEN = 6  # steps


@renders(Plan)
def plan(reply: Plan) -> Said:
    """ "I would drive forward, then drive backward, then turn left, then turn right: 4 seconds in all." """
    return Said(lines(_told(reply, True)), aloud(lines(_told(reply, False))))


def _told(reply: Plan, timed: bool) -> list[str]:
    """The sentences; timed: with the times of each step, and every step."""
    plays = _plays(reply.steps)
    told = []
    if plays:
        shown = plays if timed else plays[:MOST_SPOKEN]
        steps = ", then ".join(_play(play, timed) for play in shown)
        more = f", and {len(plays) - len(shown)} more steps" if len(shown) < len(plays) else ""
        whole = "and so on" if reply.unfinished else f"{lasting(reply.whole_s)} in all"
        told.append(f"I would {steps}{more}: {whole}")
    if reply.trouble is not None:
        first, *more_told = trouble_in_words(reply.trouble, None)
        head = "but " if plays else "I would not, because "
        if reply.trouble.act is not None and reply.trouble.by is not None:
            head = f"I would not {act_in_words(reply.trouble.act)}, because "
        told += [head + first, *more_told]
    return told or ["I would do nothing"]


def _plays(steps: Sequence[PlanStep]) -> list[list[PlanStep]]:
    """Steps that go on at the same time, together."""
    plays: list[list[PlanStep]] = []
    for step in steps:
        if plays and step.begin_s < max(other.end_s for other in plays[-1]):
            plays[-1].append(step)
        else:
            plays.append([step])
    return plays


def _play(play: Sequence[PlanStep], timed: bool) -> str:
    return " and ".join(
        act_in_words(step.act) + (f" ({step.begin_s:.1f} to {step.end_s:.1f} s)" if timed else "")
        for step in play
    )
