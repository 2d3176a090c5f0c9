"""The mind: one cycle of noticing, thinking and bidding.

Time, chance and the body come in as arguments; the same inputs give the same outputs, always.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable
from typing import Final

from kernel.action.discover import load_all
from kernel.action.sensing import SENSES
from kernel.action.step import Run
from kernel.action.verdict import Verdict
from kernel.arbitrating import Arbitration
from kernel.asking import Asking, answer
from kernel.attending import attend, notice
from kernel.commons import Commons
from kernel.complaining import complain, explanation, failed_act
from kernel.imagining import suppose, transplant
from kernel.innate import innate
from kernel.memory.attention import ROOM, Attention, Failure, Focus
from kernel.memory.change import SESSION, Change
from kernel.memory.exchange import Inputs, Outputs
from kernel.memory.experience import Experience
from kernel.memory.lesson import INNATE, Lesson, Resting
from kernel.memory.meaning import Command, Control, Heard, Question, Revision, Utterance
from kernel.memory.operators import Operators
from kernel.memory.policy import Shift
from kernel.memory.reply import AskKeep, AskWhich, Failed, Halted, Reply
from kernel.memory.settings import Settings
from kernel.memory.working import WorkingMemory
from kernel.net.graphlet import Graphlet
from kernel.net.node import Node
from kernel.remembering import unreached
from kernel.steering import remember_interrupted

PARTS: Final = ("gripper", "lift", "fork", "wheel", "battery", "finger", "arm")


class Mind:
    """All that deliberates.

    Args:
        lessons: what is in force from the start, born knowledge included.
        history: every stored change of what was taught, oldest first.
        resting: stored lessons that cannot be in force.
        seed: of the chances it takes.
        settings: numbers of mind.md.
    """

    def __init__(
        self,
        lessons: Iterable[Lesson] = (),
        seed: int = 0,
        settings: Settings | None = None,
        history: Iterable[Change] = (),
        resting: Iterable[Resting] = (),
    ) -> None:
        for package in ("kernel.directives", "kernel.grounding", "kernel.answering"):
            load_all(package)
        settings = settings or Settings()
        self._attention = Attention(settings.fade_s)
        memory = WorkingMemory(self._in_attention, PARTS)
        self._commons = Commons(
            memory, Operators(), random.Random(seed), settings, attention=self._attention
        )
        self._senses = [make() for _, make in sorted(SENSES.items())]
        self._arbitration = Arbitration(self._commons)
        self._waking: list[Focus] = []
        self.epoch = 0
        self.speaker = ""
        for lesson in (*innate(), *lessons):
            self._commons.bear(lesson)
        for change in history:
            self._commons.change(change)
        self._commons.resting = tuple(resting)
        memory.refresh()

    @property
    def policy(self) -> tuple[Lesson, ...]:
        """Lessons in force, without the operators of the body's own skills and the facts of the session."""
        return tuple(x for x in self._commons.lessons.values() if INNATE < x.ident < SESSION)

    @property
    def foci(self) -> tuple[Focus, ...]:
        """What is in attention, newest first; for looking."""
        return tuple(self._attention)

    @property
    def history(self) -> tuple[Change, ...]:
        """Every stored change of what was learned, oldest first."""
        durable = (change.durable() for change in self._commons.policy.changes())
        return tuple(change for change in durable if change is not None)[::-1]

    @property
    def memory(self) -> WorkingMemory:
        """For looking, not for touching."""
        return self._commons.memory

    @property
    def expecting(self) -> AskWhich | AskKeep | None:
        """The question that is open, if there is one."""
        commons = self._commons
        if commons.which is not None:
            return commons.which.question
        return commons.doubt.question if commons.doubt is not None else None

    @property
    def experience(self) -> Experience:
        """What was done, for looking."""
        return self._commons.experience

    def ask(self, question: Question, at_s: float = 0.0) -> Reply:
        """The answer to a question about the robot itself without anybody's having asked aloud: nothing changes.

        at_s: wall time of the question.
        """
        focus = Focus(0, Heard(Utterance("", self.speaker, at_s), question))
        return answer(Asking(self._commons, focus, self, question))

    def imagined(self, inputs: Inputs) -> Mind:
        """A copy that knows and senses the same, with nothing going on: to try something out (kernel.imagining)."""
        copy = Mind(settings=self._commons.settings)
        copy.speaker = self.speaker
        copy.tick(inputs)  # the senses settle before there are lessons to react with
        transplant(self._commons, copy._commons, self.speaker)
        return copy

    def suppose(self, fact: Graphlet) -> None:
        """Notice a fact as if it were sensed."""
        self._begin(notice, None, suppose(self._commons.memory, fact), None)

    def _in_attention(self) -> list[Node]:
        return [node for focus in self._attention for node in focus.nodes]

    def tick(self, inputs: Inputs) -> Outputs:
        """One cycle."""
        commons, now_s = self._commons, inputs.now_s
        commons.tick.now_s, commons.tick.body = now_s, inputs.body
        commons.tick.spoken = inputs.spoken
        commons.steps = 0
        for key, change in inputs.persisted:
            commons.kept(key, change)
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
        winners = self._arbitration.rule(self.close)
        self._fade(now_s)
        commons.recent.say(commons.replies, now_s)
        outputs = Outputs(
            bids=() if stopping else winners,
            speech=tuple(commons.speech),
            replies=tuple(commons.replies),
            persist=tuple(commons.persist),
            shift=commons.shift,
            trace=tuple(commons.trace),
            stop_epoch=self.epoch,
            busy=any(focus.waits != {"answer"} for focus in self._attention.active()),
        )
        for produced in (commons.speech, commons.replies, commons.persist, commons.trace):
            produced.clear()
        commons.shift = Shift()
        return outputs

    # -- what comes in ---------------------------------------------------------------------

    def _halt(self, epoch: int) -> None:
        """Stop everything, then enter the new epoch: only then may anything move again."""
        active = self._attention.active()
        remember_interrupted(self._commons, reversed(active), afresh=True)
        for focus in active:
            focus.progress = None
            self.close(focus, Verdict.STOPPED)
        self.epoch = epoch
        self._commons.struck.clear()
        self._commons.speech.clear()
        self._arbitration.clear()
        self._commons.record("stopped", None, epoch=epoch, foci=len(active))
        self._commons.replies.append(Halted(bool(active)))

    def _sense(self, inputs: Inputs) -> None:
        memory = self._commons.memory
        noticed: list[Node] = []
        fleeting = []
        for sense in self._senses:
            for edge in sense.update(inputs.body):
                if edge.noted:
                    self._commons.record("sensed", None, key=edge.key, holds=edge.fact is not None)
                if edge.fact is None:
                    memory.unsense(edge.key)
                elif edge.fleeting:
                    fleeting.append(edge.fact)
                else:
                    held = memory.sense(edge.key, edge.fact, edge.part)
                    noticed += held if edge.noted else ()
        if noticed:
            self._begin(notice, None, tuple(noticed), None)
        for fact in fleeting:
            self._begin(notice, None, (), fact)

    def _hear(self, heard: Heard) -> None:
        if isinstance(heard.meaning, Command | Revision | Control):
            self._drop_question()
        if len(self._attention.active()) >= ROOM:
            self._commons.replies.append(Failed(None, "no_room"))
            self._commons.record(
                "error", None, text="attention is full", words=heard.utterance.text
            )
            return
        self._begin(attend, heard)

    def _drop_question(self) -> None:
        """Another command closes the question, and what waits for its answer ends."""
        which = self._commons.which
        for focus in self._attention.active():
            if which is not None and focus.number == which.focus:
                self.close(focus, Verdict.STOPPED)
        self._commons.which = None

    def _begin(self, how: Callable[..., Run], heard: Heard | None, *args: object) -> Focus:
        if self._attention.crowded and (gone := self._attention.evict()) is not None:
            self._commons.memory.forget(gone.nodes)
        focus = self._attention.post(heard)
        focus.run = how(self, self._commons, focus, *args)
        focus.waits.add("next tick")
        self._commons.record("focus", focus, text=focus.words or "noticed")
        return focus

    # -- thinking --------------------------------------------------------------------------

    def _think(self) -> None:
        """Resume every focus once; newest first, so that what they say about each other is in order."""
        self._commons.claims.clear()
        self._waking = self._attention.active()
        for focus in self._waking:
            if focus.run is None:
                continue
            focus.waits.clear()
            if focus.dismissed:
                self.close(focus, Verdict.STOPPED)
                continue
            try:
                next(focus.run)
            except StopIteration as end:
                self.close(focus, end.value)
            except RecursionError:
                focus.failure = Failure("recursion")
                self.close(focus, Verdict.FAILED)
            self._notice_own_acts()

    def _notice_own_acts(self) -> None:
        begun, self._commons.begun = self._commons.begun, []
        for node in begun:
            focus = self._begin(notice, None, (node,), None)
            focus.own = True
            self._waking.append(focus)

    def active(self) -> list[Focus]:
        """Foci not handled yet, newest first."""
        return self._attention.active()

    def close(self, focus: Focus, verdict: Verdict) -> None:
        """End a focus: its chain ends, and its motions with it."""
        if verdict is Verdict.STOPPED:
            remember_interrupted(self._commons, [focus])
        focus.progress = None
        if focus.run is not None:
            focus.run.close()
        focus.run, focus.verdict = None, verdict
        unreached(self._commons, focus, verdict)
        focus.ended_s = self._commons.tick.now_s
        self._commons.record("verdict", focus, verdict=verdict.value, text=focus.words)
        if verdict in (Verdict.FAILED, Verdict.UNKNOWN):
            self._explain(focus)

    def _explain(self, focus: Focus) -> None:
        """Note the failure, so that advice on failures applies: born advice is to tell it. A failing complaint is
        silent, and so is a failure that the robot has spoken about already."""
        failure = focus.failure or Failure("no_way")
        if focus.excuse is not None or -1 < failure.said_before < focus.said:
            return
        excuse = explanation(self._commons, failure)
        complaint = self._begin(complain, None, failure, failed_act(focus))
        complaint.excuse = excuse
        self._waking.append(complaint)

    def _fade(self, now_s: float) -> None:
        faded = self._attention.fade(now_s)
        if faded:
            self._commons.memory.forget([node for focus in faded for node in focus.nodes])
