"""One thing, one file: every file of a package that is discovered by file registers something."""

from collections.abc import Callable, Iterable
from pathlib import Path
from types import ModuleType

import pytest

import grammars.forms
import grammars.registry
import grammars.replies
import kernel.answering
import kernel.bodies
import kernel.bodies.registry
import kernel.directives
import kernel.grounding
from kernel.action.call import GROUNDINGS
from kernel.action.discover import load_all
from kernel.action.sensing import SENSES
from kernel.action.step import DIRECTIVES
from kernel.asking import ANSWERS


def directives() -> Iterable[object]:
    load_all("kernel.directives")
    return DIRECTIVES.values()


def groundings() -> Iterable[object]:
    load_all("kernel.grounding")
    return [*(found.code for found in GROUNDINGS.values()), *SENSES.values()]


def answers() -> Iterable[object]:
    load_all("kernel.answering")
    return ANSWERS.values()


def forms() -> Iterable[object]:
    return [form.build for form in grammars.registry.discover().values()]


def replies() -> Iterable[object]:
    return grammars.replies.discover().values()


@pytest.mark.parametrize(
    ("package", "registered"),
    [
        (kernel.directives, directives),
        (kernel.grounding, groundings),
        (kernel.answering, answers),
        (grammars.forms, forms),
        (grammars.replies, replies),
    ],
)
def test_every_file_registers_something(
    package: ModuleType, registered: Callable[[], Iterable[object]]
) -> None:
    (folder,) = package.__path__
    files = {
        f"{package.__name__}.{path.stem}"
        for path in Path(folder).glob("*.py")
        if path.stem != "__init__"
    }
    assert files
    assert files <= {code.__module__ for code in registered()}


def test_every_folder_of_bodies_holds_one() -> None:
    (folder,) = kernel.bodies.__path__
    folders = {f"kernel.bodies.{path.parent.name}" for path in Path(folder).glob("*/__init__.py")}
    bodies = [kernel.bodies.registry.make(name) for name in kernel.bodies.registry.names()]
    assert folders
    assert folders == {type(body).__module__.rpartition(".")[0] for body in bodies}


def test_every_sentence_form_is_a_pair() -> None:
    (folder,) = grammars.forms.__path__
    rules = {path.stem for path in Path(folder).glob("*.lark")}
    builders = {path.stem for path in Path(folder).glob("*.py")} - {"__init__"}
    assert rules == builders
