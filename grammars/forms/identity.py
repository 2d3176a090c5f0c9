"""Identity: who is speaking."""

from __future__ import annotations

from grammars.alist import AList
from grammars.registry import sentence_form
from kernel.memory.meaning import Identity

EXAMPLES = ("i am rick", "this is mary speaking", "My name is Freddy.", "it's me janey")


@sentence_form("identity", "identity", EXAMPLES)
def identity(alist: AList) -> Identity:
    """The speaker's name."""
    return Identity(alist.slot("speaker"))
