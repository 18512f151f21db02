"""The subjects: each module here is one, found by looking."""

from __future__ import annotations

import importlib
import pkgutil
from typing import Any, Protocol, cast

from benchmarks.measurement import Row


class Subject(Protocol):
    """What a module here offers: sizes for a real run and for a quick look, and the measurement."""

    TITLE: str
    FULL: Any
    TINY: Any

    def run(self, size: Any, *, peers: bool) -> list[Row]:
        """Measures; without `peers` only ours."""


def names() -> list[str]:
    """The names of all subjects, in their order; nothing is imported."""
    return [found.name for found in pkgutil.iter_modules(__path__)]


def subject(name: str) -> Subject:
    """The subject of a name that is there."""
    return cast("Subject", importlib.import_module(f"{__name__}.{name}"))
