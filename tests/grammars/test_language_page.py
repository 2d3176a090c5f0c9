"""docs/language.md is what the forms make it, and says something of every one of them."""

from __future__ import annotations

import runpy
from pathlib import Path

import pytest

from grammars.registry import discover

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs/language.md").read_text("utf8")


@pytest.mark.timeout(60)
def test_the_page_is_what_the_script_makes_of_the_forms() -> None:
    made = runpy.run_path(str(ROOT / "scripts/compile_language_page.py"))["page"]()
    assert made == PAGE, "run scripts/compile_language_page.py"


def test_every_kind_has_a_section_and_every_example_stands_there() -> None:
    for form in discover().values():
        assert f"\n## {form.kind.capitalize()}\n" in PAGE
        assert all(f" {example}" in PAGE for example in form.examples)
