"""Putting the cycle together: with a real link for the daemon, with a virtual one where nobody is to wait."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Generic, TypeVar

from daemon import events
from daemon.clock import Clock
from daemon.config import Config, ConfigError, MindPart
from daemon.link import Link, open_link
from daemon.link.port import AddressError
from daemon.link.virtual import VirtualLink
from daemon.loop import Cycle
from daemon.speaking.choice import NoVoiceError, choose
from daemon.speaking.silent import SilentVoice
from daemon.speaking.voice import Voice
from daemon.store import Loaded, Store
from daemon.wire import Wire
from daemon.writer import AtOnce, Keeper
from grammars.knowledge import born
from kernel.action.call import GROUNDINGS
from kernel.action.discover import load_all
from kernel.bodies import registry
from kernel.bodies.forklift import scene
from kernel.bodies.forklift.scene import Scene, SceneError
from kernel.memory.settings import Settings
from kernel.mind import Mind

L = TypeVar("L", bound=Wire)


@dataclass(frozen=True, slots=True)
class Parts(Generic[L]):
    """A cycle and what it was made of."""

    cycle: Cycle
    link: L
    loaded: Loaded


def make_mind(settings: MindPart, loaded: Loaded, utc_offset_s: float = 0.0) -> Mind:
    """A fresh mind with what it is born knowing, and what the journal says it learned."""
    numbers = Settings(
        threshold=settings.belief_threshold,
        desperate_threshold=settings.desperate_threshold,
        prohibition_threshold=settings.caution_threshold,
        permission_threshold=settings.permission_threshold,
        least_preference=settings.preference_threshold,
        sharpness=settings.sharpness,
        fade_s=settings.fade_s,
        depth=settings.depth,
        utc_offset_s=utc_offset_s,
        owner=settings.owner,
        praise_step=settings.praise_step,
        blame_step=settings.blame_step,
        failure_step=settings.failure_step,
        recovery_step=settings.recovery_step,
        belief_step=settings.belief_step,
    )
    return Mind(born(), settings.seed, numbers, loaded.changes, loaded.resting)


def make_cycle(
    config: Config,
    loaded: Loaded,
    link: Wire,
    voice: Voice,
    keeper: Keeper,
    emit: Callable[[events.Event], None],
    utc_offset_s: float = 0.0,
) -> Cycle:
    """The one way a cycle is put together."""
    return Cycle(
        mind=make_mind(config.mind, loaded, utc_offset_s),
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
        ConfigError: the robot's address or scene, or the voice, means nothing or is not there.
    """
    try:
        link = open_link(config.robot.uri, _scene(config))
    except AddressError as error:
        raise ConfigError("configuration", "robot.uri", str(error)) from error
    try:
        voice = choose(config.speaking)
    except NoVoiceError as error:
        raise ConfigError("configuration", "speaking.voice", str(error)) from error
    loaded = store.load(abilities())
    cycle = make_cycle(config, loaded, link, voice, keeper, emit, Clock.utc_offset_s())
    return Parts(cycle, link, loaded)


def assemble_virtual(
    config: Config,
    store: Store,
    emit: Callable[[events.Event], None],
    utc_offset_s: float = 0.0,
) -> Parts[VirtualLink]:
    """For one utterance without a daemon: simulated robot, silent voice, virtual time.

    utc_offset_s: of the clock on the wall, where utterances are dated by it.

    Raises:
        ConfigError: the scene is not there or means nothing.
    """
    link = VirtualLink(_scene(config), config.mind.seed)
    loaded = store.load(abilities())
    cycle = make_cycle(config, loaded, link, SilentVoice(), AtOnce(store), emit, utc_offset_s)
    return Parts(cycle, link, loaded)


def abilities() -> frozenset[str]:
    """Names of the grounding functions there are."""
    load_all("kernel.grounding")
    return frozenset(GROUNDINGS)


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
    try:
        return scene.read(Path(config.robot.scene).read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, SceneError) as error:
        raise ConfigError(config.robot.scene, "robot.scene", str(error)) from error
