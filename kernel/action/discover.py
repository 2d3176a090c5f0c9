"""Files register themselves: importing every module of a package is all it takes."""

from __future__ import annotations

import importlib
import pkgutil


def load_all(package: str) -> tuple[str, ...]:
    """Import every module directly in the package; return their names, sorted."""
    path = importlib.import_module(package).__path__
    names = sorted(f"{package}.{found.name}" for found in pkgutil.iter_modules(path))
    for name in names:
        importlib.import_module(name)
    return tuple(names)
