"""The subjects: each module here is one, found by looking."""

from __future__ import annotations

import importlib
import pkgutil
from typing import Any, Protocol, cast

from benchmarks.measuring import Row


class Subject(Protocol):
    """What a module here offers: sizes for a real run and for a quick look, and the measurement."""

    TITLE: str
    FULL: Any
    TINY: Any

    def run(self, size: Any, *, peers: bool) -> list[Row]:
        """Measures; without `peers` only ours."""


def subjects() -> dict[str, Subject]:
    """All subjects by name, in the order of their names."""
    return {
        found.name: cast("Subject", importlib.import_module(f"{__name__}.{found.name}"))
        for found in pkgutil.iter_modules(__path__)
    }
