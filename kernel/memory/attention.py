"""The attention buffer: what the mind is busy with, newest first.

Source: Connell 2019, section 3; sizes and times are mind.md's.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Final

from kernel.action.chain import Chain
from kernel.action.step import Run
from kernel.action.verdict import Verdict
from kernel.memory.change import Change
from kernel.memory.inference import Inference
from kernel.memory.lesson import Lesson
from kernel.memory.meaning import Heard, Meaning
from kernel.memory.recent import Saying
from kernel.memory.reply import Reason, Reply
from kernel.net.graphlet import Graphlet
from kernel.net.match import Binding
from kernel.net.node import Node

ROOM: Final = 32  # foci, handled ones included
FADE_S: Final = 30.0


@dataclass(slots=True)
class Failure:
    """Why a focus came to nothing: the first cause that was found.

    Attributes:
        by: the prohibition; because: the conclusions it rests on; steps: how these were reached.
        about: what the reason is about, where that is no act.
        said_before: how often the focus had spoken by then; if it has spoken since, that was the explanation.
    """

    reason: Reason
    act: Node | None = None
    detail: str = ""
    by: Lesson | None = None
    because: tuple[Graphlet, ...] = ()
    said_before: int = -1
    about: tuple[Graphlet, ...] = ()
    steps: tuple[Inference, ...] = ()


@dataclass(frozen=True, slots=True)
class Progress:
    """How far a command has come.

    Attributes:
        words: the utterance it came from.
        chain: the whole command.
        at: index of the play that runs now.
        binding: what its look-ups have found so far.
    """

    words: str
    chain: Chain
    at: int
    binding: Binding


@dataclass(slots=True, eq=False)
class Focus:
    """One thing in attention.

    Attributes:
        number: running number; the greater, the newer and the more urgent.
        heard: the utterance it came from, None for the robot's own noticing.
        run: its chain, while active.
        nodes: nodes made on its behalf.
        speech_act: the node NOTE[tell] is about.
        ended_s: when it was handled, None while active.
        failure: why it failed, or is failing.
        reaction: the NOTE operator it followed first; lesson: what it is to learn; beside: what else with it.
        said: how often it has spoken.
        excuse: the reply that explains a failure; this focus notes that failure.
        progress: how far its command has come, None for what is no command.
        by: who spoke, "" if not identified; change: what it is to change.
        saying: the fact that it is to learn; told: the nodes that carry it.
        dismissed: it is to be ended, by another utterance.
        preempted: when which lesson's reaction took a resource from it, s.
        waits: what its chains wait for: the grounding functions, the store, a condition, an answer; set by whatever
            yields, so that nothing waits for nothing.
        own: it notes an act of the robot's own.
    """

    number: int
    heard: Heard | None = None
    run: Run | None = None
    nodes: dict[Node, None] = field(default_factory=dict)
    speech_act: Node | None = None
    ended_s: float | None = None
    verdict: Verdict | None = None
    failure: Failure | None = None
    reaction: Lesson | None = None
    lesson: Lesson | None = None
    beside: tuple[Lesson, ...] = ()
    said: int = 0
    excuse: Reply | None = None
    progress: Progress | None = None
    by: str = ""
    change: Change | None = None
    saying: Saying | None = None
    told: tuple[Node, ...] = ()
    dismissed: bool = False
    preempted: list[tuple[float, int]] = field(default_factory=list)
    waits: set[str] = field(default_factory=set)
    own: bool = False

    @property
    def words(self) -> str:
        """The utterance it descends from, "" for none."""
        return self.heard.utterance.text if self.heard else ""

    @property
    def meaning(self) -> Meaning | None:
        """What that utterance means."""
        return self.heard.meaning if self.heard else None

    @property
    def at_s(self) -> float:
        """When it was said, wall time, s since 1970; 0 for none."""
        return self.heard.utterance.at_s if self.heard else 0.0

    def changing(self) -> Change:
        """A change on behalf of who spoke, with nothing in it yet."""
        return Change(by=self.by, words=self.words, at_s=self.at_s)


class Attention:
    """Foci, active ones and those that fade."""

    def __init__(self, fade_s: float = FADE_S) -> None:
        self._foci: list[Focus] = []
        self._fade_s = fade_s
        self._count = 0

    def __iter__(self) -> Iterator[Focus]:
        """Newest first."""
        return reversed(self._foci)

    def active(self) -> list[Focus]:
        """Foci not handled yet, newest first."""
        return [focus for focus in self if focus.ended_s is None]

    @property
    def crowded(self) -> bool:
        """Whether something has to leave before something new is posted."""
        return len(self._foci) >= ROOM

    def newest(self, node: Node) -> int:
        """Number of the newest focus that mentions the node, 0 where none does any more."""
        return next((focus.number for focus in self if node in focus.nodes), 0)

    def post(self, heard: Heard | None = None) -> Focus:
        """Put something new before the mind."""
        self._count += 1
        focus = Focus(self._count, heard)
        self._foci.append(focus)
        return focus

    def fade(self, now_s: float) -> list[Focus]:
        """Take out and return what was handled long enough ago."""
        faded = [
            f for f in self._foci if f.ended_s is not None and now_s - f.ended_s >= self._fade_s
        ]
        if faded:
            self._foci = [f for f in self._foci if f not in faded]
        return faded

    def evict(self) -> Focus | None:
        """Take out the oldest handled focus, to make room."""
        for focus in self._foci:
            if focus.ended_s is not None:
                self._foci.remove(focus)
                return focus
        return None
