"""What all tests share: nothing a test does may reach the user's own directories."""

import os
import tempfile
from collections.abc import Iterator

import pytest
from hypothesis import settings

# Two cores are shared by many tests, so a slow example is no failure; CI repeats the same examples every time.
settings.register_profile("sayso", deadline=None, derandomize="CI" in os.environ)
settings.load_profile("sayso")


@pytest.fixture(scope="session", autouse=True)
def own_directories() -> Iterator[None]:
    """State, configuration and sockets lie in a temporary folder; its path is short, as a socket's must be."""
    with (
        tempfile.TemporaryDirectory(prefix="sayso-", ignore_cleanup_errors=True) as folder,
        pytest.MonkeyPatch.context() as patch,
    ):
        for variable in (
            "XDG_STATE_HOME",
            "XDG_CONFIG_HOME",
            "XDG_DATA_HOME",
            "XDG_CACHE_HOME",
            "XDG_RUNTIME_DIR",
        ):
            patch.setenv(variable, f"{folder}/{variable.lower()}")
        patch.delenv("SAYSO_STATE_DIR", raising=False)
        patch.delenv("SAYSO_RUNTIME_DIR", raising=False)
        yield
