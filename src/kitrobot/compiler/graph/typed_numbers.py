"""Whole numbers as people type them into settings of vertices."""

from __future__ import annotations

import re

_WHOLE = re.compile(r"[+-]?[0-9]{1,9}")
_MOST_DIGITS = 5


def typed_number(text: str, low: int, high: int) -> int | None:
    """The whole number that a text is, `low`…`high`; None when it is none in this range."""
    digits = text.strip()
    if not (digits.isascii() and digits.isdigit()) or len(digits.lstrip("0")) > _MOST_DIGITS:
        return None
    number = int(digits)
    return number if low <= number <= high else None


def nearest_number(text: str, low: int, high: int) -> int | None:
    """The number in range that is nearest to the whole number that a text is; None when it is none."""
    digits = text.strip()
    return min(max(int(digits), low), high) if _WHOLE.fullmatch(digits) else None
