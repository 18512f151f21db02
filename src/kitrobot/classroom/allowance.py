"""How often something may be done: allowances that fill up with time. Nothing here reads a clock; moments are given."""

from __future__ import annotations

from collections import OrderedDict
from typing import Final

MOST_KNOWN: Final = 1000
"""Addresses of which wrong guesses are remembered; who guesses from more of them is held by the sum of all."""


class Allowance:
    """At most `burst` at once, and `a_second` in the long run."""

    def __init__(self, a_second: float, burst: float) -> None:
        self._a_second = a_second
        self._burst = burst
        self._left = burst
        self._at: float | None = None

    def take(self, now: float) -> bool:
        """One of them; False when there is none now."""
        if self._left_at(now) < 1:
            return False
        self._left -= 1
        return True

    def has(self, now: float) -> bool:
        """Whether there is one now."""
        return self._left_at(now) >= 1

    def _left_at(self, now: float) -> float:
        if self._at is not None:
            self._left = min(self._burst, self._left + max(0.0, now - self._at) * self._a_second)
        self._at = now
        return self._left


class Guesses:
    """Wrong guesses: so many from one address, and so many in all, in a minute."""

    def __init__(self, of_one: int = 10, of_all: int = 120) -> None:
        self._of_one = of_one
        self._all = Allowance(of_all / 60, of_all)
        self._each: OrderedDict[str, Allowance] = OrderedDict()

    def may(self, who: str, now: float) -> bool:
        """Whether that address may guess now."""
        one = self._each.get(who)
        return self._all.has(now) and (one is None or one.has(now))

    def wrong(self, who: str, now: float) -> None:
        """It guessed wrong."""
        self._all.take(now)
        one = self._each.setdefault(who, Allowance(self._of_one / 60, self._of_one))
        self._each.move_to_end(who)
        one.take(now)
        while len(self._each) > MOST_KNOWN:
            self._each.popitem(last=False)
