"""The demonstration, played: as shipped it holds; with anything wrong in it it fails."""

import io
import re
import shutil
from pathlib import Path

import pytest
from rich.console import Console

from daemon.demo.live import LiveError
from daemon.demo.run import main
from daemon.demo.script import AUDIO, SCRIPT, script, spoken


def lines_up_to(last: str) -> str:
    """The script up to an input line and what is expected of it."""
    kept: list[str] = []
    found = False
    for line in SCRIPT.read_text().splitlines():
        if found and not line.startswith("robot:"):
            break
        kept.append(line)
        found = found or line == last
    assert found
    return "\n".join(kept) + "\n"


class Stage:
    """A folder with a shortened script and its recordings."""

    def __init__(self, folder: Path) -> None:
        self.path, self.audio = folder / "paper.txt", folder / "audio"
        self.told = io.StringIO()
        shutil.copytree(AUDIO, self.audio)

    def play(self, text: str, **options: bool | str) -> int:
        self.path.write_text(text)
        console = Console(file=self.told, width=200)
        return main(path=self.path, audio=self.audio, console=console, **options)  # type: ignore[arg-type]


@pytest.fixture
def stage(tmp_path: Path) -> Stage:
    return Stage(tmp_path)


SHIMMY = "you: To shimmy turn left then turn right"


def test_typed_in_virtual_time_every_line_goes_as_expected(tmp_path: Path) -> None:
    told, picture = io.StringIO(), tmp_path / "demo.svg"
    console = Console(file=told, width=200)
    assert main(fast=True, typed=True, console=console, picture=picture) == 0
    assert "24 of 24 lines went as expected" in told.getvalue()
    assert "\x1b" not in told.getvalue()  # plain lines where there is no terminal
    assert "cha-cha" in picture.read_text()


@pytest.mark.timeout(240)  # about 20 s, but machines may be busy
@pytest.mark.parametrize("engine", ["vosk", pytest.param("pocketsphinx", marks=pytest.mark.long)])
def test_heard_in_virtual_time_every_line_goes_as_expected(engine: str) -> None:
    told = io.StringIO()
    status = main(fast=True, engine=engine, console=Console(file=told, width=200))
    assert status == 0, told.getvalue()


@pytest.mark.timeout(120)
@pytest.mark.parametrize("typed", [True, False], ids=["typed", "heard"])
def test_in_real_time_over_the_pty(stage: Stage, typed: bool) -> None:
    status = stage.play(lines_up_to(SHIMMY), typed=typed)
    assert status == 0, stage.told.getvalue()


def test_in_real_time_a_cut_pty_stops_the_wheels_and_is_survived(stage: Stage) -> None:
    text = """
        you: drive forward for one meter
        wait: 1 s
        robot: moves forward 10..30 cm
        link: down
        wait: 1 s
        robot: moves forward 0..12 cm
        wait: 0.5 s
        robot: does not move
        link: up
        wait: 4 s
        you: turn left
        robot: turns left 80..100 degrees
    """
    assert stage.play(text, typed=True) == 0, stage.told.getvalue()


def test_a_restart_cannot_be_played_in_real_time(stage: Stage) -> None:
    with pytest.raises(LiveError, match="restart"):
        stage.play("you: stop\nrestart:\n", typed=True)


def test_two_recordings_swapped_make_it_fail(stage: Stage) -> None:
    names = list(spoken(script()).values())
    first, second = stage.audio / names[1], stage.audio / names[2]
    kept = first.read_bytes()
    first.write_bytes(second.read_bytes())
    second.write_bytes(kept)
    assert stage.play(lines_up_to(SHIMMY), fast=True) == 1
    assert "MISHEARD" in stage.told.getvalue()


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("moves forward 18..22 cm", "moves backward 18..22 cm"),
        ("moves forward 18..22 cm", "does not move"),
        ("acknowledges; does not move", "refuses; does not move"),
    ],
)
def test_an_expectation_flipped_makes_it_fail(stage: Stage, right: str, wrong: str) -> None:
    text = lines_up_to(SHIMMY)
    assert stage.play(text, fast=True, typed=True) == 0
    assert stage.play(text.replace(right, wrong, 1), fast=True, typed=True) == 1
    assert "FAILED" in stage.told.getvalue()


FLIPS = {
    "acknowledges": "asks",
    "refuses": "acknowledges",
    "does not move": "lifts",
    "forward": "backward",
    "backward": "forward",
    "left": "right",
    "right": "left",
    "closes": "opens",
}


def flipped(line: str) -> str:
    return re.sub("|".join(FLIPS), lambda found: FLIPS[found[0]], line)


def test_every_line_is_checked_with_all_flipped_none_holds(stage: Stage) -> None:
    lines = SCRIPT.read_text().splitlines()
    text = "\n".join(flipped(line) if line.startswith("robot:") else line for line in lines)
    assert stage.play(text, fast=True, typed=True) == 1
    assert "0 of 24 lines" in stage.told.getvalue()
