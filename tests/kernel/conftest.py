"""A robot for tests of the mind: the real mind, an honest body without a wire, time that passes only when told to."""

import textwrap
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from math import inf
from typing import Any

import pytest

from kernel.action.call import Bid, BodyState, MoveFailure, MoveGrip, MoveLift, Rotate, Travel
from kernel.action.chain import Chain
from kernel.action.trace import Record
from kernel.memory.change import Change
from kernel.memory.exchange import Inputs, Outputs
from kernel.memory.lesson import Content, Lesson, Operator, Resting, Rule
from kernel.memory.meaning import Command, Control, Fact, Heard, Identity, Meaning, Teach, Utterance
from kernel.memory.notation import read, read_chain
from kernel.memory.reply import AskKeep, Failed, Reply
from kernel.memory.settings import Settings
from kernel.mind import Mind
from kernel.net.graphlet import Graphlet

TICK_S = 1 / 30


def notation(text: str) -> str:
    """Notation in which ";" may stand for the end of a line."""
    return "\n".join(line.strip() for line in textwrap.dedent(text).replace(";", "\n").splitlines())


def net(text: str) -> Graphlet:
    content = read(notation(text))
    assert isinstance(content, Graphlet)
    return content


def chain(text: str) -> Chain:
    return read_chain(notation(text))


@dataclass
class Frictionless:
    """A body that does what it is bid, for as long as it is bid, and reports it: nothing more."""

    state: BodyState = field(default_factory=BodyState)
    within_reach: bool = True
    run_s: dict[int, float] = field(default_factory=dict)
    ended: dict[int, MoveFailure | None] = field(default_factory=dict)

    def act(self, bids: Sequence[Bid], dt_s: float) -> None:
        bidding = {bid.ticket for bid in bids}
        self.ended = {t: why for t, why in self.ended.items() if t in bidding}
        for bid in bids:
            if bid.ticket in self.ended:
                continue
            if not self.state.connected:
                self.ended[bid.ticket] = "link_lost"
                continue
            run = self.run_s.get(bid.ticket, 0.0) + dt_s
            self.run_s[bid.ticket] = run
            if run >= self._needs_s(bid) - 1e-9:
                self._finish(bid)
        self.state = replace(
            self.state,
            done=frozenset(t for t, why in self.ended.items() if why is None),
            failed={t: why for t, why in self.ended.items() if why is not None},
            moving=any(bid.resource == "wheels" for bid in bids),
        )

    def _needs_s(self, bid: Bid) -> float:
        match bid.command:
            case Travel(_, seconds) | Rotate(_, seconds):
                return inf if seconds is None else seconds
            case MoveLift(target, rate):
                return abs(target - self.state.lift) / rate
            case MoveGrip(target, rate):
                return abs(target - self.state.grip) / rate
        raise TypeError(bid)

    def _finish(self, bid: Bid) -> None:
        self.ended[bid.ticket] = None
        match bid.command:
            case Travel(speed, seconds):
                self.state = replace(self.state, x_m=self.state.x_m + speed * (seconds or 0))
            case Rotate(rate, seconds):
                turned = self.state.heading_rad + rate * (seconds or 0)
                self.state = replace(self.state, heading_rad=turned)
            case MoveLift(target):
                self.state = replace(self.state, lift=target)
            case MoveGrip(target, must_hold=must_hold):
                caught = must_hold and self.within_reach
                self.state = replace(self.state, grip=target, holding=caught and target < 0.5)
                if must_hold and not caught:
                    self.ended[bid.ticket] = "missed"


class Robot:
    """The mind in its body, with a store that keeps every lesson at once.

    Attributes:
        moves: (time, command) of every motion when it first won its resource.
        said: texts spoken, replies: everything the mind wanted a person to know.
        keep: False makes the store fail; store_takes_s makes it slow, s.
        journal: what is stored.
    """

    def __init__(
        self,
        lessons: Iterable[Lesson] = (),
        seed: int = 0,
        settings: Settings | None = None,
        history: Iterable[Change] = (),
        resting: Iterable[Resting] = (),
    ) -> None:
        lessons = tuple(lessons)
        self._begun_with = lessons, seed, settings
        self.mind = Mind(lessons, seed, settings, history, resting)
        self.body = Frictionless()
        self.now_s = 0.0
        self.moves: list[tuple[float, Any]] = []
        self.said: list[str] = []
        self.replies: list[Reply] = []
        self.trace: list[Record] = []
        self.keep = True
        self.store_takes_s = 0.0
        self.journal: list[Change] = []
        self.out = Outputs()
        self._storing: list[tuple[float, int, Change]] = []
        self._tickets: set[int] = set()
        self._heard: list[Heard] = []
        self._speaking: dict[int, float] = {}
        self._stored = max((lesson.ident for lesson in lessons), default=0)
        self._changes = 0
        self._epoch = 0

    # -- time ------------------------------------------------------------------------------

    def tick(self, dt_s: float = TICK_S) -> Outputs:
        self.now_s += dt_s
        spoken = {ticket for ticket, until_s in self._speaking.items() if until_s <= self.now_s}
        for ticket in spoken:
            del self._speaking[ticket]
        kept, failed = self._stored_by_now()
        self.out = self.think(
            Inputs(
                now_s=self.now_s,
                body=replace(self.body.state, at_s=self.now_s),
                heard=tuple(self._heard),
                spoken=frozenset(spoken),
                persisted=tuple(kept),
                persist_failed=tuple(failed),
                stop_epoch=self._epoch,
            )
        )
        self._heard.clear()
        for bid in self.out.bids:
            if bid.ticket not in self._tickets:
                self._tickets.add(bid.ticket)
                self.moves.append((self.now_s, bid.command))
        for bid in self.out.speech:
            self.said.append(bid.command.text)  # type: ignore[union-attr]
            self._speaking[bid.ticket] = self.now_s + 0.5
        self.replies += self.out.replies
        self.trace += self.out.trace
        self.body.act(self.out.bids, dt_s)
        return self.out

    def think(self, inputs: Inputs) -> Outputs:
        """The mind's part of a tick."""
        return self.mind.tick(inputs)

    def restart(self) -> None:
        """A new mind from what is stored; what was going on is gone, and the body rests."""
        lessons, seed, settings = self._begun_with
        self.mind = Mind(lessons, seed, settings, self.history())
        self._storing.clear()
        self._heard.clear()
        self._speaking.clear()
        self._tickets.clear()
        self.body = type(self.body)(state=replace(self.body.state, moving=False))
        self.out, self._epoch = Outputs(), 0

    def history(self) -> Iterable[Change]:
        """What is stored, oldest first."""
        return self.journal

    def _stored_by_now(self) -> tuple[list[tuple[int, Change]], list[tuple[int, str]]]:
        """The store's answers of this tick: changes kept, in the order they came, and those that could not be."""
        due_s = self.now_s + self.store_takes_s
        self._storing += [(due_s, key, change) for key, change in self.out.persist]
        kept: list[tuple[int, Change]] = []
        failed: list[tuple[int, str]] = []
        while self._storing and self._storing[0][0] <= self.now_s:
            _, key, change = self._storing.pop(0)
            if self.keep:
                kept.append((key, self.store(change)))
            else:
                failed.append((key, "disk full"))
        return kept, failed

    def store(self, change: Change) -> Change:
        """Keep a change; the same with the numbers it and its lessons have then."""
        learned = []
        for lesson in change.learned:
            self._stored += 1
            learned.append(replace(lesson, ident=self._stored))
        self._changes += 1
        stored = replace(change, ident=self._changes, learned=tuple(learned))
        self.journal.append(stored)
        return stored

    def pass_time(self, seconds: float) -> None:
        until_s = self.now_s + seconds
        while self.now_s < until_s:
            self.tick()

    def settle(self, at_most_s: float = 30.0) -> None:
        until_s = self.now_s + at_most_s
        self.tick()
        while self.out.busy or self.out.persist:
            assert self.now_s < until_s, f"still busy after {at_most_s} s"
            self.tick()

    # -- a person --------------------------------------------------------------------------

    def hear(
        self,
        meaning: Meaning,
        text: str = "",
        speaker: str = "",
        candidates: tuple[str, ...] = (),
        at_s: float = 0.0,
    ) -> None:
        """It will reach the mind in the next tick. at_s: wall time."""
        words = text or type(meaning).__name__
        said = Utterance(words, speaker, at_s, candidates=candidates)
        self._heard.append(Heard(said, meaning))

    def command(self, text: str, speaker: str = "", words: str = "") -> None:
        self.hear(Command(chain(text)), words or text, speaker)

    def do(self, text: str, speaker: str = "") -> list[Any]:
        """Command it, wait for the end; the motions it brought."""
        before = len(self.moves)
        self.command(text, speaker)
        self.settle()
        return self.moved[before:]

    def teach(self, text: str, words: str = "", kind: Any = "", speaker: str = "") -> Lesson:
        """Teach it, and keep it where the robot asks whether to."""
        content = read(notation(text))
        assert isinstance(content, Rule | Operator)
        if not kind:
            kind = "rule" if isinstance(content, Rule) else "procedure"
        before = len(self.mind.policy)
        self.hear(Teach(kind, content), words or text, speaker)
        self.settle()
        if self.replies and isinstance(self.replies[-1], AskKeep):
            self.hear(Control("keep"))
            self.settle()
        assert len(self.mind.policy) == before + 1
        return self.mind.policy[-1]

    def tell(self, fact: str, *finds: str, speaker: str = "") -> None:
        self.hear(Fact(net(fact), tuple(map(net, finds))), fact, speaker)
        self.settle()

    def i_am(self, name: str) -> None:
        self.hear(Identity(name))
        self.settle()

    def stop(self) -> None:
        """STOP went out on the wire; the mind learns of it in the next tick."""
        self._epoch += 1
        self._speaking.clear()

    def feel(self, **changes: Any) -> None:
        self.body.state = replace(self.body.state, **changes)

    # -- looking ---------------------------------------------------------------------------

    @property
    def moved(self) -> list[Any]:
        return [command for _, command in self.moves]

    @property
    def reasons(self) -> list[str]:
        """Why acts failed, as told."""
        return [reply.reason for reply in self.replies if isinstance(reply, Failed)]

    def records(self, what: str) -> list[Record]:
        return [record for record in self.trace if record.what == what]

    def believes(self, text: str, depth: int | None = None) -> bool:
        from kernel.net.match import holds

        memory = self.mind.memory
        memory.refresh()
        return holds(net(text), memory.net, memory.depth if depth is None else depth)


@pytest.fixture
def make_robot() -> type[Robot]:
    return Robot


@pytest.fixture
def robot() -> Robot:
    return Robot()


@pytest.fixture(scope="session")
def lesson() -> Callable[..., Lesson]:
    """A lesson in force from the start."""
    count = 0

    def make(text: str, **changes: Any) -> Lesson:
        nonlocal count
        count += 1
        content: Content = read(notation(text))
        kind = "rule" if isinstance(content, Rule) else "procedure"
        if isinstance(content, Graphlet):
            kind = "fact"
        return replace(Lesson(1000 + count, kind, content, words=text), **changes)  # type: ignore[arg-type]

    return make
