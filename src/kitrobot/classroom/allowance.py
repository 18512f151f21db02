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


class Allowances:
    """An allowance for each of many, of whom those are forgotten that were there longest ago."""

    def __init__(self, a_second: float, burst: float) -> None:
        self._rate = (a_second, burst)
        self._each: OrderedDict[str, Allowance] = OrderedDict()

    def has(self, who: str, now: float) -> bool:
        """Whether there is one for them now."""
        one = self._each.get(who)
        return one is None or one.has(now)

    def take(self, who: str, now: float) -> bool:
        """One of theirs; False when there is none now."""
        one = self._each.setdefault(who, Allowance(*self._rate))
        self._each.move_to_end(who)
        while len(self._each) > MOST_KNOWN:
            self._each.popitem(last=False)
        return one.take(now)

    def clear(self) -> None:
        """Everybody begins anew."""
        self._each.clear()


class Guesses:
    """Wrong guesses in a minute: so many from one address, and so many in all.

    A class comes in from one address where it sits behind one. Once somebody has come in from an address, wrong guesses
    from elsewhere hold it up no more, and it has `of_class` of its own: those who mistype do not keep out the others.
    """

    def __init__(self, of_one: int = 10, of_all: int = 120, of_class: int = 120) -> None:
        self._all = Allowance(of_all / 60, of_all)
        self._each = Allowances(of_one / 60, of_one)
        self._of_class = Allowances(of_class / 60, of_class)
        self._in: OrderedDict[str, None] = OrderedDict()

    def may(self, who: str, now: float) -> bool:
        """Whether that address may guess now."""
        if who in self._in:
            return self._of_class.has(who, now)
        return self._all.has(now) and self._each.has(who, now)

    def right(self, who: str) -> None:
        """Somebody came in from there."""
        self._in[who] = None
        self._in.move_to_end(who)
        while len(self._in) > MOST_KNOWN:
            self._in.popitem(last=False)

    def wrong(self, who: str, now: float) -> None:
        """It guessed wrong."""
        if who in self._in:
            self._of_class.take(who, now)
        else:
            self._all.take(now)
            self._each.take(who, now)
