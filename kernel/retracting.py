"""Taking lessons back by their numbers: what `sayso forget 3` asks for."""

from __future__ import annotations

from kernel.action.step import Run
from kernel.action.verdict import Verdict
from kernel.commons import Commons
from kernel.memory.attention import Focus
from kernel.memory.change import Change


def retract(commons: Commons, focus: Focus, by: str, numbers: tuple[int, ...]) -> Run:
    """Take lessons out of force: one entry of the journal, that counts once it is durable.

    A number that is not a lesson's in force changes nothing; what the robot was born with (below zero) stays.
    """
    taught = tuple(n for n in dict.fromkeys(numbers) if n > 0)
    utterance = focus.heard.utterance if focus.heard else None
    words, at_s = (utterance.text, utterance.at_s) if utterance else ("", 0.0)
    key = commons.keep(focus, Change(by=by, words=words, at_s=at_s, retracted=taught))
    while key in commons.pending:
        yield
    failure = focus.failure
    refused = failure is not None and failure.reason == "not_stored"
    return Verdict.FAILED if refused else Verdict.SUCCEEDED
