"""The daemon's hearing with the real recogniser: sound files at their own pace, words that were learned, bad files."""

from __future__ import annotations

import asyncio
import sys
import wave
from collections.abc import Callable
from pathlib import Path

import pytest

from daemon import events, listening
from daemon.config import Hearing
from daemon.ears import Ears
from daemon.understanding import understand
from kernel.memory.meaning import Utterance

sys.path.insert(0, str(Path(__file__).parent))
from bench import Bench

AUDIO = Path(listening.__file__).parent / "demo" / "audio"
ANSWER = Path(__file__).parents[1] / "dialogues" / "audio" / "the-red-one.wav"


def submitting(bench: Bench) -> Callable[[Utterance, str], asyncio.Future[None]]:
    def submit(utterance: Utterance, source: str) -> asyncio.Future[None]:
        epoch = bench.cycle.begin(utterance, source)
        words, asked = bench.cycle.vocabulary, bench.cycle.mind.expecting
        bench.cycle.take(understand(utterance, words, asked), epoch, source)
        taken: asyncio.Future[None] = asyncio.get_running_loop().create_future()
        taken.set_result(None)
        return taken

    return submit


def write(path: Path, seconds: float) -> Path:
    with wave.open(str(path), "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(16_000)
        file.writeframes(bytes(int(32_000 * seconds)))
    return path


async def test_what_is_said_is_heard_then_learned_words_are_heard_as_well(tmp_path: Path) -> None:
    bench = Bench()
    ears = Ears(Hearing(), bench.cycle, submitting(bench))
    try:
        await ears.play(AUDIO / "03-to-shimmy-turn-left-then-turn-right.wav", "", "heard")
        bench.run(until=lambda: bench.cycle.idle)
        assert [lesson.kind for lesson in bench.all(events.Lesson)] == ["procedure"]
        ears.refresh()
        await ears.play(write(tmp_path / "silence.wav", 0.3), "", "heard")
        assert bench.all(events.NotUnderstood)[-1].reason == "I heard no words."
        with pytest.raises(ValueError, match=r"README\.md: no sound can be read from it"):
            await ears.play(Path(__file__).parents[2] / "README.md", "", "heard")
        with pytest.raises(ValueError, match="there is no such file"):
            await ears.play(tmp_path / "nowhere.wav", "", "heard")
        await ears.play(AUDIO / "01-drive-forward.wav", "Mary", "heard")
        (heard,) = [e for e in bench.all(events.Heard) if e.text == "drive forward"]
        assert heard.speaker == "Mary"
    finally:
        ears.close()


async def test_an_answer_is_heard_while_it_is_asked_for() -> None:
    bench = Bench()
    ears = Ears(Hearing(), bench.cycle, submitting(bench))
    try:
        bench.say("the red block is next to the blue block")
        bench.say("grab the block", wait=False)
        bench.run(until=lambda: bench.cycle.mind.expecting is not None)
        await ears.play(ANSWER, "", "heard")
        assert bench.all(events.Understood)[-1].kind == "answer"
    finally:
        ears.close()


async def test_a_model_that_is_not_there_is_told(tmp_path: Path) -> None:
    bench = Bench()
    hearing = Hearing(engine="vosk", model=str(tmp_path / "no-model"))
    ears = Ears(hearing, bench.cycle, submitting(bench))
    try:
        with pytest.raises(ValueError, match="no-model"):
            await ears.play(AUDIO / "01-drive-forward.wav", "", "heard")
    finally:
        ears.close()
