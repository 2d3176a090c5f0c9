"""The ear's core: sound in, events out. No clock: time is the number of samples heard, so it is the same in real time
and in virtual time."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

import numpy as np

from daemon.hearing import endpoint
from daemon.hearing.events import CoreEvent, Ended, NotHeard, Partial, StopWord
from daemon.hearing.recogniser import RATE_HZ, Recogniser, Samples
from daemon.hearing.stop_spotter import STOP_WORDS, StopSpotter
from daemon.hearing.voice_activity import FRAME, FRAME_S, VoiceActivity
from grammars.language import Language

LOOK_EVERY = 3
"""Frames between two looks at the hypothesis; at its beginning, where a "stop" would be, every frame is looked at."""
BEGINNING_S = 2.0
LEAD_S = 0.2
"""Sound the engines hear from before the speech: soft first consonants, and the silence they begin in."""
ONSET_S = 0.3
"""Sound in which the beginning of the speech is looked for."""
PADDING_S = 0.3
"""Silence added for the engine at the end: with 0.3 s of its own, 4 % fewer sentences came out whole."""
TRAIL_S = 0.5
"""Silence the engine hears after a word; longer pauses are cut to this and the lead before the next word."""
PAUSE_S = 0.3
"""Silence after which the next word is also heard by itself, in case it is "stop"."""
DITHER = 3.0
"""Standard deviation of the noise added for the engine, of 32768: digital silence is unlike any room it has learned."""
QUIET_S = 0.1
"""Silence after which a stop word counts as said alone. "Stock prices" has nearly as much in its middle, and was taken
for a stop in two voices of four; longer would cost the 200 ms in which a stop must be found."""
CLICK_S = 0.1
"""After so much silence one loud frame alone is a click, no speech."""


@dataclass
class _Utterance:
    """What is being said."""

    began_s: float
    sound: list[Samples]
    spoken_s: float
    resumed_s: float
    text: str = ""
    whole: bool = False
    before: str = ""
    changed_s: float = 0.0
    gated: bool = False
    chance: np.random.Generator = field(default_factory=lambda: np.random.default_rng(0))
    frames: int = 0
    unfed: deque[Samples] = field(default_factory=lambda: deque(maxlen=round(LEAD_S / FRAME_S)))


class Listener:
    """Takes sound in order, any number of samples at a time.

    Args:
        engine: hears whole utterances.
        spare: another of the same kind: hears the beginning, and what follows a pause by itself, so that a "stop" in
            the middle of a halting lesson stops; with fewer words, as "stop" among many is heard late: it might be
            "stopped".
        language: what may be said.
        robot_name: may stand before or after a stop word.
    """

    def __init__(
        self, engine: Recogniser, spare: Recogniser, language: Language, robot_name: str = "robot"
    ) -> None:
        self._engine, self._spare = engine, spare
        self._activity = VoiceActivity()
        self._spotter = StopSpotter(robot_name)
        self._rest: Samples = np.zeros(0, np.int16)
        self._heard = 0
        self._before: Samples = np.zeros(round((LEAD_S + ONSET_S) * RATE_HZ), np.int16)
        self._utterance: _Utterance | None = None
        self._unfinished: _Utterance | None = None
        self._lesson_ended_s = -endpoint.JOIN_S
        self._lesson_broken = False
        self.unheard: tuple[str, ...] = ()
        self.set_language(language)

    @property
    def now_s(self) -> float:
        """Audio time: how much has been heard."""
        return self._heard / RATE_HZ

    def _since(self, moment_s: float) -> float:
        """Seconds since then; rounded, as 0.3 s of silence must be 0.3 s wherever it began."""
        return round(self.now_s - moment_s, 6)

    @property
    def idle(self) -> bool:
        """Whether nothing is being said and nothing waits to be finished."""
        return self._utterance is None and self._unfinished is None

    def set_language(self, language: Language) -> None:
        """Take a new language; call only when idle. Its words that the engine cannot hear are then in `unheard`."""
        self._language = language
        self._spare.set_grammar(language.plain())
        self.unheard = self._engine.set_grammar(language)

    def hear(self, samples: Samples, gated: bool = False) -> Iterator[CoreEvent]:
        """Hear some more; gated while the robot itself speaks: then only a stop word counts."""
        self._rest = np.concatenate([self._rest, samples])
        while len(self._rest) >= FRAME:
            frame, self._rest = self._rest[:FRAME], self._rest[FRAME:]
            self._heard += FRAME
            loud = self._activity.loud(frame)
            self._before = np.concatenate([self._before[FRAME:], frame])
            if self._utterance is None:
                yield from self._wait()
            else:
                yield from self._follow(self._utterance, frame, loud, gated)

    def _wait(self) -> Iterator[CoreEvent]:
        if self._activity.begun:
            self._begin()
            return
        held = self._unfinished
        if held and self._since(held.spoken_s) >= endpoint.LONG_WAIT_S + endpoint.JOIN_S:
            self._unfinished = None
            yield NotHeard(held.began_s, held.spoken_s, self.now_s, "unfinished", held.text)

    def _begin(self) -> None:
        """Speech begins. What goes on from an unfinished utterance is heard together with it, from its sound.

        What the engine hears is counted from the first loud sample, and its noise drawn anew: the same speech is then
        the same to it, whatever came before and wherever its blocks happened to be cut.
        """
        held, self._unfinished = self._unfinished, None
        sound = self._before[self._onset() :]
        whole = len(sound) // FRAME * FRAME
        again = len(sound) - whole
        self._rest = np.concatenate([sound[whole:], self._rest])
        self._before = np.concatenate(
            [self._before[:again], self._before[: len(self._before) - again]]
        )
        self._heard -= again
        began_s = held.began_s if held else self.now_s - whole / RATE_HZ
        heard = list(held.sound) if held else []
        utterance = _Utterance(began_s, heard, self.now_s, self.now_s)
        if held:
            utterance.chance, utterance.text = held.chance, held.text
        self._utterance = utterance
        self._engine.reset()
        for frame in heard:
            self._engine.feed(frame)
        lead = [
            _dithered(frame, utterance.chance) for frame in np.split(sound[:whole], whole // FRAME)
        ]
        self._hear_apart(utterance, ())
        self._feed(utterance, *lead)

    def _onset(self) -> int:
        """Place in the sound before, LEAD_S ahead of where it grows loud."""
        lead, width = round(LEAD_S * RATE_HZ), FRAME // 4
        power = np.cumsum(np.square(self._before[lead - width :].astype(np.float64)))
        loud = power[width:] - power[:-width] >= width * self._activity.loud_power
        return int(np.argmax(loud))

    def _hear_apart(self, utterance: _Utterance, lead: Iterable[Samples]) -> None:
        utterance.resumed_s, utterance.before = self.now_s, utterance.text
        self._spotter.reset()
        self._spare.reset()
        for frame in lead:
            self._spare.feed(frame)

    def _follow(
        self, utterance: _Utterance, frame: Samples, loud: bool, gated: bool
    ) -> Iterator[CoreEvent]:
        utterance.gated |= gated
        silence_s = self._since(utterance.spoken_s)
        if loud and (silence_s <= CLICK_S or self._activity.begun):
            if silence_s >= PAUSE_S:
                self._hear_apart(utterance, utterance.unfed)
            utterance.spoken_s = self.now_s
        frame = _dithered(frame, utterance.chance)
        utterance.unfed.append(frame)
        if self._since(utterance.spoken_s) <= TRAIL_S:
            if silence_s > TRAIL_S:
                self._feed(utterance, *utterance.unfed)
            else:
                self._feed(utterance, frame)
        utterance.frames += 1
        if utterance.frames % LOOK_EVERY == 0 or self._since(utterance.resumed_s) < BEGINNING_S:
            yield from self._look(utterance)

    def _feed(self, utterance: _Utterance, *frames: Samples) -> None:
        utterance.sound.extend(frames)
        for frame in frames:
            self._engine.feed(frame)
            if self._since(utterance.resumed_s) < BEGINNING_S:
                self._spare.feed(frame)

    def _look(self, utterance: _Utterance) -> Iterator[CoreEvent]:
        text = self._engine.partial()
        if text != utterance.text:
            utterance.text, utterance.changed_s = text, self.now_s
            utterance.whole = self._engine.is_sentence(text)
            if text and not utterance.gated:
                yield Partial(self.now_s, text)
        heard = self._apart(utterance)
        if word := self._spotter.heard(heard, self._since(utterance.spoken_s) >= QUIET_S):
            yield StopWord(self.now_s, word)
        wait_s = endpoint.wait_s(text, utterance.whole)
        settled_s = endpoint.SETTLED_S * (1 if wait_s == endpoint.SHORT_WAIT_S else 2)
        settled = utterance.whole and self._since(utterance.changed_s) >= settled_s
        too_long = self.now_s - utterance.began_s >= endpoint.LONGEST_S
        if self._since(utterance.spoken_s) >= wait_s or settled or too_long:
            yield from self._end(utterance, too_long)

    def _apart(self, utterance: _Utterance) -> str:
        """What follows the last pause: as the whole is heard if that makes it a stop, else as it is by itself."""
        rest = utterance.text.removeprefix(utterance.before).strip()
        return rest if rest in STOP_WORDS else self._spare.partial()

    def _end(self, utterance: _Utterance, cut: bool) -> Iterator[CoreEvent]:
        self._utterance = None
        silence = np.zeros(round(PADDING_S * RATE_HZ), np.int16)
        self._engine.feed(_dithered(silence, utterance.chance))
        found = self._engine.final()
        if utterance.gated:
            return
        times = (utterance.began_s, utterance.spoken_s, self.now_s)
        best = found[0].text if found else utterance.text
        whole = utterance.whole if best == utterance.text else self._engine.is_sentence(best)
        if not cut and endpoint.is_unfinished(best, whole, self._language):
            utterance.text = best
            self._unfinished = utterance
            return
        after_lesson = times[0] - self._lesson_ended_s < endpoint.JOIN_S
        rest = self._lesson_broken and not endpoint.is_open(best)
        if after_lesson and (rest or endpoint.is_continuation(best)):
            self._lesson_ended_s = self.now_s
            yield NotHeard(*times, "fragment", best)
            return
        if endpoint.is_open(best):
            # What was heard of it is no sentence: what follows at once may be the rest of it.
            self._lesson_broken = not whole
            self._lesson_ended_s = self.now_s
        yield Ended(*times, tuple((text, confidence) for text, confidence in found), cut)


def _dithered(samples: Samples, chance: np.random.Generator) -> Samples:
    noisy = samples + chance.normal(0.0, DITHER, len(samples))
    return np.clip(np.round(noisy), -32768, 32767).astype(np.int16)
