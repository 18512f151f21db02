"""The keys of all chance in a run, put into its tables anew for another seed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from kitrobot.sim.step.agents import Agent
from kitrobot.sim.tables.columns import A_KEY_A, A_KEY_B, ACTUATOR_INDEX, S_KEY_A, S_KEY_B
from kitrobot.sim.tables.random_numbers import keys
from kitrobot.sim.tables.state import State


def put_chance_keys(state: State, members: Sequence[Agent], sensors: Mapping[tuple[int, str], int], seed: int) -> None:
    """Puts the keys of that seed into the tables of a run before its first step, as setting it up does.

    Args:
        state: the tables.
        members: the agents.
        sensors: the number of each sensor by its agent's number and its name.
        seed: where chance begins.
    """
    sensing, acting = state.sensors.ints, state.actuators.ints
    index, first = state.actuators.actuator_index, state.robots.ints[ACTUATOR_INDEX]
    fate, radio = state.faults.fate, state.radio.keys
    for agent in members:
        for part in agent.robot.sensors:
            k = sensors.get((agent.index, part.name))
            if k is not None:
                sensing[S_KEY_A][k], sensing[S_KEY_B][k] = keys(seed, agent.name, "sensor", part.name)
        for at, part in enumerate(agent.robot.actuators):
            k = index[first[agent.index] + at]
            acting[A_KEY_A][k], acting[A_KEY_B][k] = keys(seed, agent.name, "actuator", part.name)
        if len(fate[0]):
            fate[0][agent.index], fate[1][agent.index] = keys(seed, agent.name, "failure")
        if len(radio) and len(radio[0]):
            radio[0][agent.index], radio[1][agent.index] = keys(seed, agent.name, "radio")
