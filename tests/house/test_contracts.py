"""The import contracts of pyproject.toml hold, and each of them would notice a bad import."""

import shutil
import subprocess
import sys
import tomllib
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FLOORS = ("daemon", "grammars", "kernel", "firmware_proto")

# One bad import for each contract: contract, module that breaks it, what it imports.
BAD_IMPORTS = [
    ("floors", "firmware_proto/frame.py", "kernel.errors"),
    ("floors", "kernel/memory/lesson.py", "grammars.parse"),
    ("floors", "grammars/parse.py", "daemon.config"),
    ("pure", "kernel/mind.py", "time"),
    ("pure", "grammars/parse.py", "asyncio"),
    ("pure", "firmware_proto/session.py", "serial"),
    ("kernel", "kernel/net/graphlet.py", "kernel.memory.lesson"),
    ("kernel", "kernel/directives/do.py", "kernel.grounding.base"),
    ("kernel", "kernel/stray.py", "kernel.errors"),
    ("wire", "kernel/grounding/base.py", "firmware_proto.messages"),
    ("wire", "grammars/parse.py", "firmware_proto.messages"),
    ("directives", "kernel/directives/do.py", "kernel.directives.note"),
    ("grounding", "kernel/grounding/base.py", "kernel.grounding.fork"),
    ("forms", "grammars/forms/fact.py", "grammars.forms.question"),
    ("lark", "grammars/render.py", "lark"),
    ("pymunk", "kernel/bodies/forklift/body.py", "pymunk.vec2d"),
    ("prompt_toolkit", "daemon/control/cli.py", "prompt_toolkit"),
    ("pyserial", "daemon/control/cli.py", "serial.tools.list_ports"),
    ("sounddevice", "daemon/control/cli.py", "sounddevice"),
    ("vosk", "daemon/control/cli.py", "vosk"),
    ("pocketsphinx", "daemon/control/cli.py", "pocketsphinx"),
]


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the Python files of the four floors, to plant in."""
    copy = tmp_path_factory.mktemp("house")
    shutil.copy(ROOT / "pyproject.toml", copy)
    for floor in FLOORS:
        for source in (ROOT / floor).rglob("*.py"):
            target = copy / source.relative_to(ROOT)
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, target)
    return copy


@pytest.fixture
def plant(house: Path) -> Callable[[str, str], None]:
    """Adds an import to one module of the copy until the test ends."""
    undo: list[tuple[Path, str | None]] = []

    def add(module: str, imported: str) -> None:
        path = house / module
        before = path.read_text(encoding="utf-8") if path.exists() else None
        undo.append((path, before))
        path.write_text(f"{before or ''}\nimport {imported}\n", encoding="utf-8")

    yield add
    for path, before in undo:
        if before is None:
            path.unlink()
        else:
            path.write_text(before, encoding="utf-8")


def lint(folder: Path, *options: str) -> subprocess.CompletedProcess[str]:
    """lint-imports in a folder, as ./run lint calls it."""
    command = [str(Path(sys.executable).parent / "lint-imports"), "--no-logo", *options]
    return subprocess.run(
        command, cwd=folder, env={"PYTHONPATH": str(folder)}, capture_output=True, text=True
    )


def test_every_contract_is_kept() -> None:
    result = lint(ROOT)
    assert result.returncode == 0, result.stdout + result.stderr


def test_every_contract_has_a_bad_import() -> None:
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    contracts = {contract["id"] for contract in settings["tool"]["importlinter"]["contracts"]}
    assert contracts == {contract for contract, _, _ in BAD_IMPORTS}


@pytest.mark.parametrize(("contract", "module", "imported"), BAD_IMPORTS, ids="{}".format)
def test_a_bad_import_breaks_its_contract(
    house: Path, plant: Callable[[str, str], None], contract: str, module: str, imported: str
) -> None:
    plant(module, imported)
    result = lint(house, "--contract", contract)
    assert result.returncode == 1, result.stdout + result.stderr
    assert "1 broken" in result.stdout, result.stdout
