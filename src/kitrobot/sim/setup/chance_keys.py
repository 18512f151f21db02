"""The keys of all chance in a run, put into its tables before the first step, for one seed after another.

A part that draws no chance has the keys 0: of a robot without noise nearly all have, and a hash for each of them would
take as long as a short run.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from kitrobot.sim.step.agents import Agent
from kitrobot.sim.tables.columns import (
    A_DROPOUT,
    A_KEY_A,
    A_KEY_B,
    A_NOISE,
    ACTUATOR_INDEX,
    S_KEY_A,
    S_KEY_B,
    S_RESTLESS,
)
from kitrobot.sim.tables.random_numbers import keys
from kitrobot.sim.tables.state import State


class ChanceKeys:
    """Which parts of a run draw chance.

    Args:
        state: the tables, as they were set up.
        members: the agents.
        sensors: the number of each sensor by its agent's number and its name.
    """

    def __init__(self, state: State, members: Sequence[Agent], sensors: Mapping[tuple[int, str], int]) -> None:
        restless = state.sensors.ints[S_RESTLESS]
        noise, dropout = state.actuators.floats[A_NOISE], state.actuators.floats[A_DROPOUT]
        index, first = state.actuators.actuator_index, state.robots.ints[ACTUATOR_INDEX]
        self._sensors = [
            (k, agent.name, part.name)
            for agent in members
            for part in agent.robot.sensors
            if (k := sensors.get((agent.index, part.name))) is not None and restless[k]
        ]
        self._actuators = [
            (k, agent.name, part.name)
            for agent in members
            for at, part in enumerate(agent.robot.actuators)
            if noise[k := index[first[agent.index] + at]] > 0.0 or dropout[k] > 0.0
        ]
        self._names = [(agent.index, agent.name) for agent in members]

    def put(self, state: State, seed: int) -> None:
        """Puts the keys of that seed into the tables."""
        sensing, acting, fate, radio = state.sensors.ints, state.actuators.ints, state.faults.fate, state.radio.keys
        for k, agent, part in self._sensors:
            sensing[S_KEY_A][k], sensing[S_KEY_B][k] = keys(seed, agent, "sensor", part)
        for k, agent, part in self._actuators:
            acting[A_KEY_A][k], acting[A_KEY_B][k] = keys(seed, agent, "actuator", part)
        for word, table in (("failure", fate), ("radio", radio)):
            if len(table) and len(table[0]):
                for i, agent in self._names:
                    table[0][i], table[1][i] = keys(seed, agent, word)
