"""Which of an engine's hypotheses are sentences, and how far each is to be trusted: alike for every engine that weighs
which words follow which."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Final

from daemon.hearing.recogniser import Alternative

JUDGED: Final = 8
"""Alternatives, the best first, of which the parser says whether they are sentences: some 5 ms for each."""

Test = Callable[[str], bool]


@dataclass(frozen=True, slots=True)
class Judge:
    """What an engine's scores are worth, in its own unit.

    Attributes:
        listed: by how much a sentence that is listened for is taken to be likelier than any other.
        middle: margin over the best hypothesis that is no sentence at which confidence is one half.
        spread: the change of it that makes confidence 0.73.
    """

    listed: float
    middle: float
    spread: float

    def trusted(
        self, scored: list[tuple[str, float]], lists: Test, reads: Test
    ) -> Iterator[Alternative]:
        """The sentences among the best, by score; if there are none the best of all, with no confidence.

        Args:
            scored: hypotheses with their scores, a higher one better.
            lists: whether a sentence is listened for.
            reads: whether a text is any sentence at all.
        """
        listed = {text for text, _ in scored if lists(text)}
        weighed = [(score + self.listed * (text in listed), text) for text, score in scored]
        best_other, sentences = -math.inf, list[tuple[float, str]]()
        for score, text in sorted(weighed, reverse=True)[:JUDGED]:
            if text and (text in listed or reads(text)):
                sentences.append((score, text))
            else:
                best_other = max(best_other, score)
        for score, text in sentences:
            margin = (score - best_other - self.middle) / self.spread
            yield Alternative(text, 1.0 / (1.0 + math.exp(-min(max(margin, -30.0), 30.0))))
        if not sentences and weighed:
            yield Alternative(max(weighed)[1], 0.0)
