"""Finds a stop word in what is being said, before it has been said to the end."""

from __future__ import annotations

STOP_WORDS = frozenset({"stop", "halt", "freeze"})
STEADY = 30
"""So many hypotheses in a row (0.6 s) must be just the stop word, or one when the voice has paused: the first syllable
of another word comes and goes ("stock prices" looks like "stop" for half a second where few words are known). In noise
no pause may show."""


class StopSpotter:
    """Takes the hypotheses of one utterance in order.

    Only a hypothesis that is exactly a stop word counts, the robot's name before or after it: "any that contains one"
    was wrong 26 times of 152.
    """

    def __init__(self, robot_name: str = "robot") -> None:
        # "robot stop" is often heard as "robots stop": the s is shared
        self._names = {robot_name.lower(), f"{robot_name.lower()}s"}
        self._steady = 0
        self._done = False

    def reset(self) -> None:
        """Another utterance begins."""
        self._steady, self._done = 0, False

    def heard(self, partial: str, quiet: bool) -> str:
        """Take the next hypothesis and whether the voice has paused; the stop word, once an utterance, else ""."""
        words = [word for word in partial.split() if word not in self._names]
        if len(words) != 1 or words[0] not in STOP_WORDS or len(partial.split()) > 2:
            self._steady = 0
            return ""
        self._steady += 1
        if self._done or not (quiet or self._steady >= STEADY):
            return ""
        self._done = True
        return words[0]
