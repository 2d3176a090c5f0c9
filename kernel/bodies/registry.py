"""What a body is to the mind, and which ones there are: one folder under kernel/bodies each."""

from __future__ import annotations

import importlib
import pkgutil
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Sequence
from typing import TypeVar

import kernel.bodies
from firmware_proto.messages import Message
from kernel.action.call import Bid, BodyState
from kernel.errors import KernelError


class UnknownBodyError(KernelError):
    """No body has this name."""

    def __init__(self, name: str, known: tuple[str, ...]) -> None:
        super().__init__(f"{name!r}: known bodies are {', '.join(known)}")
        self.name, self.known = name, known


class Body(ABC):
    """Turns winning bids into messages, and messages into what the mind knows of the body. No clock, no port."""

    @abstractmethod
    def sense(self, messages: Iterable[Message], now_s: float, connected: bool) -> BodyState:
        """The state after these messages. done and failed name each ended ticket until its bid is gone."""

    @abstractmethod
    def act(self, bids: Sequence[Bid], now_s: float) -> list[Message]:
        """The commands that make the body do this tick's winners ask; what nobody bids for comes to rest."""

    @abstractmethod
    def halt(self) -> None:
        """The robot has been stopped past the mind: every live ticket has failed, nothing is left to continue."""


_BODIES: dict[str, type[Body]] = {}

B = TypeVar("B", bound=type[Body])


def body(name: str) -> Callable[[B], B]:
    """Register a class under the name that robot addresses use (sim://name)."""

    def register(cls: B) -> B:
        _BODIES[name] = cls
        return cls

    return register


def names() -> tuple[str, ...]:
    """Every body there is."""
    for folder in pkgutil.iter_modules(kernel.bodies.__path__):
        if folder.ispkg:
            importlib.import_module(f"kernel.bodies.{folder.name}.body")
    return tuple(sorted(_BODIES))


def make(name: str) -> Body:
    """A fresh body.

    Raises:
        UnknownBodyError: there is none of this name.
    """
    known = names()
    if name not in known:
        raise UnknownBodyError(name, known)
    return _BODIES[name]()
