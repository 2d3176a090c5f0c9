"""The wheel is whole: it holds its data files and works from another folder, with nothing of the checkout in reach."""

import json
import os
import subprocess
import sys
import sysconfig
import venv
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
FLOORS = ("daemon", "grammars", "kernel", "firmware_proto")

# Every file that is no Python but that the program reads is in one of these places.
DATA = [
    "grammars/*.lark",
    "grammars/forms/*.lark",
    "grammars/words/*.txt",
    "grammars/knowledge/*.txt",
    "grammars/knowledge/*.net",
    "daemon/demo/**/*.txt",
    "daemon/demo/audio/*.wav",
    "daemon/hearing/models/vosk-tiny/**/*",
]

pytestmark = pytest.mark.timeout(180)  # the fixtures build and install


def python(*arguments: str) -> None:
    """Runs this Python; what it printed is shown if it fails."""
    result = subprocess.run(
        [sys.executable, *arguments], capture_output=True, text=True, timeout=120
    )
    assert result.returncode == 0, result.stdout + result.stderr


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel, built from the checkout."""
    folder = tmp_path_factory.mktemp("wheel")
    python(
        "-m",
        "pip",
        "wheel",
        "-q",
        "--no-deps",
        "--no-index",
        "--no-build-isolation",
        "-w",
        str(folder),
        str(ROOT),
    )
    (built,) = folder.glob("sayso-*.whl")
    return built


@pytest.fixture(scope="module")
def sayso(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The command, installed from the wheel into an environment that borrows nothing but the libraries of this one."""
    folder = tmp_path_factory.mktemp("installed")
    venv.create(folder, with_pip=False)
    (site,) = folder.glob("lib/python*/site-packages")
    (site / "libraries.pth").write_text(sysconfig.get_path("purelib"), encoding="utf-8")
    into = (
        "-m",
        "pip",
        "--python",
        str(folder / "bin" / "python"),
        "install",
        "-q",
        "--no-deps",
        "--no-index",
    )
    python(*into, "--ignore-installed", str(wheel))
    return folder / "bin" / "sayso"


def call(command: Path, folder: Path, *words: str) -> str:
    """Runs the installed command in another folder; returns what it printed."""
    result = subprocess.run(
        [str(command), *words],
        cwd=folder,
        env={"PATH": os.environ["PATH"], "HOME": str(folder), "TERM": "dumb"},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


@pytest.mark.parametrize("pattern", DATA)
def test_the_wheel_holds_the_data(wheel: Path, pattern: str) -> None:
    wanted = {path.relative_to(ROOT).as_posix() for path in ROOT.glob(pattern) if path.is_file()}
    assert wanted, f"the checkout has no {pattern}"
    with zipfile.ZipFile(wheel) as archive:
        assert wanted <= set(archive.namelist())


def test_the_wheel_holds_the_four_packages_and_nothing_else(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        tops = {Path(entry).parts[0] for entry in archive.namelist()}
    assert {top for top in tops if not top.endswith(".dist-info")} == set(FLOORS)


def test_the_installed_command_is_not_the_checkout(sayso: Path, tmp_path: Path) -> None:
    code = "import daemon, kernel; print(daemon.__file__, kernel.__file__)"
    printed = call(sayso.with_name("python"), tmp_path, "-c", code)
    assert str(ROOT) not in printed


def test_it_parses_in_another_folder(sayso: Path, tmp_path: Path) -> None:
    answer = json.loads(call(sayso, tmp_path, "parse", "--json", "drive forward"))
    assert answer["kind"] == "command"


def test_it_demonstrates_in_another_folder(sayso: Path, tmp_path: Path) -> None:
    call(sayso, tmp_path, "demo", "--fast", "--typed")
