"""What the robot answers, in English: one file per kind of reply, each registering its renderer.

`say(reply)` finds the renderer by the reply's type; files are discovered, nobody keeps a list.
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, TypeVar

from grammars.errors import NotUnderstoodError
from kernel.memory.reply import Reply

R = TypeVar("R")


@dataclass(frozen=True, slots=True)
class Said:
    """A reply in words.

    Attributes:
        shown: for the screen, in full.
        spoken: for the voice, one short sentence or two.
    """

    shown: str
    spoken: str


RENDERERS: dict[type[Any], Callable[[Any], Said]] = {}


def renders(kind: type[R]) -> Callable[[Callable[[R], Said]], Callable[[R], Said]]:
    """Register the decorated function as the renderer of that type of reply."""

    def register(renderer: Callable[[R], Said]) -> Callable[[R], Said]:
        RENDERERS[kind] = renderer
        return renderer

    return register


@cache
def discover() -> dict[type[Any], Callable[[Any], Said]]:
    """Import every file here and return the renderers by type of reply."""
    for module in pkgutil.iter_modules(__path__):
        importlib.import_module(f"{__name__}.{module.name}")
    return RENDERERS


def say(reply: Reply | NotUnderstoodError) -> Said:
    """The reply in English."""
    return discover()[type(reply)](reply)


def sentence(text: str) -> str:
    """With a capital at its head and a full stop at its end."""
    ending = "" if text.endswith((".", "?", "!")) else "."
    return text[:1].upper() + text[1:] + ending


def aloud(text: str) -> str:
    """As `sentence`, without quotation marks: the voice cannot show them."""
    return sentence(text.replace('"', ""))


def both(text: str) -> Said:
    """The same sentence shown and spoken."""
    return Said(sentence(text), aloud(text))


def listed(parts: Sequence[str], word: str = "and") -> str:
    """ "A, B and C"."""
    return f" {word} ".join(filter(None, (", ".join(parts[:-1]), *parts[-1:])))
