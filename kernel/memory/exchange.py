"""What goes into the mind each tick and what comes out."""

from __future__ import annotations

from dataclasses import dataclass, field

from kernel.action.call import Bid, BodyState
from kernel.action.trace import Record
from kernel.memory.change import Change
from kernel.memory.meaning import Heard
from kernel.memory.policy import Shift
from kernel.memory.reply import Reply


@dataclass(frozen=True, slots=True)
class Inputs:
    """Attributes:
    now_s: monotonic time, s.
    body: the body's own report.
    heard: utterances with their meanings, oldest first.
    spoken: voice tickets whose speech has ended.
    persisted: (key, change): changes now durable, with their numbers and those of their lessons from the store.
    persist_failed: (key, why): changes that could not be kept.
    stop_epoch: the link's count of stops; greater than the mind's own means: halt everything.
    """

    now_s: float
    body: BodyState = field(default_factory=BodyState)
    heard: tuple[Heard, ...] = ()
    spoken: frozenset[int] = frozenset()
    persisted: tuple[tuple[int, Change], ...] = ()
    persist_failed: tuple[tuple[int, str], ...] = ()
    stop_epoch: int = 0


@dataclass(frozen=True, slots=True)
class Outputs:
    """Attributes:
    bids: the winners for the body, all of them, every tick: a resource without one comes to rest.
    speech: bids for the voice, each once, when it starts; end them with Inputs.spoken.
    replies: to be put into English, shown and spoken.
    persist: (key, change): changes of the policy to store; answer with Inputs.persisted or persist_failed under the
        same key.
    shift: what came into force in this tick and what went.
    trace: what was decided in this tick.
    stop_epoch: the epoch in which bids were computed.
    busy: some focus is active, and waits for more than a person's answer, which may never come.
    """

    bids: tuple[Bid, ...] = ()
    speech: tuple[Bid, ...] = ()
    replies: tuple[Reply, ...] = ()
    persist: tuple[tuple[int, Change], ...] = ()
    shift: Shift = field(default_factory=Shift)
    trace: tuple[Record, ...] = ()
    stop_epoch: int = 0
    busy: bool = False
