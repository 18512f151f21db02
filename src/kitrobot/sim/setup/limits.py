"""Limits of a run: its agents, its time, its seed, the probability of failures; and values put into it."""

from __future__ import annotations

from operator import index

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence

MAX_AGENTS = 100_000
"""Agents in one run at most."""

MAX_SEED = 2**53
"""Larger whole numbers do not reach the page as they are."""

MAX_SECONDS = 1e9
"""The longest time limit of a run, in simulated seconds: thirty years."""


class SimulationError(KitRobotError):
    """A mission cannot be run in its world; `diagnostics` says everything that is in the way."""


def whole_number(value: int) -> int:
    """A value that somebody puts into a run, as an `int`; NumPy's whole numbers are taken too.

    Raises:
        KitRobotError: it is none.
    """
    try:
        return index(value)
    except TypeError:
        message = Sentence("expected a whole number, found `{found}`", str(value))
        raise KitRobotError(message, Sentence("round it first, as in `round(20.5)`")) from None


def check_limits(seconds: float | None, seed: int, fail_rate: float) -> None:
    """That a run can be given these numbers.

    Raises:
        SimulationError: one of them makes no sense; NaN never does.
        KitRobotError: the seed is no whole number.
    """
    if seconds is not None and not 0 < seconds <= MAX_SECONDS:
        raise SimulationError(
            Sentence(
                "expected a time limit of more than 0 and at most {most} seconds, found {found}",
                f"{MAX_SECONDS:.0f}",
                f"{seconds:g}",
            ),
            Sentence("the usual one is 600 seconds"),
        )
    seed = whole_number(seed)
    if not 0 <= seed <= MAX_SEED:
        # Python writes no number of very many digits.
        found = str(seed) if seed.bit_length() < 1000 else Sentence("one of very many digits")
        raise SimulationError(
            Sentence("expected a seed from 0 to {most}, found {found}", MAX_SEED, found),
            Sentence("any small number will do"),
        )
    if not 0 <= fail_rate <= 1:
        raise SimulationError(
            Sentence("expected a probability from 0 to 1 that a robot fails, found {found}", f"{fail_rate:g}"),
            Sentence("0.1 lets one robot in ten fail within a minute"),
        )
