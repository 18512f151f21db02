"""Agents in Mesa's continuous space, as many as our robots: each looks for its neighbours, turns away, and goes on.

Kind to Mesa: its newer, vectorised space; no walls, no collisions, no program, one query of 200 mm in place of three
rays of 1000 mm, no random order of agents.
"""

from __future__ import annotations

import math
from importlib.metadata import version

import mesa
import numpy as np
from mesa.experimental.continuous_space import ContinuousSpace, ContinuousSpaceAgent

NAME = f"Mesa {version('mesa')}"
_NEAR_MM = 200.0
_WAY_MM = 2.4


class _Rover(ContinuousSpaceAgent):
    def __init__(self, space: ContinuousSpace, model: mesa.Model, place: tuple[float, float], heading: float) -> None:
        super().__init__(space, model)
        self.position = np.array(place)
        self.heading = heading

    def step(self) -> None:
        near, _ = self.get_neighbors_in_radius(radius=_NEAR_MM)
        if near:
            self.heading += 0.04
        way = np.array((_WAY_MM * math.cos(self.heading), _WAY_MM * math.sin(self.heading)))
        self.position = np.clip(self.position + way, 0.0, self.space.dimensions[:, 1] - 1e-6)


class Rovers(mesa.Model):
    """So many agents, 400 mm apart."""

    def __init__(self, robots: int, spacing: float) -> None:
        super().__init__(seed=1)
        side = math.ceil(math.sqrt(robots))
        size = (side + 1) * spacing
        space = ContinuousSpace([[0, size], [0, size]], torus=False, random=self.random, n_agents=robots)
        for n in range(robots):
            place = ((n % side + 1) * spacing, (n // side + 1) * spacing)
            _Rover(space, self, place, self.random.uniform(-math.pi, math.pi))

    def go(self, steps: int) -> None:
        """So many steps of all agents."""
        for _ in range(steps):
            self.agents.do("step")


class RoversInBatch(Rovers):
    """The same as Mesa's batch runner takes them: seeded by a parameter, and a mean that is collected."""

    def __init__(self, robots: int, spacing: float, run: int) -> None:
        super().__init__(robots, spacing)
        self.random.seed(run)
        self.datacollector = mesa.DataCollector(
            model_reporters={"x": lambda model: float(np.mean([agent.position[0] for agent in model.agents]))}
        )

    def step(self) -> None:
        self.go(1)
        self.datacollector.collect(self)


def batch(robots: int, spacing: float, seeds: int, steps: int) -> int:
    """So many runs through `batch_run`, in this process; how many rows came of them."""
    parameters = {"robots": robots, "spacing": spacing, "run": range(seeds)}
    found = mesa.batch_run(
        RoversInBatch, parameters, max_steps=steps - 1, data_collection_period=-1, display_progress=False
    )
    return len(found)
