"""A daemon for one utterance: where none runs, `sayso say` and `sayso hear` do it here, on the simulated robot.

Virtual time: nothing is waited for. Lessons go to the same store as the daemon's.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Final

from daemon import events
from daemon.clock import Clock
from daemon.closing import Closing
from daemon.config import Config, store_path
from daemon.control.messages import OutcomeWord
from daemon.hearing.events import Heard, NotHeard, StopWord
from daemon.outcome import Following
from daemon.parts import assemble_virtual
from daemon.store import Store
from daemon.understanding import forgetting
from kernel.memory.meaning import Utterance
from kernel.memory.recent import PATIENCE_S
from kernel.memory.reply import AskKeep

STEP_S: Final = 1 / 30
CONNECT_S: Final = 3.0
SETTLE_S: Final = 60.0


class Here(Closing):
    """A cycle in virtual time on the user's store.

    Args:
        config: scene, seed and paths are taken from it; the robot is the simulated one.
        emit: told of every event.

    Attributes:
        store: where its lessons are.

    Raises:
        StoreError: the store cannot be used.
    """

    def __init__(self, config: Config, emit: Callable[[events.Event], None]) -> None:
        self._watch: Callable[[events.Event], None] = emit
        self._config = config
        self.store = Store.open(store_path(config))
        try:
            self._parts = assemble_virtual(config, self.store, self._emit, Clock.utc_offset_s())
        except BaseException:
            self.store.close()
            raise
        self._following: Following | None = None
        self._run(lambda: self._parts.cycle.state.connected, CONNECT_S)

    def say(self, text: str, speaker: str = "", *, aloud: bool = True) -> OutcomeWord:
        """Take an utterance and let time pass until nothing is going on. aloud: lessons are acknowledged by voice."""
        self._parts.cycle.hushing = int(not aloud)
        self._following = Following(text)
        self._take(Utterance(text, speaker, Clock.wall_s()), "typed")
        return self._finish()

    def forget(self, numbers: tuple[int, ...], speaker: str = "") -> OutcomeWord:
        """Take lessons back by their numbers, which must be in force or rest."""
        meant = forgetting(numbers, speaker, Clock.wall_s())
        said, cycle = meant.utterance, self._parts.cycle
        self._following = Following(said.text)
        cycle.take(meant, cycle.begin(said))
        self.store.log(said.at_s, said.text, speaker, "typed", meant.kind)
        return self._finish()

    def hear(self, path: Path, speaker: str = "") -> OutcomeWord:
        """Take what a sound file says, and let time pass until nothing is going on.

        Raises:
            RecordingError: the file cannot be heard.
            EngineError: the recogniser cannot be used.
        """
        from daemon.virtual_ear import VirtualEar

        cycle, link = self._parts.cycle, self._parts.link
        self._following = Following()
        hearing = self._config.hearing
        with VirtualEar(hearing.engine, hearing.model) as ear:
            recorded = ear.hear(path, cycle.vocabulary)
        began_s = link.now_s
        if not recorded.said:
            cycle.unclear("", "noise")
        for known_s, event in recorded.events:
            self._run(lambda: False, began_s + known_s - link.now_s)
            match event:
                case StopWord():
                    cycle.stop("spotted")
                case Heard(text=text, confidence=confidence):
                    self._take(Utterance(text, speaker, Clock.wall_s(), confidence), "heard")
                case NotHeard(text=text, reason=reason):
                    cycle.unclear(text, reason)
        return self._finish()

    def _take(self, utterance: Utterance, source: str) -> None:
        kind = self._parts.cycle.hear(utterance, source).kind
        self.store.log(utterance.at_s, utterance.text, utterance.speaker, source, kind)

    def _finish(self) -> OutcomeWord:
        assert self._following is not None
        self._run(lambda: self._parts.cycle.idle, SETTLE_S)
        return self._following.outcome if self._parts.cycle.settled else "running"

    def close(self) -> None:
        """Stop and close; nobody is left to answer what was asked, so that ends as it does without an answer."""
        mind = self._parts.cycle.mind
        if isinstance(mind.expecting, AskKeep):
            self._run(lambda: mind.expecting is None and self._parts.cycle.settled, 2 * PATIENCE_S)
        self.store.close()

    def _run(self, until: Callable[[], bool], at_most_s: float) -> None:
        link, cycle = self._parts.link, self._parts.cycle
        end_s = link.now_s + at_most_s
        while link.now_s < end_s:
            link.advance(STEP_S)
            cycle.step(link.now_s)
            if until():
                return

    def _emit(self, event: events.Event) -> None:
        if self._following is not None:
            self._following.see(event)
            self._watch(event)
