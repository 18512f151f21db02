"""Build hook: the page of `web/` becomes part of the package, for wheel, sdist and editable install alike.

Node is asked for only when the page is stale. An sdist carries the built page, so installing from it, or
from a wheel, never needs Node.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

sys.path.insert(0, str(Path(__file__).resolve().parent))

from tools import page


class PageBuildHook(BuildHookInterface):  # type: ignore[type-arg]
    """Brings the page up to date before anything is packed."""

    def dependencies(self) -> list[str]:
        """What the build needs besides hatchling; asked before `initialize`."""
        return [] if page.is_current() else [page.NODE_REQUIREMENT]

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Build the page if it is stale."""
        page.build()
