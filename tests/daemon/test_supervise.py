"""A part that fails comes back, is reported once, and takes nothing with it."""

from __future__ import annotations

import asyncio

import pytest

from daemon.supervise import supervise


async def test_a_failing_part_is_started_again_and_told_once() -> None:
    starts: list[int] = []
    told: list[tuple[str, str]] = []

    async def part() -> None:
        starts.append(1)
        if len(starts) < 4:
            raise OSError("the microphone is gone")

    async with asyncio.timeout(5):
        await supervise("hearing", part, lambda *args: told.append(args), first_wait_s=0.001)
    assert len(starts) == 4
    assert told == [("hearing", "the microphone is gone")]


async def test_another_reason_is_told_again() -> None:
    reasons = iter(["no port", "no port", "no answer", "no port"])
    told: list[str] = []

    async def part() -> None:
        for reason in reasons:
            raise OSError(reason)

    await supervise("link", part, lambda _, why: told.append(why), first_wait_s=0.001)
    assert told == ["no port", "no answer", "no port"]


async def test_cancelling_ends_it_even_while_it_waits() -> None:
    async def part() -> None:
        raise OSError("no")

    task = asyncio.create_task(supervise("link", part, lambda *_: None, first_wait_s=60))
    await asyncio.sleep(0)
    task.cancel()
    with pytest.raises(asyncio.CancelledError):
        await task


async def test_waits_grow_and_are_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    waits: list[float] = []
    failures = iter(range(7))

    async def sleep(seconds: float) -> None:
        waits.append(seconds)

    async def part() -> None:
        for number in failures:
            raise OSError(str(number))

    monkeypatch.setattr("daemon.supervise.asyncio.sleep", sleep)
    await supervise("link", part, lambda *_: None, first_wait_s=0.5, longest_wait_s=10)
    assert waits == [0.5, 1, 2, 4, 8, 10, 10]
