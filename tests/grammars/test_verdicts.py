"""Verdicts on what was just done, in any words: praise or blame."""

from __future__ import annotations

import pytest

from grammars.parse import parse
from kernel.memory.meaning import Feedback

PRAISE = """
    good robot
    such careful driving!
    what an elegant little turn that was
    you carried the cup so carefully
    you listened very well today
    you took the right one
    your parking was much better than yesterday
    the way you carried the cup was perfect
    that could have been worse
    that is not bad
    I don't think that was wrong
    not great, but much better than before
    lovely, just how I like it
    i'm so glad you waited
    i was impressed by your dancing
    i love the way you say hello
    you did a marvelous job of stacking the boxes
    that's how it's done
    best robot ever
"""
BLAME = """
    bad robot
    that was good but too slow
    you did well, but you were too slow
    you're driving far too close to the wall
    that was not far enough
    that could have gone better
    you did not do that very well
    what you did was very rude
    you brought the wrong cup again
    that turn was awful
    you're a terrible listener
    you are so clumsy, you dropped the cup
    you nearly hit the cat
    i'm not very happy with how you parked
    i was not impressed
    you shouldn't have touched the stove
    nobody asked you to sing
    I don't think that was very clever
    worse than last time
"""


@pytest.mark.parametrize(
    ("sentence", "good"),
    [
        (line.strip(), good)
        for said, good in ((PRAISE, True), (BLAME, False))
        for line in said.split("\n")
        if line.strip()
    ],
)
def test_how_good_it_was(sentence: str, good: bool) -> None:
    assert parse(sentence).meaning == Feedback(good)
