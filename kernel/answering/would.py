"""What would you do if: a dry run."""

from __future__ import annotations

from kernel.asking import Asking, answers
from kernel.memory.explanation import Plan
from kernel.net.graphlet import Graphlet


@answers("would")
def would(asking: Asking) -> Plan:
    """What a command, an order of somebody's, or a fact that is noticed, would lead to."""
    question = asking.question
    ordered = _ordered(asking)
    if question.chain is not None:
        found = asking.imagine(question.chain)
    elif ordered is not None:
        found = asking.imagine(asking.command(ordered), _speaker(asking))
    else:
        found = asking.imagine(question.about)
    return Plan(question, found.steps, found.whole_s, found.unfinished, found.trouble)


def _ordered(asking: Asking) -> Graphlet | None:
    """The act in "if Rick tells you to turn left"; any act at all is none."""
    name = next((other for role, other in asking.main.links if role == "cmd"), "")
    about = asking.question.about
    if not any(term.name == name and term.lex for term in about):
        return None
    return Graphlet(tuple(term for term in about if term.name != about.main), name)


def _speaker(asking: Asking) -> str:
    """Who gives the order there; "" for whoever asks."""
    agents = [other for role, other in asking.main.links if role == "agt"]
    names = [term.lex - {"me"} for term in asking.question.about if term.name in agents]
    return next((min(lex) for lex in names if lex), "")
