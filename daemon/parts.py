"""Putting the cycle together: with a real link for the daemon, with a virtual one where nobody is to wait."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Generic, TypeVar

from daemon import events
from daemon.config import Config, MindPart
from daemon.link import Link, open_link
from daemon.link.virtual import VirtualLink
from daemon.loop import Cycle, Wire
from daemon.speaking.choice import choose
from daemon.speaking.silent import SilentVoice
from daemon.speaking.voice import Voice
from daemon.store import Loaded, Store
from daemon.writer import AtOnce, Keeper
from kernel.bodies import registry
from kernel.bodies.forklift import scene
from kernel.bodies.forklift.scene import Scene
from kernel.memory.lesson import Lesson
from kernel.mind import Mind

L = TypeVar("L", bound=Wire)


@dataclass(frozen=True, slots=True)
class Parts(Generic[L]):
    """A cycle and what it was made of."""

    cycle: Cycle
    link: L
    loaded: Loaded


def make_mind(settings: MindPart, lessons: tuple[Lesson, ...]) -> Mind:
    """A fresh mind with these lessons in force."""
    return Mind(lessons, settings.seed)


def make_cycle(
    config: Config,
    loaded: Loaded,
    link: Wire,
    voice: Voice,
    keeper: Keeper,
    emit: Callable[[events.Event], None],
) -> Cycle:
    """The one way a cycle is put together."""
    return Cycle(
        mind=make_mind(config.mind, loaded.lessons),
        body=registry.make(body_name(config.robot.uri)),
        link=link,
        voice=voice,
        keeper=keeper,
        emit=emit,
    )


def assemble(
    config: Config, store: Store, keeper: Keeper, emit: Callable[[events.Event], None]
) -> Parts[Link]:
    """For the daemon: the link opens a port once it is served.

    Raises:
        PortError: the robot's address means nothing.
        SceneError, OSError: the scene cannot be read.
    """
    link = open_link(config.robot.uri, scene=_scene(config))
    loaded = store.load()
    cycle = make_cycle(config, loaded, link, choose(config.speaking), keeper, emit)
    return Parts(cycle, link, loaded)


def assemble_virtual(
    config: Config, store: Store, emit: Callable[[events.Event], None]
) -> Parts[VirtualLink]:
    """For one utterance without a daemon: simulated robot, silent voice, virtual time."""
    link = VirtualLink(scene=_scene(config), seed=config.mind.seed)
    loaded = store.load()
    cycle = make_cycle(config, loaded, link, SilentVoice(), AtOnce(store), emit)
    return Parts(cycle, link, loaded)


def body_name(uri: str) -> str:
    """The body at an address: sim://name, or the part after "#"; the forklift where none is named.

    >>> body_name("sim://forklift?faults=hc05"), body_name("serial:/dev/ttyUSB0#forklift")
    ('forklift', 'forklift')
    """
    before, _, named = uri.partition("#")
    if named:
        return named
    if before.startswith("sim://"):
        return before.removeprefix("sim://").partition("?")[0].rstrip("/") or "forklift"
    return "forklift"


def _scene(config: Config) -> Scene | None:
    if not config.robot.scene:
        return None
    return scene.read(Path(config.robot.scene).read_text(encoding="utf-8"))
