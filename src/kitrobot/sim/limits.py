"""Which numbers a run can be given: its time limit, its seed, the probability of failures."""

from __future__ import annotations

from kitrobot.sim.setup import SimulationError

MAX_SEED = 2**53
"""Larger whole numbers do not reach the page as they are."""

MAX_SECONDS = 1e9
"""The longest time limit of a run, in simulated seconds: thirty years."""


def check_limits(seconds: float | None, seed: int, fail_rate: float) -> None:
    """That a run can be given these numbers.

    Raises:
        SimulationError: one of them makes no sense; NaN never does.
    """
    if seconds is not None and not 0 < seconds <= MAX_SECONDS:
        raise SimulationError(
            f"expected a time limit of more than 0 and at most {MAX_SECONDS:.0f} seconds, found {seconds:g}",
            "the usual one is 600 seconds",
        )
    if not 0 <= seed <= MAX_SEED:
        # Python writes no number of very many digits.
        found = str(seed) if seed.bit_length() < 1000 else "one of very many digits"
        raise SimulationError(f"expected a seed from 0 to {MAX_SEED}, found {found}", "any small number will do")
    if not 0 <= fail_rate <= 1:
        raise SimulationError(
            f"expected a probability from 0 to 1 that a robot fails, found {fail_rate:g}",
            "0.1 lets one robot in ten fail within a minute",
        )
