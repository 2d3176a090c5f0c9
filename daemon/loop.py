"""Where the two streams meet: sentences on their way down, sensor readings on their way up.

One `Cycle` serves real time (daemon/app.py) and virtual time (daemon/rehearse.py) alike: it has no clock and never
waits. The heartbeat leaves from here and nowhere else, so a hung daemon loses its lease.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from daemon import events
from daemon.speaking.queue import SpeechQueue
from daemon.speaking.voice import Voice
from daemon.telling import from_record, from_reply, from_shift, pose
from daemon.understanding import (
    SAY_AGAIN,
    UNCLEAR,
    Understanding,
    at_once,
    moves,
    stops,
    understand,
)
from daemon.wire import Wire
from daemon.writer import Keeper, Kept, NotKept
from firmware_proto.told import SessionState
from grammars.asking import AskWord
from grammars.errors import NotUnderstoodError
from grammars.replies import say
from grammars.vocabulary import extended, from_policy, with_verb
from kernel.action.call import BodyState
from kernel.memory.exchange import Inputs, Outputs
from kernel.memory.meaning import Heard, Utterance
from kernel.memory.reply import AskKeep, AskWhich, FactTaken, LessonTaken

if TYPE_CHECKING:
    from kernel.bodies.registry import Body
    from kernel.mind import Mind

POSE_EVERY_S: Final = 0.1  # poses told while something moves; fine enough to draw a track
SOURCES_KEPT: Final = 32  # utterances whose origin is remembered for the lessons they become


class Cycle:
    """Messages in, mind, messages out: one step at a time.

    Args:
        mind: fresh, with the lessons in force.
        body: turns messages into a state, and bids into messages.
        link: carries them.
        voice: says what is to be said.
        keeper: makes lessons durable.
        emit: told of everything that happens; must not wait and must not raise.

    Attributes:
        hushing: while it is not 0, what is taught is acknowledged on the screen only (a file is read in).
    """

    def __init__(
        self,
        *,
        mind: Mind,
        body: Body,
        link: Wire,
        voice: Voice,
        keeper: Keeper,
        emit: Callable[[events.Event], None],
    ) -> None:
        self._mind, self._body, self._link, self._keeper = mind, body, link, keeper
        self._emit = emit
        self._speech = SpeechQueue(voice, emit)
        self._heard: list[Heard] = []
        self._kept: list[Kept | NotKept] = []
        self._keeping: set[int] = set()
        self._sources: dict[str, str] = {}
        self._busy = False
        self._up: bool | None = None
        self._down_told: set[str] = set()
        self._posed: events.Pose | None = None
        self.now_s = 0.0
        self.state = BodyState()
        self.failures = 0
        self.hushing = 0
        self.vocabulary = from_policy(mind.policy)
        self._asked: AskWord | None = None

    @property
    def settled(self) -> bool:
        """Nothing is going on, waits to be thought about or waits for the store."""
        return not (self._busy or self._heard or self._keeping or self._kept)

    @property
    def idle(self) -> bool:
        """Settled, and nothing is being said."""
        return self.settled and self._speech.idle

    @property
    def speaking(self) -> bool:
        """The voice is in use (hearing is gated meanwhile)."""
        return self._speech.speaking

    @property
    def mind(self) -> Mind:
        """The mind, for asking (policy, speaker), not for ticking."""
        return self._mind

    @property
    def expecting(self) -> AskWhich | AskKeep | AskWord | None:
        """The question that is open: the mind's, or the one about a word, which the next utterance closes."""
        return self._mind.expecting or self._asked

    @property
    def pose(self) -> events.Pose:
        """Where the body is now."""
        return pose(self.now_s, self.state)

    def stop(self, source: str) -> int:
        """STOP on the wire, before and past everything; speech ends. The mind halts in the next step.

        Commands that were heard and not yet thought about are dropped: none may move after it.
        """
        epoch = self._link.stop()
        self._body.halt()
        self._speech.hush(self.now_s)
        self._emit(events.Stopped(t=self.now_s, source=source, epoch=epoch))
        waiting, self._heard = self._heard, []
        for heard in waiting:
            if not self._dropped(heard):
                self._heard.append(heard)
        return epoch

    def hear(self, utterance: Utterance, source: str = "typed") -> Understanding:
        """Take an utterance: stop words act before they are understood; what is not understood moves nothing."""
        epoch = self.begin(utterance, source)
        try:
            understanding = understand(utterance, self.vocabulary, self.expecting)
        except Exception as error:
            understanding = self.puzzled(utterance, error)
        self.take(understanding, epoch, source)
        return understanding

    def puzzled(self, utterance: Utterance, error: Exception) -> Understanding:
        """The parser itself broke on it: told, and the sentence counts as not understood."""
        text = f"{utterance.text!r}: {type(error).__name__}: {error}"
        self._emit(events.Error(t=self.now_s, part="understanding", text=text))
        return Understanding(
            utterance, "not_understood", "", None, NotUnderstoodError(utterance.text)
        )

    def unclear(self, text: str, reason: str) -> None:
        """Something was said that must not act. reason: hearing's (daemon/hearing/events.py)."""
        told, again = UNCLEAR.get(reason, (reason, False))
        self._emit(events.NotUnderstood(t=self.now_s, text=text, reason=told))
        if again:
            self._emit(events.Question(t=self.now_s, text=SAY_AGAIN))
            self._speech.add(SAY_AGAIN)

    def begin(self, utterance: Utterance, source: str = "typed") -> int:
        """The first half of `hear`: report it, stop if it is a stop word; the stop epoch it belongs to."""
        if at_once(utterance.text):
            self.stop(source)
        text, speaker, confidence = utterance.text, utterance.speaker, utterance.confidence
        self._emit(events.Heard(t=self.now_s, text=text, speaker=speaker, confidence=confidence))
        return self._link.stop_epoch

    def take(self, understanding: Understanding, epoch: int, source: str = "typed") -> None:
        """The second half: its meaning goes to the mind in the next step, or a reply says that it has none.

        A command that was heard before a stop and understood after it is dropped.
        """
        text = understanding.utterance.text
        if stops(understanding):
            before, after = self._link.stop_epoch, self.stop(source)
            epoch = after if epoch == before else epoch
        self._asked = None
        if understanding.taught:
            self.vocabulary = with_verb(self.vocabulary, understanding.taught)
        if understanding.error is not None:
            said, self._asked = say(understanding.error), understanding.error.asking
            self._emit(events.NotUnderstood(t=self.now_s, text=text, reason=said.shown))
            self._speech.add(said.spoken, told=True)
        if (heard := understanding.heard) is None:
            return
        readback, kind = understanding.readback, understanding.kind
        self._emit(events.Understood(t=self.now_s, text=text, readback=readback, kind=kind))
        if epoch < self._link.stop_epoch and self._dropped(heard):
            return
        self._heard.append(heard)
        self._sources[heard.utterance.text] = source
        if len(self._sources) > SOURCES_KEPT:
            del self._sources[next(iter(self._sources))]

    def _dropped(self, heard: Heard) -> bool:
        if not moves(heard.meaning):
            return False
        text = heard.utterance.text
        self._emit(events.Ended(t=self.now_s, text=text, verdict="stopped", utterance=text))
        return True

    def step(self, now_s: float) -> None:
        """One cycle. However it goes wrong: wheels stopped, an error told, and the next step tries again."""
        self.now_s = now_s
        try:
            outputs = self._think(now_s)
            self._tell(outputs, now_s)
        except Exception as error:
            self._crashed(error)
        else:
            self.failures = 0

    def _think(self, now_s: float) -> Outputs:
        self.state = self._body.sense(self._link.received(), now_s, self._link.connected)
        self._kept.extend(self._keeper.results())
        heard, self._heard = tuple(self._heard), []
        spoken = self._speech.step(now_s)
        outputs = self._mind.tick(
            Inputs(
                now_s=now_s,
                body=self.state,
                heard=heard,
                spoken=spoken,
                persisted=tuple((k.key, k.change) for k in self._kept if isinstance(k, Kept)),
                persist_failed=tuple((k.key, k.why) for k in self._kept if isinstance(k, NotKept)),
                stop_epoch=self._link.stop_epoch,
            )
        )
        self._link.send(self._body.act(outputs.bids, now_s), outputs.stop_epoch)
        self._link.beat()
        self._busy = outputs.busy
        return outputs

    def _tell(self, outputs: Outputs, now_s: float) -> None:
        self._watch_link(now_s)
        self._settle_lessons(now_s)
        self.vocabulary = extended(self.vocabulary, outputs.shift.entered)
        for event in from_shift(outputs.shift, now_s):
            self._emit(event)
        for key, change in outputs.persist:
            self._keeping.add(key)
            self._keeper.keep(key, change, self._sources.get(change.words, ""))
        moved = False
        for record in outputs.trace:
            event = from_record(record, now_s)
            self._emit(event)
            moved = moved or isinstance(event, events.ActionEnded)
        for reply in outputs.replies:
            said = say(reply)
            for event in from_reply(reply, said, now_s):
                self._emit(event)
            if said.spoken and not (self.hushing and isinstance(reply, LessonTaken | FactTaken)):
                self._speech.add(said.spoken, told=True)
        for bid in outputs.speech:
            self._speech.add(getattr(bid.command, "text", ""), bid.ticket)
        self._watch_pose(now_s, told=moved)

    def _settle_lessons(self, now_s: float) -> None:
        """Told only after the tick in which the mind took them into force."""
        while self._kept:
            result = self._kept.pop(0)
            self._keeping.discard(result.key)
            if isinstance(result, NotKept):
                self._emit(events.Error(t=now_s, part="store", text=result.why))

    def _watch_link(self, now_s: float) -> None:
        """Told: coming up, going down, and while it is down each new reason once."""
        up, detail = self._link.connected, self._link.detail
        first, changed = self._up is None, up != self._up
        self._up = up
        if up:
            self._down_told.clear()
        opening = self._link.state is SessionState.OPENING
        new = not up and not opening and detail not in self._down_told
        self._down_told.add(detail)
        if (changed and (up or not first)) or (new and not first):
            self._emit(events.Link(t=now_s, up=up, detail=detail))

    def _watch_pose(self, now_s: float, *, told: bool) -> None:
        """At the end of every action, and now and then while something moves."""
        current = pose(now_s, self.state)
        last = self._posed
        if not told and last is not None:
            same = events.as_dict(current) | {"t": 0} == events.as_dict(last) | {"t": 0}
            if same or now_s - last.t < POSE_EVERY_S:
                return
        self._posed = current
        self._emit(current)

    def _crashed(self, error: Exception) -> None:
        """The first failure in a row stops the robot and is told; the others only count, and the watchdog starves."""
        self.failures += 1
        if self.failures > 1:
            return
        self._emit(events.Error(t=self.now_s, part="mind", text=f"{type(error).__name__}: {error}"))
        self.stop("crash")
