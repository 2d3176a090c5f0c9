"""Sound files of all sorts."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import soundfile

from daemon.hearing.recording import RecordingError, blocks, read

TONE = (0.3 * np.sin(np.arange(16_000) * 2 * np.pi * 440 / 16_000)).astype(np.float32)


@pytest.mark.parametrize("rate_hz", [8_000, 16_000, 44_100, 48_000])
@pytest.mark.parametrize("channels", [1, 2])
@pytest.mark.parametrize("subtype", ["PCM_16", "PCM_24", "FLOAT"])
def test_other_forms_are_converted(
    tmp_path: Path, rate_hz: int, channels: int, subtype: str
) -> None:
    times = np.arange(rate_hz) / rate_hz
    tone = 0.3 * np.sin(times * 2 * np.pi * 440)
    path = tmp_path / "tone.wav"
    soundfile.write(path, np.stack([tone] * channels, axis=1), rate_hz, subtype=subtype)
    samples = read(path)
    assert samples.dtype == np.int16
    assert abs(len(samples) - 16_000) <= 2
    middle = slice(2_000, 14_000)
    assert np.abs(samples[middle] / 32768.0 - TONE[middle]).max() < 0.01


def test_what_cannot_be_heard_is_refused_with_the_reason(tmp_path: Path) -> None:
    cases = {
        "missing.wav": "no such file",
        "empty.wav": "empty",
        "text.wav": "no sound can be read",
        "silent.wav": "no sound in it",
        "slow.wav": "4000 Hz",
    }
    (tmp_path / "empty.wav").write_bytes(b"")
    (tmp_path / "text.wav").write_text("drive forward")
    soundfile.write(tmp_path / "silent.wav", np.zeros(0), 16_000)
    soundfile.write(tmp_path / "slow.wav", np.zeros(100), 4_000)
    for name, reason in cases.items():
        with pytest.raises(RecordingError, match=reason):
            read(tmp_path / name)


def test_blocks_are_the_whole_recording() -> None:
    samples = np.arange(4_000, dtype=np.int16)
    assert np.array_equal(np.concatenate(list(blocks(samples))), samples)
    assert [len(block) for block in blocks(samples)] == [1_600, 1_600, 800]
