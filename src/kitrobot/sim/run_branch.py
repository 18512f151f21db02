"""Branches of a run: going on from a state that it was in, with other chance from there on.

All chance of a run is drawn by counting (`random_numbers`), so with other keys what is yet to come is drawn anew, and
what has happened stays: a branch is distributed as the run is, given what has happened. That is so where each draw is
for one moment; a sensor that keeps a draw for a while (`Chance`) would draw it anew in the middle.
"""

from __future__ import annotations

from kitrobot.primitives.robot import Category
from kitrobot.sim.devices.chance import Chance
from kitrobot.sim.setup.settings import simulated_devices
from kitrobot.sim.simulation import Simulation


def branch_run(run: Simulation, snapshot: bytes, seed: int) -> None:
    """Lets a run go on from a snapshot of it, with the chance of another seed.

    Raises:
        SimulationError: the bytes are damaged, or of another run; then nothing was changed.
    """
    run.restore(snapshot)
    run._chance.put(run.state, seed)


def lasting_draws(run: Simulation) -> list[tuple[str, str]]:
    """The agents and sensors that keep a draw of chance for a while."""
    devices = simulated_devices(Category.SENSOR)
    return [
        (agent.name, part.name)
        for agent in run.members
        for part in agent.robot.sensors
        if (agent.index, part.name) in run._sensors and devices.get(part.model) is Chance
    ]
