"""What is done with the recogniser's verdict: the best alternative that parses and is trusted, or none."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from daemon.hearing.events import Ended, Heard, NotHeard, Reason

MOST_PARSED = 8
"""Alternatives that are offered to the parser; it takes some 10 ms for each."""

Parses = Callable[[str], bool]


@dataclass(frozen=True, slots=True)
class Thresholds:
    """Confidence below which an utterance is other speech, and below which it is asked for again."""

    outside: float
    unsure: float


def choose(ended: Ended, parses: Parses, thresholds: Thresholds) -> Heard | NotHeard:
    """Choose what was said.

    Args:
        ended: the recogniser's verdict.
        parses: whether a text is a sentence; the parser alone decides what may act.
        thresholds: of the engine that heard it.
    """

    times = (ended.began_s, ended.ended_s, ended.decided_s)

    def refused(reason: Reason, text: str = "") -> NotHeard:
        return NotHeard(*times, reason, text)

    best = ended.alternatives[0][0] if ended.alternatives else ""
    if ended.cut:
        return refused("too_long", best)
    if not ended.alternatives:
        return refused("noise")
    sentences = [found for found in ended.alternatives[:MOST_PARSED] if parses(found[0])]
    if not sentences or sentences[0][1] < thresholds.outside:
        return refused("outside", best)
    text, confidence = sentences[0]
    if confidence < thresholds.unsure:
        return refused("unsure", text)
    others = tuple(other for other, _ in sentences[1:])
    return Heard(*times, text, confidence, others)
