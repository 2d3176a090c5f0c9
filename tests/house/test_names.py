"""Folder names are import names, so this distribution alone must own them."""

from importlib import import_module
from importlib.metadata import packages_distributions
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize("floor", ["daemon", "grammars", "kernel", "firmware_proto"])
def test_this_distribution_alone_owns_the_name(floor: str) -> None:
    """PyPI's python-daemon, for one, installs a top-level ``daemon`` too."""
    assert set(packages_distributions().get(floor, ["sayso"])) == {"sayso"}
    assert import_module(floor).__file__ == str(ROOT / floor / "__init__.py")
