"""How long to wait after the last sound before an utterance has ended.

A pause must not turn a lesson into a command: "to cha-cha (pause) drive forward", cut at the pause, would drive. So the
wait depends on what has been heard: short after a whole sentence, long after half a one, and long after a lesson that
could go on.
"""

from __future__ import annotations

import re

from grammars.language import Language

SHORT_WAIT_S = 0.3
LONG_WAIT_S = 1.5
JOIN_S = 2.0
"""What is said within this time after an unfinished utterance goes on from it, and is never heard alone."""
SETTLED_S = 1.0
"""In noise the level never falls: a sentence that has not changed for so long has ended (twice that if open)."""
LONGEST_S = 20.0

_OPEN_FRAME = re.compile(
    r"(?:(?:hey |okay |ok )?robot |okay |please )?"
    r"(?:to |if |when |whenever |while |before |after |unless |until |for each |never |always |don't |do not |"
    r"(?:you|we) (?:should|must|may|can|could|might|are|shouldn't|mustn't|can't)|"
    r"let me teach|here is|here's|only |another way|it is okay|it's okay|[a-z'-]+ing means |"
    r"(?:every|each|any) time |anytime |as soon as |as long as |once |the moment |should |in case |prior to |"
    r"under no circumstances |at no time |i forbid |it is forbidden |it's forbidden |avoid |refrain )"
)
"""Beginnings of lessons: their first part is, or contains, what would be a command by itself."""

_CONTINUATION = re.compile(r"(?:and |then |and then |but |unless |until |while |instead )")


def is_open(text: str) -> bool:
    """Whether the text begins as a lesson does, and so may go on after a pause though it is a whole sentence."""
    return _OPEN_FRAME.match(f"{text} ") is not None


def is_continuation(text: str) -> bool:
    """Whether the text begins as only the rest of a sentence does."""
    return _CONTINUATION.match(f"{text} ") is not None


def is_unfinished(text: str, whole: bool, language: Language) -> bool:
    """Whether the text is the beginning of a sentence that is listened for; not if it is a whole sentence."""
    return not whole and bool(text) and bool(language.listed.after(text.split()))


def wait_s(text: str, whole: bool) -> float:
    """How long silence must last for the utterance to have ended, given what has been heard of it, and whether that is
    a whole sentence."""
    return SHORT_WAIT_S if whole and not is_open(text) else LONG_WAIT_S
