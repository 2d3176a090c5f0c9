"""Turning the sentences of this folder into born.net: scripts/compile_knowledge.py writes what `compiled` returns."""

from __future__ import annotations

from collections.abc import Iterator
from importlib.resources import files

from grammars.parse import parse
from kernel.memory.meaning import Fact, Teach
from kernel.memory.notation import write


class NoLessonError(ValueError):
    """A sentence of the folder teaches nothing, or nothing that can be kept."""

    def __init__(self, sentence: str, kind: str) -> None:
        super().__init__(f"{sentence!r} is a {kind}, not a lesson")
        self.sentence, self.kind = sentence, kind


def sentences() -> Iterator[str]:
    """The sentences of every *.txt here, files in order of their names; "#" starts a comment."""
    for file in sorted(files(__package__).iterdir(), key=lambda file: file.name):
        if file.name.endswith(".txt"):
            for line in file.read_text("utf8").splitlines():
                if sentence := line.partition("#")[0].strip():
                    yield sentence


def compiled() -> str:
    """The text of born.net.

    Raises:
        NoLessonError: a sentence is no lesson.
        NotUnderstoodError: a sentence has no reading.
    """
    return "\n".join(_block(sentence) for sentence in sentences())


def _block(sentence: str) -> str:
    parsed = parse(sentence)
    match parsed.meaning:
        case Teach(kind, content, ()):
            return f"# {kind}: {sentence}\n{write(content)}\n"
        case Fact(fact, ()):
            return f"# fact: {sentence}\n{write(fact)}\n"
    raise NoLessonError(sentence, parsed.kind)
