"""What import-linter cannot see: files, printing, the clock and chance below daemon, and the shape of modules."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FLOORS = ("daemon", "grammars", "kernel", "firmware_proto")
PURE = FLOORS[1:]

BUILTINS = {"breakpoint", "input", "open", "print"}
CLOCKS = {"datetime.now", "datetime.utcnow", "datetime.today", "date.today"}
FILES = {
    "exists",
    "glob",
    "iterdir",
    "mkdir",
    "read_bytes",
    "read_text",
    "rglob",
    "unlink",
    "write_bytes",
    "write_text",
}
CHANCE = {"secrets", "uuid"}
LONGEST_MODULE = 300


def sources(floors: tuple[str, ...]) -> list[Path]:
    """Every Python file of the given floors."""
    return sorted(path for floor in floors for path in (ROOT / floor).rglob("*.py"))


def name(path: Path) -> str:
    """A file's path from the root of the repository."""
    return str(path.relative_to(ROOT))


def parsed(path: Path) -> ast.Module:
    """The syntax tree of a file."""
    return ast.parse(path.read_text(encoding="utf-8"))


def dotted(node: ast.expr) -> str:
    """ "a.b.c" for an attribute of a name, "" for anything else."""
    if isinstance(node, ast.Name):
        return node.id
    if isinstance(node, ast.Attribute):
        return f"{dotted(node.value)}.{node.attr}"
    return ""


def impurities(tree: ast.AST, *, package_data: bool) -> Iterator[str]:
    """What a module does that only daemon may do.

    Args:
        tree: the parsed module.
        package_data: reading files is allowed, as grammars does with importlib.resources.
    """
    for node in ast.walk(tree):
        line = f"line {getattr(node, 'lineno', 0)}"
        if isinstance(node, ast.Call):
            called = dotted(node.func)
            last = called.rpartition(".")[2]
            if called in BUILTINS:
                yield f"{line}: {called}()"
            if ".".join(called.split(".")[-2:]) in CLOCKS:
                yield f"{line}: {called}() asks the clock"
            if called in {"random.Random", "Random"} and not (node.args or node.keywords):
                yield f"{line}: an unseeded Random"
            if (
                called.startswith("random.")
                and called != "random.Random"
                and last != "SystemRandom"
            ):
                yield f"{line}: {called}() is chance of the module's own"
            if called in {"random.SystemRandom", "os.urandom", "os.getenv"}:
                yield f"{line}: {called}()"
            if (
                isinstance(node.func, ast.Attribute)
                and node.func.attr in FILES
                and not package_data
            ):
                yield f"{line}: .{node.func.attr}() touches a file"
        if isinstance(node, ast.Attribute) and dotted(node) in {
            "os.environ",
            "sys.argv",
            "sys.stdin",
            "sys.stdout",
        }:
            yield f"{line}: {dotted(node)}"
        if (
            isinstance(node, ast.ImportFrom)
            and node.module == "random"
            and {a.name for a in node.names} != {"Random"}
        ):
            yield f"{line}: from random only Random"
        if isinstance(node, ast.Import | ast.ImportFrom):
            imported = (
                [a.name for a in node.names]
                if isinstance(node, ast.Import)
                else [node.module or ""]
            )
            if CHANCE & {module.partition(".")[0] for module in imported}:
                yield f"{line}: {imported}"


def test_below_daemon_no_files_no_clock_no_chance() -> None:
    found = {
        name(path): list(
            impurities(parsed(path), package_data=path.is_relative_to(ROOT / "grammars"))
        )
        for path in sources(PURE)
    }
    assert {path: what for path, what in found.items() if what} == {}


@pytest.mark.parametrize(
    "code",
    [
        "print('x')",
        "open('f')",
        "input()",
        "import datetime\ndatetime.datetime.now()",
        "from datetime import datetime\ndatetime.now()",
        "import random\nrandom.random()",
        "import random\nrandom.Random()",
        "from random import choice",
        "from random import Random\nRandom()",
        "import uuid",
        "import os\nos.environ['HOME']",
        "from pathlib import Path\nPath('f').read_text()",
    ],
)
def test_an_impurity_is_seen(code: str) -> None:
    assert list(impurities(ast.parse(code), package_data=False))


def test_a_seeded_source_is_no_impurity() -> None:
    code = "import random\ndef f(chance: random.Random):\n    return chance.choice([1]), random.Random(3)"
    assert list(impurities(ast.parse(code), package_data=False)) == []


def test_no_bare_except() -> None:
    bare = [
        f"{name(path)}:{node.lineno}"
        for path in sources(FLOORS)
        for node in ast.walk(parsed(path))
        if isinstance(node, ast.ExceptHandler) and node.type is None
    ]
    assert bare == []


def test_modules_are_short() -> None:
    lengths = {
        name(path): len(path.read_text(encoding="utf-8").splitlines()) for path in sources(FLOORS)
    }
    assert {path: lines for path, lines in lengths.items() if lines > LONGEST_MODULE} == {}


@pytest.mark.parametrize("floor", FLOORS)
def test_a_root_holds_a_docstring_and_no_code(floor: str) -> None:
    tree = parsed(ROOT / floor / "__init__.py")
    assert ast.get_docstring(tree)
    assert len(tree.body) == 1
