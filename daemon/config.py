"""Configuration: one TOML file, a default for every key; what is wrong is told with file, key and what is allowed.

docs/sayso.toml shows every key with its default; a test compares the two.
"""

from __future__ import annotations

import os
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Annotated, Any, Final, Literal, get_args, get_origin, get_type_hints

import msgspec
import platformdirs
from msgspec.structs import replace

EXIT_CONFIG: Final = 78  # EX_CONFIG: systemd does not restart on it

Engine = Literal["auto", "vosk", "pocketsphinx"]
VoiceName = Literal["auto", "silent", "espeak"]
Fraction = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]


class Part(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A table of the file."""


class Robot(Part, frozen=True, forbid_unknown_fields=True):
    """[robot]: which robot, and where it is."""

    uri: str = "sim://forklift"
    scene: str = ""


class Hearing(Part, frozen=True, forbid_unknown_fields=True):
    """[hearing]: where sound comes from and what recognises it."""

    source: str = "typed"
    engine: Engine = "auto"
    model: str = ""


class Speaking(Part, frozen=True, forbid_unknown_fields=True):
    """[speaking]: how the robot is heard."""

    voice: VoiceName = "auto"
    words_per_minute: Annotated[int, msgspec.Meta(ge=80, le=450)] = 160


class MindPart(Part, frozen=True, forbid_unknown_fields=True):
    """[mind]: how it decides."""

    tick_hz: Annotated[float, msgspec.Meta(ge=5.0, le=200.0)] = 30.0
    seed: Annotated[int, msgspec.Meta(ge=0)] = 0
    belief_threshold: Fraction = 0.5
    desperate_threshold: Fraction = 0.25
    caution_threshold: Fraction = 0.2
    permission_threshold: Fraction = 0.8
    preference_threshold: Fraction = 0.2
    sharpness: Annotated[float, msgspec.Meta(ge=0.0, le=100.0)] = 1.0
    fade_s: Annotated[float, msgspec.Meta(gt=0.0, le=3600.0)] = 30.0
    depth: Annotated[int, msgspec.Meta(ge=1, le=40)] = 20
    owner: str = ""
    praise_step: Fraction = 0.1
    blame_step: Fraction = 0.2
    failure_step: Fraction = 0.1
    recovery_step: Fraction = 0.05
    belief_step: Fraction = 0.1


class Paths(Part, frozen=True, forbid_unknown_fields=True):
    """[paths]: empty means the user's own directories; SAYSO_STATE_DIR and SAYSO_RUNTIME_DIR go before both."""

    state: str = ""
    runtime: str = ""


class Config(Part, frozen=True, forbid_unknown_fields=True):
    """The whole file."""

    robot: Robot = Robot()
    hearing: Hearing = Hearing()
    speaking: Speaking = Speaking()
    mind: MindPart = MindPart()
    paths: Paths = Paths()


class ConfigError(Exception):
    """The configuration cannot be used; the message names the file, the key and the allowed values."""

    def __init__(self, path: Path | str, key: str, why: str) -> None:
        super().__init__(f"{path}: {key}: {why}" if key else f"{path}: {why}")
        self.path, self.key, self.why = path, key, why


def load(path: Path | None) -> Config:
    """Read a file; None: the user's own file where there is one, else the defaults.

    Raises:
        ConfigError: it cannot be read, is not TOML, has an unknown key or a bad value.
    """
    if path is None:
        path = default_path()
        if not path.is_file():
            return Config()
    try:
        raw = tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise ConfigError(path, "", f"cannot be read ({error.strerror})") from error
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise ConfigError(path, "", f"not TOML: {error}") from error
    for key, why in _mistakes(raw, Config):
        raise ConfigError(path, key, why)
    return msgspec.convert(raw, Config)


def override(
    config: Config, *, robot: str | None, hearing: str | None, scene: str | None
) -> Config:
    """The configuration with what the command line says instead."""
    if robot is not None:
        config = replace(config, robot=replace(config.robot, uri=robot))
    if scene is not None:
        config = replace(config, robot=replace(config.robot, scene=scene))
    if hearing is not None:
        config = replace(config, hearing=replace(config.hearing, source=hearing))
    return config


def default_path() -> Path:
    """Where the user's file is looked for."""
    return platformdirs.user_config_path("sayso") / "sayso.toml"


def state_dir(config: Config, environ: Mapping[str, str] = os.environ) -> Path:
    """Where lessons are kept: SAYSO_STATE_DIR, the file's, systemd's, the user's."""
    given = environ.get("SAYSO_STATE_DIR") or config.paths.state
    given = given or environ.get("STATE_DIRECTORY", "").partition(":")[0]
    return Path(given).expanduser() if given else platformdirs.user_state_path("sayso")


def runtime_dir(config: Config, environ: Mapping[str, str] = os.environ) -> Path:
    """Where the control socket is: SAYSO_RUNTIME_DIR, the file's, systemd's, the user's.

    Where only the state directory is set, or the user has no runtime directory, the socket lives beside the lessons:
    two daemons with two stores do not meet.
    """
    given = environ.get("SAYSO_RUNTIME_DIR") or config.paths.runtime
    given = given or environ.get("RUNTIME_DIRECTORY", "").partition(":")[0]
    if given:
        return Path(given).expanduser()
    users_own = environ.get("XDG_RUNTIME_DIR", "")
    apart = environ.get("SAYSO_STATE_DIR") or config.paths.state or not users_own
    return state_dir(config, environ) if apart else Path(users_own) / "sayso"


def model_folders() -> tuple[Path, ...]:
    """Where models for the recogniser are installed."""
    return (platformdirs.user_data_path("sayso") / "models",)


def store_path(config: Config) -> Path:
    """The lessons."""
    return state_dir(config) / "lessons.sqlite"


def socket_path(config: Config) -> Path:
    """The control socket."""
    return runtime_dir(config) / "control.sock"


def _mistakes(
    raw: Mapping[str, Any], struct: type[Part], above: str = ""
) -> Iterator[tuple[str, str]]:
    """Every wrong key with what is allowed there, in the file's order."""
    hints = get_type_hints(struct, include_extras=True)
    for name, value in raw.items():
        key = above + name
        if name not in hints:
            yield key, f"unknown key; known here are {', '.join(hints)}"
            continue
        wanted = hints[name]
        if isinstance(wanted, type) and issubclass(wanted, Part):
            if isinstance(value, dict):
                yield from _mistakes(value, wanted, f"{key}.")
            else:
                yield key, f"must be a table [{key}]"
            continue
        try:
            msgspec.convert(value, wanted)
        except msgspec.ValidationError:
            yield key, f"{value!r} is not allowed; allowed is {allowed(wanted)}"


def allowed(wanted: Any) -> str:
    """What a key may hold, for a person.

    >>> allowed(Engine), allowed(Fraction)
    ('one of auto, vosk, pocketsphinx', 'a number of at least 0.0 and at most 1.0')
    """
    if get_origin(wanted) is Literal:
        return f"one of {', '.join(map(str, get_args(wanted)))}"
    kind, *metas = get_args(wanted) if get_origin(wanted) is Annotated else (wanted,)
    kinds = {
        str: "a text in quotes",
        int: "a whole number",
        float: "a number",
        bool: "true or false",
    }
    names = {"ge": "at least", "gt": "more than", "le": "at most", "lt": "less than"}
    bounds = [
        f"{text} {bound}"
        for meta in metas
        for field, text in names.items()
        if (bound := getattr(meta, field)) is not None
    ]
    return kinds[kind] + (f" of {' and '.join(bounds)}" if bounds else "")
