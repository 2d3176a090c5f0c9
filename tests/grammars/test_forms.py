"""Every form understands its own examples, as its own kind."""

from __future__ import annotations

import pytest

from grammars.parse import parse
from grammars.registry import discover

EXAMPLES = [
    pytest.param(form.name, form.kind, example, id=f"{form.name}: {example}")
    for form in discover().values()
    if not form.expected  # tests/grammars/test_choice.py
    for example in form.examples
]


@pytest.mark.parametrize(("name", "kind", "example"), EXAMPLES)
def test_an_example_is_read_as_its_form(name: str, kind: str, example: str) -> None:
    parsed = parse(example)
    assert parsed.kind == kind
    assert parsed.alist.has(name)
    assert not parsed.repaired


def test_every_file_registers_a_form_and_every_form_has_examples() -> None:
    from importlib.resources import files

    folder = files("grammars").joinpath("forms")
    names = {p.name.removesuffix(".lark") for p in folder.iterdir() if p.name.endswith(".lark")}
    modules = {p.name.removesuffix(".py") for p in folder.iterdir() if p.name.endswith(".py")}
    assert names == modules - {"__init__"} == set(discover())
    assert all(form.examples for form in discover().values())
