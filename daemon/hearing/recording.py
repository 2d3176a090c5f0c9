"""Sound files as a source: whatever can be made into 16 kHz mono is; the rest is refused with the reason."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import soundfile
import soxr

from daemon.hearing.recogniser import RATE_HZ, Samples

BLOCK_S = 0.1
LOWEST_RATE_HZ, HIGHEST_RATE_HZ = 8_000, 384_000
"""Below 8 kHz the consonants are gone, and nothing can bring them back."""
LONGEST_S = 3_600.0


class RecordingError(Exception):
    """A sound file that cannot be heard."""

    def __init__(self, path: Path, wrong: str, remedy: str) -> None:
        super().__init__(f"{path}: {wrong}; {remedy}")
        self.path, self.wrong, self.remedy = path, wrong, remedy


def read(path: Path) -> Samples:
    """Read a sound file as 16 kHz mono: channels are averaged, other rates resampled, other widths rounded.

    Raises:
        RecordingError: it is missing, unreadable, empty, longer than an hour, or sampled below 8 kHz.
    """
    if not path.is_file():
        raise RecordingError(path, "there is no such file", "check the name")
    if path.stat().st_size == 0:
        raise RecordingError(path, "the file is empty", "record it again")
    try:
        with soundfile.SoundFile(path) as file:
            rate_hz = file.samplerate
            if not LOWEST_RATE_HZ <= rate_hz <= HIGHEST_RATE_HZ:
                remedy = "record at 8 kHz or more, best at 16 kHz"
                raise RecordingError(path, f"it is sampled at {rate_hz} Hz", remedy)
            if file.frames > LONGEST_S * rate_hz:
                raise RecordingError(path, "it is longer than an hour", "cut it into pieces")
            sound = file.read(dtype="float32", always_2d=True)
    except (soundfile.LibsndfileError, OSError) as error:
        remedy = "use WAV, FLAC or Ogg, for example: ffmpeg -i FILE -ar 16000 -ac 1 out.wav"
        raise RecordingError(path, f"no sound can be read from it ({error})", remedy) from error
    if not len(sound):
        raise RecordingError(path, "there is no sound in it", "record it again")
    mono = sound.mean(axis=1)
    if rate_hz != RATE_HZ:
        mono = soxr.resample(mono, rate_hz, RATE_HZ)
    return np.asarray(np.clip(np.round(mono * 32768.0), -32768, 32767), dtype=np.int16)


def blocks(samples: Samples, length_s: float = BLOCK_S) -> Iterator[Samples]:
    """The samples in blocks, the last one perhaps shorter."""
    length = round(length_s * RATE_HZ)
    for start in range(0, len(samples), length):
        yield samples[start : start + length]
