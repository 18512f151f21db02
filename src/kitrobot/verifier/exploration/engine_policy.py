"""When an exploration is worth the compiled engine: how much this process has explored with the plain one."""

from __future__ import annotations

from dataclasses import dataclass

from kitrobot.sim.jit.cache import is_missed
from kitrobot.verifier.exploration.engines import Engine
from kitrobot.verifier.exploration.numba_engine import engine

WORTH_STATES, WORTH_S = 50_000, 5.0
"""The compiled functions are made after so many states, or seconds, of plain exploration in this process."""
LOADED_S = 1.0
"""Seconds after which they are loaded if this machine has them in its cache."""


@dataclass
class PlainWork:
    """The states explored by the plain engine, and the seconds that it took."""

    states: int = 0
    seconds: float = 0.0


plain_work = PlainWork()
"""The finished plain explorations of this process."""


def would_gain(states: int) -> bool:
    """Whether exploring so many states would have been much faster with Numba installed."""
    return states >= WORTH_STATES and is_missed()


def choose_engine(states: int, seconds: float) -> Engine | None:
    """The compiled engine, if it is available and worth it; None otherwise.

    It is worth it after enough states or seconds of plain exploration, earlier ones (`plain_work`) included.
    """
    states, seconds = plain_work.states + states, plain_work.seconds + seconds
    if states < WORTH_STATES and seconds < LOADED_S:
        return None
    if states >= WORTH_STATES or seconds >= WORTH_S or engine.is_kept():
        engine.ask()
    return engine.made
