"""Where sentence forms register themselves: one pair of files in `grammars/forms` each, discovered by file.

A form is `x.lark`, whose rule `x` is one kind of sentence, and `x.py`, whose builder turns the association list of
that rule into a meaning and whose EXAMPLES say what it is for.
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

from grammars.alist import AList
from kernel.memory.meaning import Meaning

Builder = Callable[[AList], Meaning]


@dataclass(frozen=True, slots=True)
class Form:
    """One kind of sentence.

    Attributes:
        name: of the rule in the grammar and of both files.
        build: association list of the rule to meaning.
        kind: of the sentences (language.md, Kinds).
        examples: sentences of this form; each is a test.
        expected: it is understood only as the answer to a question of the robot's.
    """

    name: str
    build: Builder
    kind: str
    examples: tuple[str, ...]
    expected: bool = False


FORMS: dict[str, Form] = {}


def sentence_form(
    name: str, kind: str, examples: tuple[str, ...], expected: bool = False
) -> Callable[[Builder], Builder]:
    """Register the decorated builder as the form of that name."""

    def register(build: Builder) -> Builder:
        FORMS[name] = Form(name, build, kind, examples, expected)
        return build

    return register


@cache
def discover() -> dict[str, Form]:
    """Import every form and return them by name, sorted."""
    package = importlib.import_module("grammars.forms")
    for module in pkgutil.iter_modules(package.__path__):
        importlib.import_module(f"grammars.forms.{module.name}")
    return dict(sorted(FORMS.items()))
