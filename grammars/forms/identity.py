"""Identity: who is speaking."""

from __future__ import annotations

from grammars.alist import AList
from grammars.errors import NoMeaningError
from grammars.registry import sentence_form
from grammars.vocabulary import BORN
from kernel.memory.meaning import Identity

EXAMPLES = (
    "i am rick",
    "this is mary speaking",
    "My name is Freddy.",
    "it's me janey",
    "call me Captain",
)


@sentence_form("identity", "identity", EXAMPLES)
def identity(alist: AList) -> Identity:
    """The speaker's name, which no day or place is: "it is Monday"."""
    if "PLACE" in BORN.readings(alist.slot("speaker")):
        raise NoMeaningError(str(alist))
    return Identity(alist.slot("speaker"))
