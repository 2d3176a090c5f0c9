"""The demonstration as shipped: every line of the paper's, each with its recording."""

import re
from pathlib import Path

import pytest
import soundfile

from daemon.acts import acts
from daemon.demo.script import AUDIO, recordings, script, spoken
from daemon.dialogue import Insert, Place, Remove, You


def test_every_spoken_line_has_its_recording_and_none_is_left_over() -> None:
    paths = recordings(script())
    assert sorted(paths.values()) == sorted(AUDIO.glob("*.wav"))


@pytest.mark.parametrize("name", sorted(spoken(script()).values()))
def test_a_recording_is_16_khz_mono_16_bit_and_loud_enough(name: str) -> None:
    path = AUDIO / name
    info = soundfile.info(path)
    assert (info.samplerate, info.channels, info.subtype) == (16_000, 1, "PCM_16")
    samples, _ = soundfile.read(path)
    assert 0.1 < abs(samples).max() <= 1.0
    assert 1.0 < info.duration < 8.0


def test_every_input_line_is_checked() -> None:
    for act in acts(script().steps):
        assert act.expected, act.step
        assert all(line.expectation.checked for line in act.expected)


def test_it_holds_all_that_the_papers_section_4_shows() -> None:
    demonstration = script()
    said = " | ".join(step.text.lower() for step in demonstration.steps if isinstance(step, You))
    for words in (
        "to cha-cha drive forward then drive backwards",
        "to shimmy turn left then turn right",
        "to dance cha-cha then shimmy",
        "please dance",
        "if something is very close then drive backwards",
        "you should never grab a person but instead say i'm not allowed to",
        "if something is a girl it is a person",
        "mary is a girl",
        "grab mary",
        "turn means rotate",
        "widdershins means counterclockwise",
        "if rick tells you to do something don't but instead complain",
        "to complain say i don't take orders from you",
        "i am rick",
    ):
        assert words in said
    assert len(re.findall("to complain say", said)) == 2
    kinds = {type(step) for step in demonstration.steps}
    assert {Place, Insert, Remove} <= kinds


def test_a_missing_recording_is_named(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"01-drive-forward\.wav"):
        recordings(script(), tmp_path)
