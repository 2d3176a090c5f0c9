"""Every key has a default, the example shows them all, and what is wrong is told with file, key and what is allowed."""

from __future__ import annotations

import itertools
import re
import tomllib
from pathlib import Path

import msgspec
import pytest

from daemon import config
from daemon.config import Config, ConfigError, load

EXAMPLE = Path(__file__).parents[2] / "docs" / "sayso.toml"


def written(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "sayso.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_the_example_as_it_is_changes_nothing() -> None:
    assert load(EXAMPLE) == Config()


def test_the_example_shows_every_key_with_its_default() -> None:
    uncommented = re.sub(r"^# (?=\w+ = )", "", EXAMPLE.read_text(encoding="utf-8"), flags=re.M)
    assert tomllib.loads(uncommented) == msgspec.to_builtins(Config())


def test_every_key_of_the_example_is_explained() -> None:
    lines = EXAMPLE.read_text(encoding="utf-8").splitlines()
    for before, line in itertools.pairwise(lines):
        if re.match(r"# \w+ = ", line):
            assert re.match(r"# (?!\w+ = )", before), line


@pytest.mark.parametrize(
    ("text", "key", "said"),
    [
        ("[robots]\n", "robots", "known here are robot, hearing"),
        ("[mind]\ntick = 30\n", "mind.tick", "known here are tick_hz"),
        ("[mind]\ntick_hz = 2\n", "mind.tick_hz", "a number of at least 5.0 and at most 200.0"),
        ("[mind]\ntick_hz = 'fast'\n", "mind.tick_hz", "a number"),
        ("[mind]\nseed = 1.5\n", "mind.seed", "a whole number of at least 0"),
        ("[mind]\nbelief_threshold = 7\n", "mind.belief_threshold", "at most 1.0"),
        ("[hearing]\nengine = 'ear'\n", "hearing.engine", "one of auto, vosk, pocketsphinx"),
        ("[speaking]\nvoice = true\n", "speaking.voice", "one of auto, silent, espeak"),
        ("robot = 'sim://forklift'\n", "robot", "must be a table"),
        ("[paths]\nstate = 3\n", "paths.state", "a text in quotes"),
    ],
)
def test_a_mistake_is_told_with_file_key_and_what_is_allowed(
    tmp_path: Path, text: str, key: str, said: str
) -> None:
    path = written(tmp_path, text)
    with pytest.raises(ConfigError) as caught:
        load(path)
    assert str(caught.value).startswith(f"{path}: {key}: ")
    assert said in str(caught.value)


@pytest.mark.parametrize(
    "content", [b"[robot\n", b"uri = \xff\xfe", b"\x00\x01", b"[mind]\nseed = 1\nseed = 2\n"]
)
def test_what_is_not_toml_is_told(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "sayso.toml"
    path.write_bytes(content)
    with pytest.raises(ConfigError, match="not TOML"):
        load(path)


def test_a_file_that_is_named_must_exist(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="cannot be read"):
        load(tmp_path / "nowhere.toml")


def test_without_a_file_the_defaults_hold(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    assert load(None) == Config()


def test_the_users_own_file_is_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    (tmp_path / "sayso").mkdir()
    written(tmp_path / "sayso", "[mind]\nseed = 7\n")
    assert load(None).mind.seed == 7


def test_the_command_line_goes_before_the_file() -> None:
    changed = config.override(Config(), robot="tcp://pi:7", hearing=None, scene="room.toml")
    assert (changed.robot.uri, changed.robot.scene) == ("tcp://pi:7", "room.toml")
    assert changed.hearing == Config().hearing


@pytest.mark.parametrize(
    ("environ", "state", "runtime"),
    [
        ({"SAYSO_STATE_DIR": "/s", "SAYSO_RUNTIME_DIR": "/r"}, "/s", "/r"),
        ({"SAYSO_STATE_DIR": "/s"}, "/s", "/s"),
        ({"STATE_DIRECTORY": "/lib/s", "RUNTIME_DIRECTORY": "/run/s:/x"}, "/lib/s", "/run/s"),
        ({"SAYSO_STATE_DIR": "/s", "STATE_DIRECTORY": "/var/lib/sayso"}, "/s", "/s"),
        ({"SAYSO_STATE_DIR": "/s", "XDG_RUNTIME_DIR": "/run/user/7"}, "/s", "/s"),
        ({"STATE_DIRECTORY": "/s", "XDG_RUNTIME_DIR": "/run/user/7"}, "/s", "/run/user/7/sayso"),
        ({"STATE_DIRECTORY": "/s"}, "/s", "/s"),
    ],
)
def test_directories_can_be_set_so_that_daemons_do_not_meet(
    environ: dict[str, str], state: str, runtime: str
) -> None:
    assert config.state_dir(Config(), environ) == Path(state)
    assert config.runtime_dir(Config(), environ) == Path(runtime)
