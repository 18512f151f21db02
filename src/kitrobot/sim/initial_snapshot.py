"""The state of a run before its first step, to go back to again and again."""

from __future__ import annotations

from typing import Any

from kitrobot.sim.jit.arrays import ArrayState
from kitrobot.sim.outcome import Outcome
from kitrobot.sim.step.probes import PROBES_OFF
from kitrobot.sim.tables.state import State
from kitrobot.sim.tables.state_codec import StateCodec


class InitialSnapshot:
    """A state that was kept. Once the tables are arrays, going back is one copy of their memory.

    Attributes:
        end: the outcome and the sentence of a run that is over before its first step; None and "" of any other.
    """

    def __init__(self, state: State, codec: StateCodec, end: tuple[Outcome | None, str]) -> None:
        self.end = end
        self._codec = codec
        self._bytes = codec.encode(state)
        self._memory: Any = None

    def put_back(self, state: State) -> None:
        """Makes the tables what they were, but for the keys of chance."""
        if isinstance(state, ArrayState) and self._memory is not None:
            state.memory[:] = self._memory
            return
        self._codec.decode(state, self._bytes)
        state.probes.count[0] = PROBES_OFF
        if isinstance(state, ArrayState):
            self._memory = state.memory.copy()
