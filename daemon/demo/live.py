"""The demonstration in real time: the daemon itself, sound at its own pace, the simulated robot behind a PTY."""

from __future__ import annotations

import asyncio
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Final

from daemon.acts import Act, acts
from daemon.app import App
from daemon.config import Config, Hearing, MindPart, Robot, Speaking
from daemon.demo.result import Result, result
from daemon.demo.show import Show
from daemon.dialogue import Dialogue, Insert, LinkSwitch, Place, Remove, Restart, You
from daemon.recorder import SAMPLE_S, Recorder, change, sample
from daemon.store import Store
from kernel.bodies.forklift.simulated import World

SETTLE_S: Final = 0.25
"""Idle for so long is idle: a sensor's next report, and what the mind makes of it, come within that."""
LOOK_S: Final = 0.02
AT_MOST_S: Final = 60.0
CONNECT_S: Final = 5.0


class LiveError(Exception):
    """The demonstration cannot be played in real time; the message says why."""


def play(
    demonstration: Dialogue, sounds: dict[int, Path], show: Show, engine: str, seed: int
) -> list[Result]:
    """Play every line; a store and a socket of its own, so that a running daemon is left alone.

    Args:
        demonstration: the script.
        sounds: recordings by line; lines without one are typed.
        show: told of everything.
        engine: of the recogniser.
        seed: of the mind's choices.

    Raises:
        LiveError: the robot could not be reached, or the daemon ended early.
    """
    config = Config(
        robot=Robot(uri="sim://forklift"),
        hearing=Hearing(source="", engine=engine),  # type: ignore[arg-type]  # one of the three, from the command line
        speaking=Speaking(voice="silent"),
        mind=MindPart(seed=seed),
    )
    with TemporaryDirectory(prefix="sayso-demo-") as folder, _living_in(folder):
        return asyncio.run(_play(config, Path(folder), demonstration, sounds, show))


async def _play(
    config: Config, folder: Path, demonstration: Dialogue, sounds: dict[int, Path], show: Show
) -> list[Result]:
    app = App(config, Store.open(folder / "lessons.sqlite"), lambda _line: None)
    recorder = Recorder(show.move)
    app.subscribe(recorder.happen)
    hush = app.subscribe(show.happen)
    serving = asyncio.create_task(app.run(), name="demo.daemon")
    playing = asyncio.create_task(_lines(app, recorder, demonstration, sounds, show))
    try:
        await asyncio.wait((serving, playing), return_when=asyncio.FIRST_COMPLETED)
        if not playing.done():
            await serving
            raise LiveError("the daemon ended before the demonstration did")
        return await playing
    finally:
        playing.cancel()
        hush()
        app.close()
        await serving


async def _lines(
    app: App, recorder: Recorder, demonstration: Dialogue, sounds: dict[int, Path], show: Show
) -> list[Result]:
    world = await _world(app)
    show.things = lambda: world.things
    recorder.begin(sample(world, app.now_s))
    going: set[asyncio.Task[object]] = {asyncio.create_task(_sample(app, world, recorder))}
    results = []
    try:
        for act in acts(demonstration.steps):
            line = demonstration.lines[act.step.line] if act.step else ""
            show.enter(line)
            vocabulary = app.cycle.vocabulary
            recorder.begin(sample(world, app.now_s))
            await _perform(act, app, world, sounds, going)
            turn = recorder.turn(sample(world, app.now_s))
            results.append(result(act, line, turn, vocabulary))
            show.judge(results[-1])
    finally:
        for task in going:
            task.cancel()
    return results


async def _perform(
    act: Act, app: App, world: World, sounds: dict[int, Path], going: set[asyncio.Task[object]]
) -> None:
    """Play the act's line, and let its time pass. going: keeps what goes on after that time."""
    speaking: asyncio.Task[object] | None = None
    match act.step:
        case You(line=line) if line in sounds:
            speaking = asyncio.create_task(app.hear(sounds[line], "", "demo"))
        case You(text=text, speaker=speaker):
            speaking = asyncio.create_task(app.say(text, speaker or "", "demo"))
        case Place() | Insert() | Remove() as step:
            change(world, step)
        case LinkSwitch(up=up):
            (app.link.restore if up else app.link.cut)()
        case Restart():
            raise LiveError("restart: is for rehearsals; this daemon keeps running")
    if act.seconds is None:
        if speaking is not None:
            await speaking
        await _idle(app)
        return
    await asyncio.sleep(act.seconds)
    if speaking is not None and not speaking.done():
        going.add(speaking)


async def _idle(app: App) -> None:
    """Until nothing has been going on for a while."""
    end_s = app.now_s + AT_MOST_S
    busy_s = app.now_s
    while app.now_s < end_s and app.now_s - busy_s < SETTLE_S:
        await asyncio.sleep(LOOK_S)
        if not app.cycle.idle:
            busy_s = app.now_s


async def _world(app: App) -> World:
    """The simulated robot's world, once the link is up."""
    end_s = app.now_s + CONNECT_S
    while app.now_s < end_s:
        if app.link.connected and app.link.simulated is not None:
            return app.link.simulated.world
        await asyncio.sleep(LOOK_S)
    raise LiveError(f"no link to the simulated robot within {CONNECT_S:.0f} s: {app.link.detail}")


async def _sample(app: App, world: World, recorder: Recorder) -> None:
    while True:
        recorder.move(sample(world, app.now_s))
        await asyncio.sleep(SAMPLE_S)


@contextmanager
def _living_in(folder: str) -> Iterator[None]:
    """State and runtime directories in a folder, whatever the environment says."""
    names = ("SAYSO_STATE_DIR", "SAYSO_RUNTIME_DIR")
    before = {name: os.environ.get(name) for name in names}
    os.environ.update(dict.fromkeys(names, folder))
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value
