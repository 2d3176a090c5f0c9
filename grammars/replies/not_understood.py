"""A sentence without a reading: the unknown word, or what would have worked; if nothing near it would, what does."""

from __future__ import annotations

from typing import Final

from grammars.errors import NotUnderstoodError
from grammars.nearest import typical_sentence
from grammars.replies import Said, aloud, listed, renders, sentence

_LONGEST_LIST = 3
ORDER: Final = "drive forward"
LESSON: Final = "to dance, turn left then turn right"


@renders(NotUnderstoodError)
def not_understood(error: NotUnderstoodError) -> Said:
    """ "I don't know the word zork." """
    unknown = error.unknown_words
    if (asking := error.asking) is not None:
        if asking.denied:
            said = f"Then what does {asking.word} mean?"
        else:
            said = f"I don't know the word {asking.word}. Is it something to do?"
        return Said(said, said)
    if 0 < len(unknown) <= _LONGEST_LIST:
        said = f"I don't know the word{'s' if len(unknown) > 1 else ''} {listed(unknown)}"
    else:
        said = "I did not understand"
    shown = sentence(said)
    if error.understood:
        shown += f' I understood as far as "{error.understood}".'
    if nearest := (error.nearest or "").rstrip(" .!?"):
        shown += f' Did you mean "{nearest}"?'
        return Said(shown, f"{aloud(said)} Did you mean: {nearest}?")
    return Said(f"{shown} {_offer(error.text)}", aloud(said))


def _offer(text: str) -> str:
    """What would be understood: a sentence that begins alike, else an order and a lesson."""
    if (typical := typical_sentence(text)) is not None:
        return f'Sentences like "{typical.rstrip(" .!?")}" I understand.'
    return f'I take orders, as "{ORDER}", and lessons, as "{LESSON}".'
