"""Rate limits, as token buckets that fill up with time. Nothing here reads a clock: the caller passes the time."""

from __future__ import annotations

from collections import OrderedDict
from typing import Final

MOST_KNOWN: Final = 1000
"""Addresses whose wrong guesses are counted; guesses from more of them are limited by the total."""


class RateLimit:
    """A token bucket: at most `burst` tokens at once, refilled with `a_second` tokens a second."""

    def __init__(self, a_second: float, burst: float) -> None:
        self._a_second = a_second
        self._burst = burst
        self._left = burst
        self._at: float | None = None

    def take(self, now: float) -> bool:
        """Takes one token; False when there is none. `now`: seconds."""
        if self._left_at(now) < 1:
            return False
        self._left -= 1
        return True

    def has(self, now: float) -> bool:
        """Whether there is a token. `now`: seconds."""
        return self._left_at(now) >= 1

    def _left_at(self, now: float) -> float:
        if self._at is not None:
            self._left = min(self._burst, self._left + max(0.0, now - self._at) * self._a_second)
        self._at = now
        return self._left


class RateLimits:
    """A rate limit for each key; the least recently used keys are dropped."""

    def __init__(self, a_second: float, burst: float) -> None:
        self._rate = (a_second, burst)
        self._each: OrderedDict[str, RateLimit] = OrderedDict()

    def has(self, who: str, now: float) -> bool:
        """Whether there is a token for that key."""
        one = self._each.get(who)
        return one is None or one.has(now)

    def take(self, who: str, now: float) -> bool:
        """Takes a token of that key; False when there is none."""
        one = self._each.setdefault(who, RateLimit(*self._rate))
        self._each.move_to_end(who)
        while len(self._each) > MOST_KNOWN:
            self._each.popitem(last=False)
        return one.take(now)

    def clear(self) -> None:
        """Resets all limits."""
        self._each.clear()


class GuessLimit:
    """Wrong guesses in a minute: so many from one address, and so many in all.

    A class comes in from one address where it sits behind one. Once somebody has come in from an address, wrong guesses
    from elsewhere hold it up no more, and it has `of_class` of its own: those who mistype do not keep out the others.
    """

    def __init__(self, of_one: int = 10, of_all: int = 120, of_class: int = 120) -> None:
        self._all = RateLimit(of_all / 60, of_all)
        self._each = RateLimits(of_one / 60, of_one)
        self._of_class = RateLimits(of_class / 60, of_class)
        self._in: OrderedDict[str, None] = OrderedDict()

    def is_allowed(self, who: str, now: float) -> bool:
        """Whether a guess from that address is allowed now."""
        if who in self._in:
            return self._of_class.has(who, now)
        return self._all.has(now) and self._each.has(who, now)

    def record_success(self, who: str) -> None:
        """Records that somebody was let in from that address."""
        self._in[who] = None
        self._in.move_to_end(who)
        while len(self._in) > MOST_KNOWN:
            self._in.popitem(last=False)

    def record_failure(self, who: str, now: float) -> None:
        """Records a wrong guess from that address."""
        if who in self._in:
            self._of_class.take(who, now)
        else:
            self._all.take(now)
            self._each.take(who, now)
