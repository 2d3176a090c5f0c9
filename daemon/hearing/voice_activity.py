"""Speech or silence, told from the level alone."""

from __future__ import annotations

from collections import deque

import numpy as np

from daemon.hearing.recogniser import RATE_HZ, Samples

FRAME_S = 0.02
FRAME = round(FRAME_S * RATE_HZ)
ONSET_FRAMES = 3
"""So many of the last five frames must be loud for speech to begin: a click is shorter."""
ABOVE_FLOOR_DB = 10.0
QUIETEST_DB = -52.0
"""Below this, relative to full scale, nothing is taken for speech however silent the room is."""
FLOOR_WINDOW_S = 4.0
FLOOR_QUANTILE = 0.1
"""The noise floor is the level a tenth of the last seconds stays below: even fluent speech has gaps enough."""
FLOOR_AFTER_FRAMES = 25
"""Before that a recording may have begun in the middle of a word, which is no floor."""
FLOOR_RANGE_DB = (-75.0, -25.0)


class VoiceActivity:
    """Takes 20 ms frames in order; says for each whether it is loud, and whether speech has begun."""

    def __init__(self) -> None:
        self._levels: deque[float] = deque(maxlen=round(FLOOR_WINDOW_S / FRAME_S))
        self._loud: deque[bool] = deque(maxlen=5)

    def loud(self, frame: Samples) -> bool:
        """Take the next frame; whether it is louder than the room."""
        level = level_db(frame)
        self._levels.append(level)
        loud = level > self._loud_db
        self._loud.append(loud)
        return loud

    @property
    def begun(self) -> bool:
        """Whether the last frames sound like the beginning of speech."""
        return sum(self._loud) >= ONSET_FRAMES

    @property
    def loud_power(self) -> float:
        """Mean square of the samples from which on sound is loud."""
        return float(10.0 ** (self._loud_db / 10.0)) * 32768.0**2

    @property
    def _loud_db(self) -> float:
        return max(self.floor_db + ABOVE_FLOOR_DB, QUIETEST_DB)

    @property
    def floor_db(self) -> float:
        """The level of the room, dB relative to full scale."""
        low, high = FLOOR_RANGE_DB
        if len(self._levels) < FLOOR_AFTER_FRAMES:
            return low
        ordered = sorted(self._levels)
        return min(max(ordered[int(len(ordered) * FLOOR_QUANTILE)], low), high)


def level_db(frame: Samples) -> float:
    """Level of a frame, dB relative to full scale; -100 for digital silence."""
    power = float(np.mean(np.square(frame.astype(np.float64) / 32768.0))) if len(frame) else 0.0
    return 10.0 * float(np.log10(max(power, 1e-10)))
