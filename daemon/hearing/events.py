"""What the ear reports. Every time is audio time: seconds since the first sample heard."""

from __future__ import annotations

from typing import Literal, Self

import msgspec

Reason = Literal["noise", "unfinished", "outside", "unsure", "too_long", "fragment", "lost"]


class _Spoken(msgspec.Struct, frozen=True):
    """What concerns a whole utterance.

    Attributes:
        began_s: when the speech began.
        ended_s: when the speech ended.
        decided_s: when the wait after it was over.
    """

    began_s: float
    ended_s: float
    decided_s: float

    def shifted(self, by_s: float) -> Self:
        """The same on another clock."""
        return msgspec.structs.replace(
            self,
            began_s=self.began_s + by_s,
            ended_s=self.ended_s + by_s,
            decided_s=self.decided_s + by_s,
        )


class StopWord(msgspec.Struct, frozen=True, tag=True):
    """A stop word stands alone in what is being said. It comes before the utterance has ended."""

    at_s: float
    word: str

    def shifted(self, by_s: float) -> Self:
        """The same on another clock."""
        return msgspec.structs.replace(self, at_s=self.at_s + by_s)


class Partial(msgspec.Struct, frozen=True, tag=True):
    """What it sounds like so far. Nothing may act on it."""

    at_s: float
    text: str

    def shifted(self, by_s: float) -> Self:
        """The same on another clock."""
        return msgspec.structs.replace(self, at_s=self.at_s + by_s)


class Ended(_Spoken, frozen=True, tag=True):
    """The recogniser's own verdict on an utterance, before the parser has chosen.

    Attributes:
        alternatives: (text, confidence 0 to 1), best first; empty if there were no words in it.
        cut: whether it was ended because it was too long.
    """

    alternatives: tuple[tuple[str, float], ...]
    cut: bool = False


class Heard(_Spoken, frozen=True, tag=True):
    """A sentence of the language, trusted.

    Attributes:
        text: the words.
        confidence: 0 to 1.
        alternatives: other hypotheses that parse, best first.
    """

    text: str
    confidence: float
    alternatives: tuple[str, ...] = ()


class NotHeard(_Spoken, frozen=True, tag=True):
    """Something was said that must not act.

    Attributes:
        reason: noise: no words in it. unfinished: it broke off. outside: no hypothesis is a sentence of the language,
            or it sounds like other speech. unsure: between the thresholds: ask to say it again. too_long: it never
            ended. fragment: it goes on from a lesson that was already taken. lost: the recogniser died; ask again.
        text: the best hypothesis, for the log; never for the parser.
    """

    reason: Reason
    text: str = ""


HearingEvent = StopWord | Partial | Heard | NotHeard
CoreEvent = StopWord | Partial | Ended | NotHeard
