"""The mind: one cycle of noticing, thinking and bidding.

Time, chance and the body come in as arguments; the same inputs give the same outputs, always.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable
from typing import Final

from kernel.action.arbiter import PATIENCE_S, arbitrate
from kernel.action.call import GROUNDINGS, Bid, Halt
from kernel.action.chain import Directive, sequence
from kernel.action.discover import load_all
from kernel.action.sensing import SENSES
from kernel.action.step import Run
from kernel.action.verdict import Verdict
from kernel.attending import attend, notice
from kernel.commons import Commons
from kernel.memory.attention import ROOM, Attention, Failure, Focus
from kernel.memory.exchange import Inputs, Outputs
from kernel.memory.lesson import Lesson, Operator
from kernel.memory.meaning import Heard
from kernel.memory.operators import Operators
from kernel.memory.reply import Failed, Halted, Refused
from kernel.memory.settings import Settings
from kernel.memory.working import WorkingMemory
from kernel.net.graphlet import Sketch
from kernel.net.node import Node, describe

PARTS: Final = ("gripper", "lift", "fork", "wheel", "battery", "finger", "arm")
INNATE: Final = -1_000_000  # lessons from here down are the innate ones
TAKEOVERS: Final = 3  # the same reaction may pre-empt the same focus so often in TAKEOVER_S
TAKEOVER_S: Final = 10.0


class Mind:
    """All that deliberates.

    Args:
        lessons: what is in force at the start, born knowledge included.
        seed: of the chances it takes.
        settings: numbers of mind.md.
    """

    def __init__(
        self, lessons: Iterable[Lesson] = (), seed: int = 0, settings: Settings | None = None
    ) -> None:
        for package in ("kernel.directives", "kernel.grounding"):
            load_all(package)
        settings = settings or Settings()
        self._attention = Attention(settings.fade_s)
        memory = WorkingMemory(self._in_attention, PARTS)
        self._commons = Commons(memory, Operators(), random.Random(seed), settings)
        self._senses = [make() for _, make in sorted(SENSES.items())]
        self._waiting_since: dict[int, float] = {}
        self.epoch = 0
        self.speaker = ""
        for lesson in (*innate(), *lessons):
            self._commons.enforce(lesson)

    @property
    def policy(self) -> tuple[Lesson, ...]:
        """Lessons in force that were taught, born as sentences, or made by the robot itself."""
        return tuple(x for x in self._commons.lessons.values() if x.ident > INNATE)

    @property
    def memory(self) -> WorkingMemory:
        """For looking, not for touching."""
        return self._commons.memory

    def _in_attention(self) -> list[Node]:
        return [node for focus in self._attention for node in focus.nodes]

    def tick(self, inputs: Inputs) -> Outputs:
        """One cycle."""
        commons, now_s = self._commons, inputs.now_s
        commons.tick.now_s, commons.tick.body = now_s, inputs.body
        commons.tick.spoken = inputs.spoken
        for key, ident in inputs.persisted:
            commons.kept(key, ident)
        for key, why in inputs.persist_failed:
            commons.not_kept(key, why)
        stopping = inputs.stop_epoch > self.epoch
        if stopping:
            self._halt(inputs.stop_epoch)
        self._sense(inputs)
        for heard in inputs.heard:
            self._hear(heard)
        self._think()
        for gone in commons.memory.take_lost():
            commons.record("fact", None, text=" ".join(sorted(gone.words())), lost=True)
        winners = self._arbitrate(now_s)
        self._fade(now_s)
        outputs = Outputs(
            bids=() if stopping else winners,
            speech=tuple(commons.speech),
            replies=tuple(commons.replies),
            persist=tuple(commons.persist),
            trace=tuple(commons.trace),
            stop_epoch=self.epoch,
            busy=bool(self._attention.active()),
        )
        for produced in (commons.speech, commons.replies, commons.persist, commons.trace):
            produced.clear()
        return outputs

    # -- what comes in ---------------------------------------------------------------------

    def _halt(self, epoch: int) -> None:
        """Stop everything, then enter the new epoch: only then may anything move again."""
        active = self._attention.active()
        for focus in active:
            self._close(focus, Verdict.STOPPED)
        self.epoch = epoch
        self._commons.struck.clear()
        self._commons.speech.clear()
        self._waiting_since.clear()
        self._commons.record("stopped", None, epoch=epoch, foci=len(active))
        self._commons.replies.append(Halted(bool(active)))

    def _sense(self, inputs: Inputs) -> None:
        memory = self._commons.memory
        noticed: list[Node] = []
        fleeting = []
        for sense in self._senses:
            for edge in sense.update(inputs.body):
                self._commons.record("sensed", None, key=edge.key, holds=edge.fact is not None)
                if edge.fact is None:
                    memory.unsense(edge.key)
                elif edge.fleeting:
                    fleeting.append(edge.fact)
                else:
                    noticed += memory.sense(edge.key, edge.fact)
        if noticed:
            self._begin(notice, None, tuple(noticed), None)
        for fact in fleeting:
            self._begin(notice, None, (), fact)

    def _hear(self, heard: Heard) -> None:
        if len(self._attention.active()) >= ROOM:
            self._commons.replies.append(Failed(None, "no_room"))
            self._commons.record(
                "error", None, text="attention is full", words=heard.utterance.text
            )
            return
        self._begin(attend, heard)

    def _begin(self, how: Callable[..., Run], heard: Heard | None, *args: object) -> None:
        if self._attention.crowded and (gone := self._attention.evict()) is not None:
            self._commons.memory.forget(gone.nodes)
        focus = self._attention.post(heard)
        focus.run = how(self, self._commons, focus, *args)
        self._commons.record("focus", focus, text=focus.words or "noticed")

    # -- thinking --------------------------------------------------------------------------

    def _think(self) -> None:
        """Resume every focus once; newest first, so that what they say about each other is in order."""
        self._commons.claims.clear()
        for focus in self._attention.active():
            if focus.run is None:
                continue
            try:
                next(focus.run)
            except StopIteration as end:
                self._close(focus, end.value)
            except RecursionError:
                focus.failure = Failure("recursion")
                self._close(focus, Verdict.FAILED)

    def _close(self, focus: Focus, verdict: Verdict) -> None:
        if focus.run is not None:
            focus.run.close()
        focus.run, focus.verdict = None, verdict
        focus.ended_s = self._commons.tick.now_s
        self._commons.record("verdict", focus, verdict=verdict.value, text=focus.words)
        if verdict is Verdict.FAILED:
            self._explain(focus)

    def _explain(self, focus: Focus) -> None:
        failure = focus.failure or Failure("no_way")
        if -1 < failure.said_before < focus.said:
            return
        act = describe(failure.act) if failure.act is not None else None
        if failure.reason == "prohibited" and failure.by is not None and act is not None:
            self._commons.replies.append(Refused(act, failure.by, failure.because))
        else:
            self._commons.replies.append(Failed(act, failure.reason, failure.detail))

    def _fade(self, now_s: float) -> None:
        faded = self._attention.fade(now_s)
        if faded:
            self._commons.memory.forget([node for focus in faded for node in focus.nodes])

    # -- acting ----------------------------------------------------------------------------

    def _arbitrate(self, now_s: float) -> tuple[Bid, ...]:
        """Rule on this tick's claims; those who wait too long, or are taken over too often, are struck."""
        commons = self._commons
        commons.struck.clear()
        halts = [c for c in commons.claims if isinstance(c.bid.command, Halt)]
        motions = [c for c in commons.claims if c not in halts]
        if halts:
            commons.struck |= {claim.bid.ticket: "stopped" for claim in motions}
            motions = []
        ruling = arbitrate(motions)
        for ticket in ruling.conflicts:
            commons.struck[ticket] = "conflict"
        waiting = {}
        by_number = {focus.number: focus for focus in self._attention}
        for claim, winner in ruling.lost:
            ticket = claim.bid.ticket
            waiting[ticket] = self._waiting_since.get(ticket, now_s)
            focus = by_number[claim.focus]
            if ticket not in self._waiting_since:
                commons.record("resource_lost", focus, resource=claim.bid.resource)
                self._took_over(focus, by_number[winner], ticket)
            if now_s - waiting[ticket] > PATIENCE_S:
                commons.struck[ticket] = "resource_lost"
        self._waiting_since = waiting
        return ruling.winners

    def _took_over(self, focus: Focus, winner: Focus, ticket: int) -> None:
        if winner.reaction is None:
            return
        now_s, ident = self._commons.tick.now_s, winner.reaction.ident
        focus.preempted = [p for p in focus.preempted if now_s - p[0] < TAKEOVER_S]
        focus.preempted.append((now_s, ident))
        if sum(lesson == ident for _, lesson in focus.preempted) >= TAKEOVERS:
            self._commons.struck[ticket] = "resource_lost"


def innate() -> list[Lesson]:
    """The operator DO[verb] -> FCN[name] of every grounding function; numbered below zero, without words."""
    lessons: list[Lesson] = []
    for grounding in sorted(GROUNDINGS.values(), key=lambda g: g.name):
        for verb in grounding.verbs:
            sketch = Sketch()
            act = sketch.add("act", verb)
            function = sketch.add("fcn", grounding.name, arg=act)
            operator = Operator(
                Directive("DO", sketch.graphlet(act)),
                sequence(Directive("FCN", sketch.graphlet(function))),
            )
            lessons.append(Lesson(INNATE - len(lessons), "procedure", operator))
    return lessons
