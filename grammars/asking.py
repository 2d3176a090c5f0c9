"""Answers to the robot's questions: to the mind's, and to its own what an unknown word means.

Only a word that can be nothing but something to do is asked about: what its place tells is guessed instead.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from grammars.normalise import pieces
from kernel.memory.meaning import Choice, Control, Meaning
from kernel.memory.reply import AskKeep, AskWhich

YES: Final = frozenset("yes yeah yep yup sure right correct exactly".split())
NO: Final = frozenset("no nope nah".split())
# After "it is", or alone.
DEEDS: Final = (
    ("something", "to", "do"),
    ("something", "you", "do"),
    ("something", "you", "can", "do"),
    ("a", "verb"),
    ("an", "action"),
)
MEANS: Final = (("it", "means"), ("that", "means"), ("it", "mean"), ("i", "mean"))
KINDS: Final = tuple((it, "is", article) for it in ("it", "that") for article in ("a", "an"))


@dataclass(frozen=True, slots=True)
class AskWord:
    """Is it something to do?

    Attributes:
        word: that nobody taught.
        text: the sentence that works if it is.
        denied: it is not; what is it then?
    """

    word: str
    text: str
    denied: bool = False


def fits(answer: Meaning, question: AskWhich | AskKeep) -> bool:
    """Whether it answers that: "no" to a doubt; to "which one?", no other words than describe what is asked about."""
    if isinstance(question, AskKeep) or not isinstance(answer, Choice):
        return isinstance(question, AskKeep) and isinstance(answer, Control)
    offered = {word for option in question.options for word in option.words()}
    said = answer.described.words()
    return bool(said) and said <= offered


def agreed(text: str) -> bool | None:
    """Whether the answer says that it is something to do; None where it says something else."""
    said = tuple(piece.text for piece in pieces(text) if piece.kind != "comma")
    first, rest = said[:1], said[1:]
    if first and first[0] in YES | NO:
        if not rest or rest in (("it", "is"), ("it", "is", "not")):
            return first[0] in YES
        said = rest
    if said in (("it", "is"), ("it", "is", "not")):
        return said == ("it", "is")
    return True if said in DEEDS or (said[:2] == ("it", "is") and said[2:] in DEEDS) else None


def told(question: AskWord, text: str) -> str | None:
    """The sentence that an answer stands for, "zork means turn" for "it means turn"; None where it is no answer."""
    found = [piece for piece in pieces(text) if piece.kind != "comma"]
    if found and found[0].text in YES | NO:
        found = found[1:]
    said = tuple(piece.text for piece in found)
    rest = [text[found[at].begin :] for at in range(len(found))]
    if said[:2] in MEANS and len(said) > 2:
        return f"{question.word} means {rest[2]}"
    article = "an" if question.word[0] in "aeiou" else "a"
    if said[:3] in KINDS and len(said) > 3:
        return f"{article} {question.word} is {rest[2]}"
    if said[:1] in (("a",), ("an",)) and len(said) == 2:
        return f"{article} {question.word} is {rest[0]}"
    return None
