"""An interval for a share that holds after every run at once, whenever somebody breaks off.

It has the shares p for which the runs are not much less probable than with a share drawn from the beta distribution
with 1/2 and 1/2: their ratio is a martingale, which exceeds 1 / missing at any time with a probability of at most
`missing` (Ville 1939; Robbins 1970). It is wider than an interval for a number of runs that was planned.
"""

from __future__ import annotations

import math
from collections.abc import Callable

_HALF_LOG_BETA = math.log(math.pi)
"""The logarithm of B(1/2, 1/2)."""
_EXACT = 1e-9


def anytime_ends(successes: int, runs: int, missing: float) -> tuple[float, float]:
    """The ends of the interval after so many runs, at least one; at any time it misses at most so often (0 < … < 1)."""
    failures = runs - successes
    mixture = math.lgamma(successes + 0.5) + math.lgamma(failures + 0.5) - math.lgamma(runs + 1) - _HALF_LOG_BETA

    def is_out(share: float) -> bool:
        likelihood = successes * math.log(share) if successes else 0.0
        likelihood += failures * math.log1p(-share) if failures else 0.0
        return mixture - likelihood >= -math.log(missing)

    estimate = successes / runs
    low = _border(is_out, 0.0, estimate) if successes else 0.0
    high = _border(is_out, 1.0, estimate) if failures else 1.0
    return low, high


def _border(is_out: Callable[[float], bool], out: float, inside: float) -> float:
    """Where the interval ends between a share outside, which is given, and one inside."""
    while abs(inside - out) > _EXACT:
        middle = (out + inside) / 2
        out, inside = (middle, inside) if is_out(middle) else (out, middle)
    return out
