"""Naming: the robot is given a name."""

from __future__ import annotations

from grammars.alist import AList
from grammars.registry import sentence_form
from kernel.memory.meaning import Identity

EXAMPLES = ("your name is Pixel", "from now on you are called Rusty", "I will call you Pixel")


@sentence_form("naming", "identity", EXAMPLES)
def naming(alist: AList) -> Identity:
    """What the robot is called."""
    return Identity(alist.slot("given"), robot=True)
