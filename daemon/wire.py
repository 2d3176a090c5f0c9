"""What the cycle needs of a link, real (daemon.link.service) or virtual (daemon.link.virtual)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from firmware_proto.messages import Message
from firmware_proto.told import SessionState


class Wire(Protocol):
    """What the cycle needs of a link, real or virtual."""

    @property
    def connected(self) -> bool:
        """Up and armed."""

    @property
    def state(self) -> SessionState | None:
        """Of the present attempt; None between attempts."""

    @property
    def detail(self) -> str:
        """Its state in words."""

    @property
    def stop_epoch(self) -> int:
        """Count of stops."""

    def stop(self) -> int:
        """STOP at once, past every queue; the new epoch."""

    def received(self) -> list[Message]:
        """Messages since the last call."""

    def send(self, messages: Iterable[Message], epoch: int) -> None:
        """Queue messages computed under that epoch; older ones are refused."""

    def beat(self) -> None:
        """Renew the lease when due."""
