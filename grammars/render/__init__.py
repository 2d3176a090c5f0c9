"""Nets into English, in two voices: read-back, export and everything the robot says about what it was told.

`render(meaning_or_content, voice)` works from the net alone. "teacher" is canonical text: parsed again it gives an
equal net. "robot" speaks for itself, you and I exchanged, and is not parsed.
"""

from grammars.render.english import (
    act_in_words,
    claim_in_words,
    definite,
    gist,
    render,
    thing_in_words,
)
from grammars.render.telling import Voice

__all__ = [
    "Voice",
    "act_in_words",
    "claim_in_words",
    "definite",
    "gist",
    "render",
    "thing_in_words",
]
