"""No, a doubtful lesson is not to be kept: understood only while the robot asks that."""

from __future__ import annotations

from grammars.alist import AList
from grammars.registry import sentence_form
from kernel.memory.meaning import Control

EXAMPLES = ("no", "no thanks")


@sentence_form("refusal", "control", EXAMPLES, expected=True)
def refusal(alist: AList) -> Control:
    """As "never mind" is."""
    return Control("cancel")
