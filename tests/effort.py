"""How much is tried at random: little by default, much where it is asked for (`CONTRIBUTING.md`, make test)."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TypeVar

import hypothesis

THOROUGH = bool(os.environ.get("KITROBOT_THOROUGH"))
"""Whether all of a sweep is tried, not only a sample of it."""


Case = TypeVar("Case")


def cases(usual: Sequence[Case], more: Sequence[Case]) -> list[Case]:
    """The cases that a test is tried on: the usual ones, in the thorough profile the others too."""
    return [*usual, *(more if THOROUGH else ())]


def examples(few: int, many: int = 0) -> int:
    """`max_examples` of a test whose examples are dear: `few`, or in the thorough profile `many` or that profile's."""
    usual = hypothesis.settings().max_examples
    return few if usual < 100 else many or usual
